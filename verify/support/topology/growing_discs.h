// SPDX-License-Identifier: MIT
// Two discs that grow into each other: where the topology changes, they merge or meet.
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
#include <vector>

namespace dsc::test::growing_discs {

inline constexpr double h = 0.02;

/// Two discs of radius 0.1, 0.05 apart, the second of phase `second`.
inline Complex<double> discs_nearby(Phase second = 1) {
    const std::vector<Shape> shapes{{circle_points({0.375, 0.5}, 0.1, 45), 1},
                                    {circle_points({0.625, 0.5}, 0.1, 45), second}};
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

/// Each disc grows about its own centre at speed 1.
inline Velocity<double> grow() {
    return test::pointwise([](const Point<double>& p) {
        const Point<double> centre(p.x() < 0.5 ? 0.375 : 0.625, 0.5);
        return Point<double>((p - centre).normalized());
    });
}

inline test::ChangingOptions<double> options(Topology rule = Topology::change) {
    test::ChangingOptions<double> result;
    result.edge_length = h;
    result.topology.rule = rule;
    return result;
}

struct Grown {
    std::vector<Event> events;
    std::size_t outlines = 0;
    double area = 0;
    std::uint64_t hash = 0;
};

inline Grown run(Complex<double>& complex, test::ChangingSimulation<double>& simulation,
                 double duration = 0.05) {
    Grown grown;
    constexpr double dt = 0.3 * h;
    for (double time = 0; time < duration; time += dt) {
        const test::ChangingReport report = simulation.step(grow(), time, dt);
        grown.events.insert(grown.events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "");
    }
    grown.outlines = outlines(complex, 1).size();
    grown.area = phase_area(complex, 1);
    grown.hash = mesh_hash(complex);
    return grown;
}

inline std::size_t count(const std::vector<Event>& events, EventKind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

} // namespace dsc::test::growing_discs
