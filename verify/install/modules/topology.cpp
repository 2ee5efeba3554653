// SPDX-License-Identifier: MIT
// Two discs that grow until they are one.
#include <dsc/dsc.h>
#include <dsc/topology/topology.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

int main() {
    std::vector<dsc::Shape> discs;
    for (const double x : {0.35, 0.65}) {
        std::vector<dsc::Point<double>> disc;
        for (int i = 0; i < 64; ++i) {
            const double angle = std::numbers::pi * i / 32;
            disc.emplace_back(x + 0.13 * std::cos(angle), 0.5 + 0.13 * std::sin(angle));
        }
        discs.push_back({disc, 1});
    }
    auto complex = dsc::initial_complex<double>({{0, 0}, {1, 1}}, discs, {.edge_length = 0.03});
    dsc::Simulation<double> simulation(complex, {.edge_length = 0.03});
    const auto topology = std::make_shared<dsc::TopologyStage<double>>(
        dsc::TopologyOptions<double>{.rule = dsc::Topology::change});
    simulation.add_stage(topology);
    // Both discs grow, each about its own centre.
    const dsc::Velocity<double> grow = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const dsc::Point<double> centre(positions[i].x() < 0.5 ? 0.35 : 0.65, 0.5);
            velocities[i] = (positions[i] - centre).normalized();
        }
    };
    for (int step = 0; step < 10; ++step) {
        simulation.step(grow, 0.005 * step, 0.005);
    }
    int merged = 0;
    for (const dsc::Event& event : topology->take_events()) {
        std::cout << to_string(event.kind) << " at time " << event.time << '\n';
        merged += event.kind == dsc::EventKind::merge ? 1 : 0;
    }
    return merged == 1 && dsc::outlines(complex, 1).size() == 1 ? 0 : 1;
}
