// SPDX-License-Identifier: MIT
// A disc grows, and moves by its curvature. The module's page shows it.
#include <dsc/engine.h>
#include <dsc/geometric_flows/geometric_flows.h>

#include <cmath>
#include <iostream>
#include <numbers>

int main() {
    std::vector<dsc::Point<double>> disc;
    for (int i = 0; i < 64; ++i) {
        const double angle = std::numbers::pi * i / 32;
        disc.emplace_back(0.5 + 0.2 * std::cos(angle), 0.5 + 0.2 * std::sin(angle));
    }
    auto complex = dsc::initial_complex<double>(
        {{0, 0}, {1, 1}}, std::vector<dsc::Shape>{{disc, 1}}, {.edge_length = 0.04});
    const dsc::Options<double> options{.edge_length = 0.04};
    // Phase 1 grows into phase 0, then its interface moves by its curvature, at a constant area.
    const dsc::GrowthOptions<double> speeds{.speeds = {{1, 0, 1.0}}};
    dsc::Simulation<double> simulation(
        complex, options,
        dsc::make_executor(complex, options, {}, dsc::growth_algorithm(complex, speeds)));
    const std::uint64_t unreached = simulation.step(dsc::growth(speeds), 0, 0.1).unreached;
    const double area = dsc::phase_area(complex, 1);
    simulation.step(dsc::curvature_flow<double>({.kept_areas = {{1, area}}}), 0.1, 0.01);
    std::cout << "area " << area << ", then " << dsc::phase_area(complex, 1) << '\n';
    return unreached == 0 && std::abs(dsc::phase_area(complex, 1) - area) < 1e-9 ? 0 : 1;
}
