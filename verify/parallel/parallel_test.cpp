// SPDX-License-Identifier: MIT
// Parallel DSC: the same bits, ids and data for any number of threads, for every way to divide; as
// good as the sequential method.
#include "dsc/parallel/in_place/submesh_executor.h"

#include "support/parallel_outcome.h"

#include <gtest/gtest.h>

namespace dsc::parallel_test {
namespace {

using namespace test;

Scene scene_of(std::uint64_t seed) {
    Scene scene{.seed = seed};
    scene.patches = seed % 3 == 0;
    scene.data = seed % 2 == 0;
    // Smooth, not a number, torn, noise.
    constexpr std::array wild{Wildness::not_a_number, Wildness::torn, Wildness::noise};
    scene.wildness = seed % 4 == 3 ? wild.at(seed / 4 % wild.size()) : Wildness::none;
    return scene;
}

class EveryDivision : public testing::TestWithParam<PartitionFamily> {};

TEST_P(EveryDivision, GivesTheSameBitsForAnyNumberOfThreads) {
    std::size_t several = 0;
    std::uint32_t most_threads = 0;
    // With fewer, some divisions never have work for three threads.
    const std::uint64_t seeds = std::max<std::uint64_t>(seeds_or_fewer(9), 3);
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
        const Scene scene = scene_of(seed);
        const Outcome one = run_division<double>(scene, GetParam(), 1);
        several += one.most_submeshes >= 3 ? 1 : 0;
        for (const std::uint32_t threads : {2U, 3U, 5U}) {
            const Outcome many = run_division<double>(scene, GetParam(), threads);
            expect_same(one, many);
            most_threads = std::max(most_threads, many.most_threads);
        }
    }
    EXPECT_GE(several, seeds / 2) << "hardly anything ran in parallel";
    EXPECT_GE(most_threads, 3U);
}

TEST_P(EveryDivision, GivesTheSameBitsInFloat) {
    for (std::uint64_t seed = 21; seed < 21 + seeds_or_fewer(3); ++seed) {
        const Scene scene = scene_of(seed);
        const Outcome one = run_division<float>(scene, GetParam(), 1);
        expect_same(one, run_division<float>(scene, GetParam(), 4));
    }
}

// What reaches farther: options of the interface, to the neighbours of neighbours and across the link;
// and integrators that remember, or choose the step.
TEST_P(EveryDivision, GivesTheSameBitsWhateverIsAskedFor) {
    using scenes::IntegratorChoice;
    const std::array<std::function<void(Scene&, InterfaceThresholds&)>, 5> ways{
        [](auto&, auto& i) { i.coarsening = Coarsening::length; },
        [](auto&, auto& i) { i.reading = Reading::cubic; },
        [](auto&, auto& i) {
            i.turn_degrees = 15;
            i.gap = 1;
        },
        [](auto& scene, auto&) { scene.integrator = IntegratorChoice::centred; },
        [](auto& scene, auto&) { scene.integrator = IntegratorChoice::adaptive; }};
    for (std::uint64_t seed = 41; seed < 41 + seeds_or_fewer(2); ++seed) {
        for (const auto& way : ways) {
            Scene scene = scene_of(seed);
            InterfaceThresholds interface;
            interface.longest = 1.2;
            interface.shortest = 0.55; // there is enough to collapse
            way(scene, interface);
            scene.interface = [&](InterfaceThresholds& i) { i = interface; };
            const Outcome one = run_division<double>(scene, GetParam(), 1);
            EXPECT_GT(one.counts.interface_collapses + one.counts.interface_splits,
                      2U * static_cast<std::uint64_t>(scene.steps));
            expect_same(one, run_division<double>(scene, GetParam(), 3));
            // Only clocks are read by an account of times.
            expect_same(one, run_division<double>(scene, GetParam(), 2, true));
        }
    }
}

void expect_near(std::uint64_t value, std::uint64_t expected, double share, const char* what) {
    EXPECT_NEAR(static_cast<double>(value), static_cast<double>(expected),
                share * static_cast<double>(expected) + 12)
        << what;
}

// Without obstacles all vertices arrive, and about as much is done as sequentially.
TEST_P(EveryDivision, DoesWhatTheSequentialMethodDoes) {
    std::size_t several = 0;
    std::size_t tame = 0;
    for (const std::uint64_t seed : tame_seeds) {
        const Scene scene{.seed = seed};
        const Outcome sequential = simulate<double>(scene, {});
        if (std::ranges::count(sequential.unreached, 0U) != scene.steps) {
            continue; // not as tame with the arithmetic of this compiler
        }
        ++tame;
        const Outcome parallel = run_division<double>(scene, GetParam(), 3);
        SCOPED_TRACE(parallel.words);
        several += parallel.most_submeshes >= 3 ? 1 : 0;
        EXPECT_EQ(parallel.unreached, sequential.unreached);
        ASSERT_EQ(parallel.areas.size(), sequential.areas.size());
        for (const auto& [phase, area] : sequential.areas) {
            EXPECT_NEAR(parallel.areas.at(phase), area, 1e-4) << "phase " << phase;
        }
        const OperationCounts& p = parallel.counts;
        const OperationCounts& s = sequential.counts;
        expect_near(p.moves, s.moves, 0.05, "moves");
        expect_near(p.interface_splits, s.interface_splits, 0.1, "interface splits");
        expect_near(p.interface_collapses, s.interface_collapses, 0.1, "interface collapses");
        expect_near(p.flips, s.flips, 0.2, "flips");
        // A vertex beside a short edge may be created and removed again by each submesh that looks
        // at it; the vertices that remain are about the same.
        expect_near(p.splits, s.splits, 0.5, "splits");
        expect_near(p.collapses, s.collapses, 0.35, "collapses");
        expect_near(p.splits + s.collapses, s.splits + p.collapses, 0.1, "what remains");
        expect_near(p.smoothed, s.smoothed, 0.15, "smoothed");
    }
    EXPECT_GE(tame, 3U) << "choose tamer scenes";
    EXPECT_GE(several, 2U) << "hardly anything ran in parallel";
}

INSTANTIATE_TEST_SUITE_P(Parallel, EveryDivision, testing::ValuesIn(test::all_partition_families),
                         [](const auto& one) { return std::string(to_string(one.param)); });

} // namespace
} // namespace dsc::parallel_test
