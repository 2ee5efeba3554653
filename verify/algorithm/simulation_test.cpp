// SPDX-License-Identifier: MIT
// The sequential driver: what it counts, how far it goes, and what it refuses. Every step ends with
// a valid complex and a list of the whole interface. Velocities that no mesh can follow are among
// the hard cases (hard/numbers.cpp).
#include "dsc/algorithm/simulation.h"

#include "support/refusal.h"
#include "support/simulation_testing.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/algorithm.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>

namespace dsc::simulation_test {
namespace {

using test::coarse;
using test::constant;
using test::disc_complex;
using test::expect_sound;
using test::options_for;
using test::pointwise;

template <class Real>
class Driver : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Driver, Reals);

TYPED_TEST(Driver, CountsWhatItDoes) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse);
    auto options = options_for<Real>(coarse);
    options.interface.shortest = 0.45;
    Simulation<Real> simulation(complex, options);
    // It grows from a radius of 0.25 to 0.41, and shrinks to 0.11.
    const auto flow = pointwise<Real>([](const Point<double>& p, double time) {
        return Point<double>((time < 25 ? 1 : -1) * (p - Point<double>(0.5, 0.5)));
    });
    OperationCounts sum;
    const std::int64_t vertices = complex.vertex_count();
    for (int step = 0; step < 90; ++step) {
        auto at = static_cast<Real>(step);
        const StepReport report = simulation.step(
            [&](auto positions, Real, auto velocities) { flow(positions, at, velocities); }, 0,
            Real(0.02));
        sum += report.operations;
        ASSERT_EQ(report.unreached, 0U);
        ASSERT_EQ(report.held, 0U);
        ASSERT_EQ(report.gave_up, GiveUp::none);
        ASSERT_EQ(report.sub_steps, 1U);
        ASSERT_GE(report.passes, 1U);
        ASSERT_EQ(report.interface_vertices, simulation.interface().size());
        ASSERT_GE(report.operations.moves, report.interface_vertices);
        ASSERT_GE(report.operations.examined, report.interface_vertices);
        expect_sound(complex, simulation);
        // Each split makes a vertex and each collapse takes one.
        const auto made = static_cast<std::int64_t>(sum.splits + sum.interface_splits);
        const auto gone = static_cast<std::int64_t>(sum.collapses + sum.interface_collapses);
        ASSERT_EQ(static_cast<std::int64_t>(complex.vertex_count()) - vertices, made - gone);
    }
    EXPECT_GT(sum.interface_splits, 5U);
    EXPECT_GT(sum.interface_collapses, 5U);
    EXPECT_GT(sum.flips, 50U);
    EXPECT_GT(sum.collapses, 20U);
    EXPECT_GT(sum.splits, 5U);
    EXPECT_GT(sum.smoothed, 5U);
}

TYPED_TEST(Driver, DoesNothingWhereNothingMoves) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse);
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    const std::uint64_t hash = mesh_hash(complex);
    for (int step = 0; step < 3; ++step) {
        const StepReport report = simulation.step(constant<Real>(0, 0), 0, 1);
        EXPECT_EQ(report.operations.moves, 0U);
        EXPECT_EQ(report.unreached, 0U);
    }
    EXPECT_EQ(simulation.step(constant<Real>(1, 1), 0, 0).sub_steps, 0U);
    EXPECT_EQ(mesh_hash(complex), hash);
    expect_sound(complex, simulation);
}

TYPED_TEST(Driver, LeavesLockedVerticesWhereTheyAre) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse);
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    std::map<std::uint32_t, Point<Real>> locked;
    for (const std::uint32_t v : simulation.interface()) {
        if (static_cast<double>(complex.position(Vertex{v}).y()) > 0.7) {
            complex.set_locked(Vertex{v}, true);
            locked[v] = complex.position(Vertex{v});
        }
    }
    ASSERT_GT(locked.size(), 2U);
    for (int step = 0; step < 10; ++step) {
        (void)simulation.step(constant<Real>(0.01, 0.01), 0, 1);
        expect_sound(complex, simulation);
    }
    for (const auto& [v, p] : locked) {
        ASSERT_TRUE(complex.is_alive(Vertex{v}));
        EXPECT_EQ(complex.position(Vertex{v}).x(), p.x());
        EXPECT_EQ(complex.position(Vertex{v}).y(), p.y());
    }
}

TYPED_TEST(Driver, RefusesStepsThatAreNone) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse);
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real infinity = std::numeric_limits<Real>::infinity();
    const auto velocity = constant<Real>(0.01, 0);
    for (const Real dt : {nan, infinity, -infinity, Real(-1)}) {
        EXPECT_THROW((void)simulation.step(velocity, 0, dt), InputError);
    }
    EXPECT_THROW((void)simulation.step(velocity, nan, 1), InputError);
    EXPECT_THROW((void)simulation.step(velocity, infinity, 1), InputError);
    EXPECT_EQ(simulation.step(velocity, 0, 1).unreached, 0U);
}

TYPED_TEST(Driver, RefusesOptionsThatMakeNoSense) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct Fault {
        const char* where;
        std::function<void(Options<Real>&)> seed;
    };
    const auto graded = [](auto change) {
        return [change](Options<Real>& o) {
            o.sizes.growth = 1.3;
            change(o);
        };
    };
    const std::vector<Fault> faults{
        {"edge_length", [](auto& o) { o.edge_length = 0; }},
        {"edge_length", [](auto& o) { o.edge_length = -1; }},
        {"edge_length", [&](auto& o) { o.edge_length = static_cast<Real>(nan); }},
        {"edge_length", [](auto& o) { o.edge_length = std::numeric_limits<Real>::infinity(); }},
        {"phases.collapse_quality", [](auto& o) { o.phases.collapse_quality = -0.1; }},
        {"phases.collapse_quality", [&](auto& o) { o.phases.collapse_quality = nan; }},
        {"phases.smooth_quality", [](auto& o) { o.phases.smooth_quality = 1.1; }},
        {"phases.longest", [](auto& o) { o.phases.longest = 2 * o.phases.shortest; }},
        {"phases.longest", [&](auto& o) { o.phases.longest = nan; }},
        {"phases.shortest", [](auto& o) { o.phases.shortest = -1; }},
        {"phases.longest", [](auto& o) { o.phases.longest = INFINITY; }},
        {"phases.longest", [](auto& o) { o.per_phase = {{.longest = 1e300}}; }},
        {"edge_length", [](auto& o) { o.edge_length = 20; }},
        {"phases.collapse_quality",
         [](auto& o) {
             o.per_phase.resize(2);
             o.per_phase[1].collapse_quality = 2;
         }},
        {"interface.shortest", [](auto& o) { o.interface.shortest = -1; }},
        {"interface.longest", [](auto& o) { o.interface.longest = o.interface.shortest; }},
        {"interface.longest", [](auto& o) { o.interface.longest = INFINITY; }},
        {"interface.deviation", [](auto& o) { o.interface.deviation = -1e-9; }},
        {"interface.deviation", [](auto& o) { o.interface.deviation = INFINITY; }},
        {"interface.feature_degrees", [](auto& o) { o.interface.feature_degrees = 0; }},
        {"interface.feature_degrees", [](auto& o) { o.interface.feature_degrees = 181; }},
        {"sub_step", [](auto& o) { o.sub_step = 0; }},
        {"sub_step", [&](auto& o) { o.sub_step = nan; }},
        {"interface.turn_degrees", [](auto& o) { o.interface.turn_degrees = -1; }},
        {"interface.turn_degrees", [](auto& o) { o.interface.turn_degrees = 0.1; }},
        {"interface.gap", [](auto& o) { o.interface.gap = 0.01; }},
        {"interface.gap", [](auto& o) { o.interface.gap = 1e300; }},
        {"interface.grading", [](auto& o) { o.interface.grading = 1e300; }},
        {"interface.degenerate", [](auto& o) { o.interface.degenerate = 1e300; }},
        {"tolerance", [](auto& o) { o.tolerance = 1e300; }},
        {"interface.finest", [](auto& o) { o.interface.finest = 0; }},
        {"interface.finest", [](auto& o) { o.interface.finest = 1.8; }},
        {"interface.grading", [](auto& o) { o.interface.grading = 1; }},
        {"interface.degenerate", [](auto& o) { o.interface.degenerate = -0.5; }},
        {"phases.crowded", [](auto& o) { o.phases.crowded = 3; }},
        {"tolerance", [](auto& o) { o.tolerance = 0; }},
        {"tolerance", [&](auto& o) { o.tolerance = nan; }},
        {"sizes.growth", [](auto& o) { o.sizes.growth = 1; }},
        {"sizes.growth", [](auto& o) { o.sizes.growth = 0.5; }},
        {"sizes.growth", [](auto& o) { o.sizes.growth = 2.1; }},
        {"sizes.growth", [](auto& o) { o.sizes.growth = -1; }},
        {"sizes.growth", [&](auto& o) { o.sizes.growth = nan; }},
        {"sizes.growth", [](auto& o) { o.sizes.by_distance = [](Real) { return Real(0.1); }; }},
        {"sizes.growth", [](auto& o) { o.sizes.longest = Real(0.1); }},
        {"sizes.growth", [](auto& o) { o.sizes.shortest = o.edge_length / 2; }},
        {"sizes.longest", graded([](auto& o) { o.sizes.longest = o.edge_length / 2; })},
        {"sizes.longest", graded([&](auto& o) { o.sizes.longest = static_cast<Real>(nan); })},
        {"sizes.longest", graded([](auto& o) { o.sizes.longest = INFINITY; })},
        {"sizes.shortest", graded([](auto& o) { o.sizes.shortest = 2 * o.edge_length; })},
        {"sizes.shortest", graded([](auto& o) { o.sizes.shortest = -o.edge_length; })},
        {"sizes.shortest", graded([&](auto& o) { o.sizes.shortest = static_cast<Real>(nan); })},
        {"sizes.changes_in_time", graded([](auto& o) { o.sizes.changes_in_time = true; })},
        {"max_sub_steps", [](auto& o) { o.max_sub_steps = 0; }},
        {"max_passes", [](auto& o) { o.max_passes = 0; }},
        {"max_passes", [](auto& o) { o.max_passes = 1'000'000'000; }},
        {"max_idle_passes", [](auto& o) { o.max_idle_passes = -1; }},
        {"max_idle_passes", [](auto& o) { o.max_idle_passes = 1'000'000'000; }},
    };
    for (const Fault& fault : faults) {
        auto options = options_for<Real>(coarse);
        EXPECT_NO_THROW(Simulation<Real>(complex, options));
        fault.seed(options);
        test::expect_refusal([&] { const Simulation<Real> simulation(complex, options); },
                             fault.where);
    }
}

} // namespace
} // namespace dsc::simulation_test
