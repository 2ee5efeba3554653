// SPDX-License-Identifier: MIT
// A square moves to the right by algorithm 5.1 of the thesis. The module's page shows it.
#include <dsc/dsc.h>
#include <dsc/thesis/thesis.h>

#include <algorithm>
#include <iostream>

int main() {
    const std::vector<dsc::Shape> shapes{{{{0.2, 0.3}, {0.6, 0.3}, {0.6, 0.7}, {0.2, 0.7}}, 1}};
    auto complex = dsc::initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.05});
    const dsc::Options<double> options{.edge_length = 0.05,
                                       .custom_integrator = dsc::centred_difference<double>()};
    dsc::Simulation<double> simulation(
        complex, options, dsc::make_executor(complex, options, {}, dsc::thesis_algorithm(options)));
    const dsc::Velocity<double> to_the_right = [](auto, double, auto velocities) {
        std::ranges::fill(velocities, dsc::Point<double>(1, 0));
    };
    const std::uint64_t unreached = simulation.step(to_the_right, 0, 0.2).unreached;
    const dsc::SimplexSet interface = dsc::interface_of(complex);
    std::cout << interface.edges().size() << " interface edges, "
              << dsc::star(complex, interface).triangles().size() << " triangles around them\n";
    return unreached == 0 && dsc::validate(complex).ok() ? 0 : 1;
}
