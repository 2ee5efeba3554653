#include <dsc/dsc3/dsc3.h>

#include <cmath>
#include <iostream>
#include <numbers>

// A ball is drawn out by a flow that turns back half-way, and comes back as a ball.
int main() {
    const double h = 1.0 / 16; // edge length of the interface
    const auto ball = dsc3::ball({0.35, 0.35, 0.35}, 0.15);
    auto complex = dsc3::initial_complex({}, {{ball, 1}}, {.edge_length = h});
    auto& start = complex.attributes.add<dsc3::Vertex>("start", 0.0); // x, at the beginning
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        start[dsc3::Vertex{v}] = complex.at(v).x();
    }
    const dsc3::Velocity swirl = [](auto positions, double time, auto velocities) {
        const double factor = std::cos(std::numbers::pi * time);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const dsc3::Point p = std::numbers::pi * positions[i];
            const dsc3::Point s = p.array().sin(), d = (2 * p).array().sin();
            velocities[i] = factor * dsc3::Point(2 * s.x() * s.x() * d.y() * d.z(),
                                                 -d.x() * s.y() * s.y() * d.z(),
                                                 -d.x() * d.y() * s.z() * s.z());
        }
    };
    dsc3::Simulation simulation(complex, {.edge_length = h});
    std::uint64_t unreached = 0;
    for (int step = 0; step < 20; ++step) {
        unreached += simulation.step(swirl, 0.05 * step, 0.05).unreached;
        if (step == 9) {
            dsc3::write_stl(complex, "half-way.stl");
        }
    }
    double farthest = 0;
    for (const std::uint32_t v : simulation.interface()) {
        farthest = std::max(farthest, std::abs(start[dsc3::Vertex{v}] - complex.at(v).x()));
    }
    std::cout << complex.tet_count() << " tets, volume " << dsc3::phase_volume(complex, 1)
              << ", x off by " << farthest / h << " h at most, unreached " << unreached << '\n';
    return unreached == 0 && dsc3::validate(complex).ok() ? 0 : 1;
}
