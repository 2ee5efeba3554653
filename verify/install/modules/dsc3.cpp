#include <dsc/dsc3/dsc3.h>

#include <iostream>

int main() {
    const double h = 0.05; // edge length of the interface
    auto complex = dsc3::initial_complex({}, {{dsc3::ball({0.4, 0.4, 0.4}, 0.2), 1}}, {.edge_length = h});
    const double volume = dsc3::phase_volume(complex, 1);
    dsc3::Simulation simulation(complex, {.edge_length = h});
    const dsc3::Velocity shear = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {positions[i].z() - 0.4, 0, 0};
        }
    };
    std::uint64_t unreached = 0;
    for (int step = 0; step < 10; ++step) {
        unreached += simulation.step(shear, 0.1 * step, 0.1).unreached;
    }
    std::cout << complex.tet_count() << " tets, volume of the ball " << dsc3::phase_volume(complex, 1) / volume
              << " of what it was, unreached " << unreached << '\n';
    return unreached == 0 && dsc3::validate(complex).ok() ? 0 : 1;
}
