// SPDX-License-Identifier: MIT
// Two discs that grow into each other: if the topology may change, they merge or meet.
#pragma once

#include "support/pointwise.h"
#include "support/random/scene.h"
#include "support/topology/changing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace dsc::test::growing_discs {

inline constexpr double h = 0.02;

/// Two discs of radius 0.1, `gap` apart, side by side in the middle of the unit square; edges of
/// their outlines are at most `outline_edge` long.
inline Complex<double> discs_apart(double gap, double edge_length, Phase second,
                                   double outline_edge) {
    const int n = static_cast<int>(std::ceil(0.2 * std::numbers::pi / outline_edge));
    const std::vector<Shape> shapes{{circle_points({0.4 - gap / 2, 0.5}, 0.1, n), 1},
                                    {circle_points({0.6 + gap / 2, 0.5}, 0.1, n), second}};
    return initial_complex<double>({}, shapes, {.edge_length = edge_length});
}

inline Complex<double> discs_apart(double gap, double edge_length = h, Phase second = 1) {
    return discs_apart(gap, edge_length, second, edge_length);
}

inline constexpr double nearby = 0.05;
inline Complex<double> discs_nearby(Phase second = 1) {
    return discs_apart(nearby, h, second, 0.7 * h);
}

/// Each disc grows about its own centre, or shrinks.
inline Velocity<double> grow(double gap = nearby, double speed = 1) {
    return test::pointwise([=](const Point<double>& p) {
        const Point<double> centre(0.5 + (p.x() < 0.5 ? -1 : 1) * (0.1 + gap / 2), 0.5);
        return Point<double>(speed * (p - centre).normalized());
    });
}

inline test::ChangingOptions<double> options(Topology rule = Topology::change) {
    test::ChangingOptions<double> result;
    result.edge_length = h;
    result.topology.rule = rule;
    return result;
}

/// The options with a contact distance at which films open.
inline test::ChangingOptions<double> wide(double contact, double edge_length = h) {
    test::ChangingOptions<double> result = options();
    result.edge_length = edge_length;
    result.topology.contact = contact;
    return result;
}

/// Makes further steps, with `after(events of the step)` after each, and returns all events.
/// Validates the complex after every step.
inline std::vector<Event> run_on(
    Complex<double>& complex, test::ChangingSimulation<double>& simulation,
    const Velocity<double>& velocity, double dt, int steps,
    const std::function<void(const std::vector<Event>&)>& after = [](const auto&) {}) {
    std::vector<Event> events;
    for (int step = 0; step < steps; ++step) {
        const test::ChangingReport report = simulation.step(velocity, step * dt, dt);
        events.insert(events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "") << "step " << step;
        after(report.events);
    }
    return events;
}

struct Grown {
    std::vector<Event> events;
    std::size_t outlines = 0;
    std::uint64_t hash = 0;
};

inline constexpr double step_dt = 0.3 * h;

inline Grown run(Complex<double>& complex, test::ChangingSimulation<double>& simulation,
                 double duration = 0.05) {
    Grown grown;
    const int steps = static_cast<int>(std::ceil(duration / step_dt));
    grown.events = run_on(complex, simulation, grow(), step_dt, steps);
    grown.outlines = outlines(complex, 1).size();
    grown.hash = mesh_hash(complex);
    return grown;
}

/// The number of pieces of a phase.
inline std::ptrdiff_t pieces(const Complex<double>& complex, Phase phase) {
    const Components all = components(complex);
    return std::ranges::count(all.list, phase, &Component::phase);
}

inline std::size_t count(const std::vector<Event>& events, EventKind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

} // namespace dsc::test::growing_discs
