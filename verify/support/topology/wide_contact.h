// SPDX-License-Identifier: MIT
// Scenes in which films open at a contact distance of several edge lengths.
#pragma once

#include "support/random/scene.h"
#include "support/topology/changing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::test {

using Events = std::vector<Event>;

inline test::ChangingOptions<double> wide_options(double contact, double edge_length) {
    test::ChangingOptions<double> result;
    result.edge_length = edge_length;
    result.topology.rule = Topology::change;
    result.topology.contact = contact;
    return result;
}

/// Two discs of radius 0.1, `gap` apart, side by side in the middle of the unit square.
inline Complex<double> two_discs_apart(double gap, double edge_length, Phase second = 1) {
    const int n = static_cast<int>(std::ceil(0.2 * std::numbers::pi / edge_length));
    const std::vector<Shape> shapes{{circle_points({0.4 - gap / 2, 0.5}, 0.1, n), 1},
                                    {circle_points({0.6 + gap / 2, 0.5}, 0.1, n), second}};
    return initial_complex<double>({}, shapes, {.edge_length = edge_length});
}

/// The velocity at one place.
template <class At>
Velocity<double> velocity_of(At at) {
    return [at](std::span<const Point<double>> positions, double,
                std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = at(positions[i]);
        }
    };
}

/// Each disc grows about its own centre, or shrinks.
inline Velocity<double> grow_apart(double gap, double speed = 1) {
    return velocity_of([=](const Point<double>& p) {
        const double side = p.x() < 0.5 ? -1 : 1;
        const Point<double> centre(0.5 + side * (0.1 + gap / 2), 0.5);
        return Point<double>(speed * (p - centre).normalized());
    });
}

/// The number of pieces of a phase.
inline std::ptrdiff_t pieces(const Complex<double>& complex, Phase phase) {
    const Components all = components(complex);
    return std::ranges::count(all.list, phase, &Component::phase);
}

inline std::size_t count(const Events& events, EventKind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

/// Steps on, with `after(events of the step)` after each, and returns all events. The complex is
/// validated after every step.
template <class After>
Events run_on(Complex<double>& complex, test::ChangingSimulation<double>& simulation,
              const Velocity<double>& velocity, double dt, int steps, After after) {
    Events events;
    for (int step = 0; step < steps; ++step) {
        const test::ChangingReport report = simulation.step(velocity, step * dt, dt);
        events.insert(events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "") << "step " << step;
        after(report.events);
    }
    return events;
}
inline Events run_on(Complex<double>& complex, test::ChangingSimulation<double>& simulation,
                     const Velocity<double>& velocity, double dt, int steps) {
    return run_on(complex, simulation, velocity, dt, steps, [](const Events&) {});
}

} // namespace dsc::test
