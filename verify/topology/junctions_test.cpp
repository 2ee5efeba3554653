// SPDX-License-Identifier: MIT
// Junctions: four sectors come apart as the energy wants it, short edges exchange their neighbours,
// and a network of grains coarsens by itself.
#include "dsc/topology/junctions/junctions.h"

#include "support/random/scene.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/motion/curvature_flow.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/hash.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace dsc::junctions_test {
namespace {

using P = Point<double>;

P middle_of(const Complex<double>& complex, Triangle t) {
    const auto [a, b, c] = complex.vertices_of(t);
    return (complex.position(a) + complex.position(b) + complex.position(c)) / 3;
}

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

Options<double> options(double h) {
    Options<double> result;
    result.edge_length = h;
    result.topology.rule = Topology::change;
    result.interface.corner_degrees = 180; // curvature flow knows no corners
    return result;
}

struct Ran {
    std::vector<Event> events;
    std::uint64_t unreached = 0;
};

Ran run(Simulation<double>& simulation, Complex<double>& complex, double dt, int steps) {
    const InterfaceMotion<double> motion = curvature_flow<double>();
    Ran ran;
    for (int step = 0; step < steps; ++step) {
        const StepReport report = simulation.step(motion, step * dt, dt);
        ran.unreached += report.unreached;
        ran.events.insert(ran.events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "");
    }
    return ran;
}

// A new edge of length c sqrt(t) opens where rays at +-degrees meet: self-similar, with 120 degrees
// at both of its ends.
TEST(Junctions, FourSectorsComeApartAsTheSelfSimilarSolution) {
    constexpr double h = 0.0125;
    for (const auto& [degrees, c] : {std::pair{40.0, 1.08572}, std::pair{30.0, 1.87560}}) {
        SCOPED_TRACE(degrees);
        auto complex = four_sectors(degrees, h);
        ASSERT_EQ(junctions(complex, 4).size(), 1U);
        Simulation<double> simulation(complex, options(h));
        constexpr double dt = 0.1 * h * h;
        const int steps = static_cast<int>(std::pow(12 * h / c, 2) / dt);
        const Ran ran = run(simulation, complex, dt, steps);
        EXPECT_EQ(ran.unreached, 0U);
        ASSERT_EQ(ran.events.size(), 1U);
        EXPECT_EQ(ran.events[0].kind, EventKind::exchange);
        EXPECT_TRUE(junctions(complex, 4).empty());
        const auto ends = junctions(complex, 3);
        ASSERT_EQ(ends.size(), 2U);
        // The sectors with the smaller angles part, so that the edge lies along the x axis.
        EXPECT_LT(std::abs(ends[0].y() - ends[1].y()), 0.2 * h);
        EXPECT_NEAR((ends[0] - ends[1]).norm() / std::sqrt(steps * dt), c, 0.02 * c);
    }
}

TEST(Junctions, TheEnergyDecidesWhichSectorsPart) {
    constexpr double h = 0.02;
    for (const bool is_dear : {false, true}) {
        auto complex = four_sectors(40, h);
        Options<double> dear = options(h);
        if (is_dear) { // an interface between 2 and 4
            dear.topology.energy = [](Phase one, Phase other) {
                return one + other == 6 && one != other ? 5.0 : 1.0;
            };
        }
        Simulation<double> simulation(complex, dear);
        const Ran ran = run(simulation, complex, 1e-6, 3);
        ASSERT_GE(ran.events.size(), 1U);
        const std::set<Phase> taken{ran.events[0].taken[0], ran.events[0].taken[1]};
        EXPECT_EQ(taken, is_dear ? (std::set<Phase>{1, 3}) : (std::set<Phase>{2, 4}));
    }
}

TEST(Junctions, ANegativeEnergyIsRefused) {
    auto complex = four_sectors(40, 0.02);
    Options<double> bad = options(0.02);
    bad.topology.energy = [](Phase, Phase) { return -1.0; };
    Simulation<double> simulation(complex, bad);
    EXPECT_THROW((void)run(simulation, complex, 1e-6, 3), InputError);
    EXPECT_EQ(validate(complex).problem, "");
}

TEST(Junctions, FourSectorsStayTogetherWhereTheTopologyIsKept) {
    auto complex = four_sectors(40, 0.02);
    Options<double> keeping = options(0.02);
    keeping.topology.rule = Topology::keep;
    Simulation<double> simulation(complex, keeping);
    EXPECT_TRUE(run(simulation, complex, 1e-5, 5).events.empty());
    EXPECT_EQ(junctions(complex, 4).size(), 1U);
}

// Grains from random sites: they coarsen, no vertex is lost, and no vertex keeps four sectors.
TEST(Junctions, GrainsCoarsenInTheSameWayForAnyNumberOfThreads) {
    constexpr double h = 0.025;
    std::uint64_t hash = 0;
    for (const std::uint32_t threads : {1U, 2U, 3U}) {
        test::Dice dice(11);
        std::vector<P> sites;
        for (int i = 0; i < 40; ++i) {
            const double x = dice.in(0.0, 1.0);
            sites.emplace_back(x, dice.in(0.0, 1.0));
        }
        auto complex = initial_complex<double>({}, {}, {.edge_length = h});
        for (const Triangle t : triangles(complex)) {
            const P p = middle_of(complex, t);
            Phase nearest = 0;
            for (Phase i = 1; i < sites.size(); ++i) {
                nearest = (p - sites[i]).norm() < (p - sites[nearest]).norm() ? i : nearest;
            }
            complex.set_phase(t, nearest + 1);
        }
        const auto count = [&] {
            std::set<Phase> phases;
            for (const Triangle t : triangles(complex)) {
                phases.insert(complex.phase(t));
            }
            return phases.size();
        };
        const std::size_t before = count();
        Simulation<double> simulation(complex, options(h),
                                      Parallel{.threads = threads, .always_all_threads = true});
        const Ran ran = run(simulation, complex, 0.2 * h * h, 100);
        EXPECT_EQ(ran.unreached, 0U);
        EXPECT_LT(count(), before - 5);
        EXPECT_GT(std::ranges::count(ran.events, EventKind::exchange, &Event::kind), 3);
        EXPECT_GT(std::ranges::count(ran.events, EventKind::remove, &Event::kind), 3);
        EXPECT_LE(junctions(complex, 4).size(), 1U);
        hash = hash == 0 ? mesh_hash(complex) : hash;
        EXPECT_EQ(mesh_hash(complex), hash);
    }
}

} // namespace
} // namespace dsc::junctions_test
