// SPDX-License-Identifier: MIT
#include "fronts/johnson_mehl.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/growth.h"
#include "geometric_flows/growth_features.h"
#include "measures/mesh_quality.h"
#include "replay/replay.h"
#include "shapes/shapes.h"
#include "topology/stage.h"

#include <algorithm>
#include <chrono>

namespace dsc::fronts {

using scenes::GrowingDiscs;

namespace {

constexpr double latest = 1.5; // any front has crossed the square by then
} // namespace

Complex<double> first_complex(const GrowingDiscs& discs, double h) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        shapes.push_back(
            {scenes::circle(discs.centres[i], discs.radii[i], h), static_cast<Phase>(i + 1)});
    }
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

Result run(const Case& one) {
    const GrowingDiscs discs = scenes::random_discs(one.number, one.seed);
    GrowthOptions<double> growing;
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        growing.speeds.push_back({static_cast<Phase>(i + 1), exterior_phase, 1.0});
    }
    Complex<double> complex = first_complex(discs, one.h);
    Options<double> options;
    options.edge_length = one.h;
    const Algorithm<double> algorithm = growth_algorithm(complex, growing);
    Simulation<double> simulation(
        complex, options,
        make_executor(complex, options, Parallel{.threads = one.threads}, algorithm));
    const auto topology = std::make_shared<TopologyStage<double>>(
        TopologyOptions<double>{.rule = Topology::change, .contact = one.contact * one.h});
    simulation.add_stage(topology);
    const InterfaceFlow<double> flow = growth(growing);
    Result result;
    result.min_angle_ever = 60;
    const double dt = one.step * one.h;
    for (int step = 0; step * dt < latest && !result.is_full; ++step) {
        const auto begin = std::chrono::steady_clock::now();
        result.unreached += simulation.step(flow, step * dt, dt).unreached;
        result.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        for (const Event& event : topology->take_events()) {
            ++result.events[std::string(to_string(event.kind))];
        }
        result.time = (step + 1) * dt;
        result.min_angle_last = scenes::measure_quality(complex).min_angle_deg;
        result.min_angle_ever = std::min(result.min_angle_ever, result.min_angle_last);
        result.is_full = std::ranges::none_of(
            triangles(complex), [&](Triangle t) { return complex.phase(t) == exterior_phase; });
    }
    result.last = scenes::diagram_error(complex, discs, result.time);
    result.is_valid = validate(complex).ok();
    result.mesh_hash = mesh_hash(complex);
    return result;
}

} // namespace dsc::fronts
