// SPDX-License-Identifier: MIT
#include <dsc/dsc.h>
#include <dsc/replay/replay.h>

#include <iostream>
#include <span>
#include <vector>

int main() {
    const dsc::Shape square{{{0.3, 0.3}, {0.5, 0.3}, {0.5, 0.5}, {0.3, 0.5}}, 1};
    auto complex = dsc::initial_complex<double>({{0, 0}, {1, 1}}, {square}, {.edge_length = 0.05});
    dsc::Complex<double> again = complex;
    dsc::Simulation<double> simulation(complex, {.edge_length = 0.05});
    std::vector<dsc::Edit> edits;
    simulation.add_listener([&](std::span<const dsc::Edit> some) {
        edits.insert(edits.end(), some.begin(), some.end());
    });
    const dsc::Velocity<double> velocity = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {1, 0.5};
        }
    };
    for (int step = 0; step < 10; ++step) {
        simulation.step(velocity, 0.02 * step, 0.02);
    }
    const dsc::ReplayReport report = dsc::replay<double>(again, edits);
    std::cout << report.done << " edits repeated, " << report.skipped << " skipped; "
              << dsc::mesh_hash(complex) << '\n';
    return dsc::mesh_hash(again) == dsc::mesh_hash(complex) ? 0 : 1;
}
