// SPDX-License-Identifier: MIT
// Junctions: four sectors come apart as the energy wants it, or stay together. How fast they do is
// tested by the scene t1, and how a network of grains coarsens in grains_test.cpp.
#include "topology/junctions/junctions.h"

#include "support/topology/changing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace dsc::junctions_test {
namespace {

using P = Point<double>;

// Sectors 1 (right), 2 (above), 3 (left) and 4 (below) meet at the origin; rays at +-`degrees` from
// the x axis bound 1 and 3. Square cells, each cut along both diagonals, with y scaled, so that the
// rays run along edges.
Complex<double> four_sectors(double degrees, double h) {
    const double scale = std::tan(degrees * std::numbers::pi / 180);
    const auto half = static_cast<int>(0.5 / (1.2 * h));
    const int n = 2 * half;
    const double size = 0.5 / half;
    std::vector<P> points;
    std::vector<std::array<std::uint32_t, 3>> cells;
    std::vector<Phase> phases;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) {
            points.emplace_back((x - half) * size, (y - half) * size * scale);
        }
    }
    const auto corner = [&](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const auto centre = static_cast<std::uint32_t>(points.size());
            points.emplace_back((x - half + 0.5) * size, (y - half + 0.5) * size * scale);
            const std::array<std::uint32_t, 4> around{corner(x, y), corner(x + 1, y),
                                                      corner(x + 1, y + 1), corner(x, y + 1)};
            for (std::size_t k = 0; k < 4; ++k) {
                cells.push_back({around[k], around[(k + 1) % 4], centre});
                const P p = (points[around[k]] + points[around[(k + 1) % 4]] + points[centre]) / 3;
                const bool is_beside = std::abs(p.y()) < std::abs(p.x()) * scale;
                phases.push_back(is_beside ? (p.x() > 0 ? 1U : 3U) : (p.y() > 0 ? 2U : 4U));
            }
        }
    }
    return make_complex<double>(points, cells, phases);
}

// Interface edges at each inner vertex with more than two; the places of these vertices.
std::vector<P> junctions(const Complex<double>& complex, std::size_t edges) {
    std::vector<P> found;
    for (const Vertex v : vertices(complex)) {
        std::size_t count = 0;
        bool is_inside = true;
        for_each_corner(complex, v, [&](Corner c) {
            const Corner across = complex.twin(prev(c));
            is_inside = is_inside && !is_border(across) && !is_border(complex.twin(next(c)));
            count += complex.phase_at(across) != complex.phase_at(c) ? 1U : 0U;
        });
        if (is_inside && count == edges) {
            found.push_back(complex.position(v));
        }
    }
    return found;
}

test::ChangingOptions<double> options(double h) {
    test::ChangingOptions<double> result;
    result.edge_length = h;
    result.topology.rule = Topology::change;
    result.interface.corner_degrees = 180; // curvature flow knows no corners
    return result;
}

std::vector<Event> run(test::ChangingSimulation<double>& simulation, Complex<double>& complex,
                       double dt, int steps) {
    const InterfaceMotion<double> motion = curvature_flow<double>();
    std::vector<Event> events;
    for (int step = 0; step < steps; ++step) {
        const test::ChangingReport report = simulation.step(motion, step * dt, dt);
        events.insert(events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "");
    }
    return events;
}

TEST(Junctions, TheEnergyDecidesWhichSectorsPart) {
    constexpr double h = 0.02;
    for (const bool is_dear : {false, true}) {
        auto complex = four_sectors(40, h);
        test::ChangingOptions<double> dear = options(h);
        if (is_dear) { // an interface between 2 and 4
            dear.topology.energy = [](Phase one, Phase other) {
                return one + other == 6 && one != other ? 5.0 : 1.0;
            };
        }
        test::ChangingSimulation<double> simulation(complex, dear);
        const std::vector<Event> events = run(simulation, complex, 1e-6, 3);
        ASSERT_GE(events.size(), 1U);
        const std::set<Phase> taken{events[0].taken[0], events[0].taken[1]};
        EXPECT_EQ(taken, is_dear ? (std::set<Phase>{1, 3}) : (std::set<Phase>{2, 4}));
    }
}

TEST(Junctions, ANegativeEnergyIsRefused) {
    auto complex = four_sectors(40, 0.02);
    test::ChangingOptions<double> bad = options(0.02);
    bad.topology.energy = [](Phase, Phase) { return -1.0; };
    test::ChangingSimulation<double> simulation(complex, bad);
    EXPECT_THROW((void)run(simulation, complex, 1e-6, 3), InputError);
    EXPECT_EQ(validate(complex).problem, "");
}

TEST(Junctions, FourSectorsStayTogetherWhereTheTopologyIsKept) {
    auto complex = four_sectors(40, 0.02);
    test::ChangingOptions<double> keeping = options(0.02);
    keeping.topology.rule = Topology::keep;
    test::ChangingSimulation<double> simulation(complex, keeping);
    EXPECT_TRUE(run(simulation, complex, 1e-5, 5).empty());
    EXPECT_EQ(junctions(complex, 4).size(), 1U);
}

} // namespace
} // namespace dsc::junctions_test
