// SPDX-License-Identifier: MIT
// The literal method of reference/ at work: quality measures, movement, integrators, and short runs
// of algorithm 5.1.
#include "support/reference_testing.h"

#include "dsc/base/error.h"
#include "reference/algorithm/dsc.h"
#include "reference/algorithm/selection.h"

namespace dsc::reference::reference_dsc_test {
namespace {

// --- quality measures [4.3] and selection [8.8] --------------------------------------------------

TEST(ReferenceQuality, DelaunayConditionHasTheSignOfInCircle) { // figure 4.2
    for (const double y : {0.2, 0.9, 1.1, 5.0}) {
        const Complex K = make({{0, 0}, {1, -1}, {2, 0}, {1, y}}, {{0, 1, 2}, {0, 2, 3}});
        EXPECT_EQ(delaunay(K, E(0, 2)) < 0, y < 1) << y;
    }
    EXPECT_NEAR(delaunay(square(), E(0, 2)), 0, 1e-15);
    EXPECT_EQ(delaunay(square(), E(0, 1)), 1);
}

// --- movement [5.1], integrators, interpolators [8.9] --------------------------------------------

TEST(ReferenceMovement, GoesAsFarAsNoTriangleInverts) { // figure 5.2
    Complex K = fan();
    EXPECT_TRUE(move_vertex(0_v, {0.3, 0.1}, K));
    EXPECT_EQ(K.coord(0_v), Point<double>(0.3, 0.1));
    Destinations under_way{{0_v, {3, 0}}};
    movement(under_way, K);
    EXPECT_EQ(under_way.size(), 1U);
    EXPECT_GT(K.coord(0_v).x(), 0.8);
    expect_valid(K);
    for (int i = 0; i < 200; ++i)
        movement(under_way, K);
    expect_valid(K); // ever closer to the wall, never through it
    K.set_coord(0_v, {0, 0});
    // The edge from 1 to 2 has length 1 and distance sqrt(3/4): all but 0.02 of that may go.
    const double s = std::sqrt(0.75);
    EXPECT_NEAR(movable_fraction(K, 0_v, {2 * s * s, 2 * s * .5}), (1 - least_altitude / s) / 2,
                1e-12);
    EXPECT_EQ(movable_fraction(K, 0_v, {0.1, 0}), 1);
}

TEST(ReferenceIntegrators, HaveTheirOrders) {
    const Velocity turn = [](const Point<double>& p, double) {
        return Point<double>(-p.y(), p.x());
    };
    const auto error = [&](Integrator integrator, double dt) {
        return (advect(turn, {1, 0}, 0, dt, integrator) - Point<double>(std::cos(dt), std::sin(dt)))
            .norm();
    };
    for (const auto& [integrator, order] :
         {std::pair{Integrator::euler, 1}, {Integrator::midpoint, 2}, {Integrator::rk4, 4}}) {
        EXPECT_NEAR(std::log2(error(integrator, 0.2) / error(integrator, 0.1)), order + 1, 0.1);
    }
    const Velocity clock = [](const Point<double>&, double t) { return Point<double>(t, t * t); };
    const Point<double> p = advect(clock, {0, 0}, 1, 1, Integrator::rk4);
    EXPECT_NEAR(p.x(), 1.5, 1e-15);
    EXPECT_NEAR(p.y(), 7.0 / 3, 1e-15);
}

// --- the mesh updates of algorithm 5.1 -----------------------------------------------------------

// The upper half of a grid: the interface runs along y = 2 from vertex 10 to 14, and around the
// wall.
Complex half_full() {
    return grid(4, {16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31});
}

PassOptions with_edge_length_only(double h) {
    PassOptions options;
    options.edge_length = h;
    return options;
}

TEST(ReferencePasses, ShortInterfaceEdgesVanishWhereTheCurveStays) {
    const PassOptions options = with_edge_length_only(1);
    PassCounts counts;
    Complex K = half_full();
    K.set_coord(11_v, {1.6, 2}); // without 11, the edge from 10 to 12 would be too long
    interface_coarsening(K, K.interface(), options, counts);
    EXPECT_EQ(counts.collapses, 1U);
    EXPECT_TRUE(K.is_interface(E(11, 13)));
    expect_valid(K);
    Complex bent = half_full();
    bent.set_coord(11_v, {1.6, 2.1}); // both ends stand off the line of their neighbours
    interface_coarsening(bent, bent.interface(), options, counts);
    EXPECT_EQ(counts.collapses, 1U);
}

TEST(ReferencePasses, PhasesKeepTheirSizes) {
    Complex K = grid(8);
    PassCounts counts;
    phase_coarsening(K, *phases(K).begin(), with_edge_length_only(4), counts);
    EXPECT_GT(counts.retriangulations, 0U);
    EXPECT_LT(K.vertices().size(), 81U);
    Complex coarse = half_full();
    phase_refinement(coarse, *phases(coarse).rbegin(), with_edge_length_only(.5), counts);
    EXPECT_GT(counts.subdivisions, 0U);
    EXPECT_GT(counts.splits, 0U); // at the interface, where a subdivision is illegal
    PassOptions by_phase = with_edge_length_only(.5);
    by_phase.phase_edge_length = [](Phase phase, const Point<double>&) {
        return phase == 1 ? 9. : .5;
    };
    PassCounts none;
    coarse = half_full();
    phase_refinement(coarse, *phases(coarse).rbegin(), by_phase, none);
    EXPECT_EQ(none.subdivisions + none.splits, 0U);
    expect_valid(K);
    expect_valid(coarse);
}

// --- the algorithm [5.6] -------------------------------------------------------------------------

struct Summary {
    std::size_t unreached = 0;
    StepCounts last;
};

Summary run(Complex& K, const Velocity& velocity, double dt, int steps, const Options& options) {
    Summary result;
    for (int i = 0; i < steps; ++i) {
        result.last = step(K, velocity, i * dt, dt, options);
        result.unreached += result.last.unreached;
    }
    expect_valid(K);
    return result;
}

Options with_edge_length(double h) {
    Options options;
    options.passes.edge_length = h;
    return options;
}

TEST(ReferenceDsc, FarStepsAreDivided) {
    Complex K = square_in_square(4, 10);
    const Velocity wind = [](const Point<double>&, double) { return Point<double>(.4, .1); };
    const Summary result = run(K, wind, 1, 1, with_edge_length(.05)); // 8 h
    EXPECT_EQ(result.unreached, 0U);
    EXPECT_GE(result.last.substeps, 16U);
    EXPECT_LE(result.last.substeps, 18U);
    EXPECT_NEAR(total_area(K, 1), .09, 1e-12);
    for (Vertex v : K.interface().vertices) {
        const Point<double> from_middle = K.coord(v) - Point<double>(.75, .45);
        EXPECT_NEAR(from_middle.cwiseAbs().maxCoeff(), .15, 1e-12);
    }
    EXPECT_THROW(step(K, wind, 0, 1e9, with_edge_length(.05)), InputError);
    EXPECT_THROW(step(K, wind, 0, std::nan(""), with_edge_length(.05)), InputError);
    EXPECT_THROW(step(K, wind, 0, 1, with_edge_length(0)), InputError);
}

TEST(ReferenceDsc, EndsWhereTheWallEnds) {
    Complex K = square_in_square(4, 16);
    const Velocity wind = [](const Point<double>&, double) { return Point<double>(.05, 0); };
    Options options = with_edge_length(.05);
    options.max_iterations = 4;
    EXPECT_GT(run(K, wind, 1, 8, options).unreached, 0U);
    EXPECT_NEAR(total_area(K, 0) + total_area(K, 1), 1, 1e-12);
    // Figure 8.3: the water's edge at the wall slides along it, and the corners stay.
    Complex water = grid(4, {0, 1, 2, 3, 4, 5, 6, 7});
    const Velocity up = [](const Point<double>&, double) { return Point<double>(.3, .3); };
    EXPECT_EQ(run(water, up, 1, 1, with_edge_length(1)).unreached, 0U);
    EXPECT_EQ(water.coord(0_v), Point<double>(0, 0));
    EXPECT_EQ(water.coord(5_v), Point<double>(0, 1.3));
    EXPECT_NEAR(total_area(water, 0) + total_area(water, 1), 16, 1e-12);
}

} // namespace
} // namespace dsc::reference::reference_dsc_test
