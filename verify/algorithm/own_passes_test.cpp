// SPDX-License-Identifier: MIT
// The algorithm is the application's: passes that it replaces, removes or adds.
#include "dsc/algorithm/simulation.h"

#include "support/simulation_testing.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace dsc::own_passes_test {
namespace {

using test::coarse;
using test::constant;
using test::disc_complex;
using test::expect_sound;
using test::options_for;

template <class Real>
class OwnPasses : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(OwnPasses, Reals);

TYPED_TEST(OwnPasses, RunsTheApplicationsPassesInsteadOfTheDefault) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse);
    const auto options = options_for<Real>(coarse);
    std::vector<std::string> calls;
    const auto noting = [&](const char* name, auto pass) {
        return Pass<Real>{name, [&calls, name, pass](Work<Real>& work) {
                              calls.emplace_back(name);
                              pass(work);
                          }};
    };
    // Movement alone: no remeshing of the interface, and no mesh update.
    const Algorithm<Real> algorithm{
        .remeshing = {noting("remeshing", [](Work<Real>&) {})},
        .motion = {noting("move", &move_vertices<Real>),
                   noting("forget", [](Work<Real>& work) { work.active.clear(); })}};
    Simulation<Real> simulation(complex, options,
                                std::make_unique<Executor<Real>>(complex, options, algorithm));
    const StepReport report = simulation.step(constant<Real>(0.02, 0), 0, 1);
    EXPECT_EQ(calls, (std::vector<std::string>{"remeshing", "move", "forget"}));
    EXPECT_EQ(report.operations.moves, simulation.interface().size());
    EXPECT_EQ(report.operations.flips, 0U);
    EXPECT_EQ(report.operations.smoothed, 0U);
    EXPECT_EQ(report.operations.examined, 0U);
    expect_sound(complex, simulation);

    // Without a mesh update it soon comes to an end, and says so.
    std::uint64_t unreached = 0;
    for (int step = 0; step < 20; ++step) {
        unreached += simulation.step(constant<Real>(0.02, 0), 0, 1).unreached;
        expect_sound(complex, simulation);
    }
    EXPECT_GT(unreached, 0U);
}

TYPED_TEST(OwnPasses, TakesThresholdsForEachPhase) {
    using Real = TypeParam;
    // Phase 1 is kept twice as fine as phase 0 by its longest incident edge.
    auto complex = disc_complex<Real>(coarse);
    auto options = options_for<Real>(coarse);
    options.per_phase.resize(2);
    options.per_phase[1].longest = 0.8;
    options.per_phase[1].shortest = 0.2;
    Simulation<Real> simulation(complex, options);
    const auto triangles_of = [&](Phase phase) {
        return static_cast<int>(std::ranges::distance(triangles(complex, phase)));
    };
    const int inside = triangles_of(1);
    const int outside = triangles_of(0);
    for (int step = 0; step < 10; ++step) {
        EXPECT_EQ(simulation.step(constant<Real>(step < 5 ? 0.02 : -0.02, 0), 0, 1).unreached, 0U);
        expect_sound(complex, simulation);
    }
    // Some of it spreads into the neighbour, where qualities are mended.
    EXPECT_GT(triangles_of(1), 1.5 * inside);
    EXPECT_LT(triangles_of(0), 1.25 * outside);
}

} // namespace
} // namespace dsc::own_passes_test
