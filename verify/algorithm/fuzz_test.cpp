// SPDX-License-Identifier: MIT
// Random shapes in random flows, now and then wild ones: whatever is asked, every step ends, and
// ends with a valid complex. The seeds are fixed; DSC_FUZZ_SEEDS=N runs N scenes of each kind, and
// DSC_FUZZ_FIRST says where to begin; with DSC_FUZZ_TOPOLOGY the topology changes in every scene
// and not only in some. The scene that took the most CPU time is printed at the end.
#include "support/cut_down.h"
#include "support/environment.h"
#include "support/random/options.h"
#include "support/random/scene.h"
#include "support/random/submeshes.h"
#include "support/topology/changing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/io/replay.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace dsc::fuzz_test {
namespace {

using test::cut_down;
using test::Dice;
using test::from_environment;
using test::RandomFlow;
using test::Wildness;

struct Drawn {
    std::string words; ///< to say what failed
    std::uint64_t moves = 0;
    std::uint64_t unreached = 0;
};

// The log replayed gives the same mesh; of a mesh that has become invalid, the edits that it takes
// to get there are kept in a file. What create and merge did is in no log.
template <class Real>
void check_log(const Complex<Real>& first, const std::vector<Edit>& edits,
               const Complex<Real>& last, const std::string& words) {
    if (std::ranges::find(edits, EditKind::rebuild, &Edit::kind) != edits.end()) {
        return;
    }
    Complex<Real> again = first;
    EXPECT_EQ(replay<Real>(again, edits).skipped, 0U) << words;
    EXPECT_EQ(mesh_hash(again), mesh_hash(last)) << words;
    if (!validate(last).ok()) {
        const std::vector<Edit> few = cut_down<Real>(
            first, edits, [](const Complex<Real>& replayed) { return !validate(replayed).ok(); });
        const std::string path = testing::TempDir() + "dsc_fuzz.edits";
        write_edits(path, few);
        ADD_FAILURE() << words << ": " << few.size() << " of " << edits.size()
                      << " edits make the first complex of this seed invalid; see " << path;
    }
}

template <class Real>
Drawn survive(std::uint64_t seed, bool wild, bool patches) {
    Dice dice(seed);
    std::ostringstream words;
    words << "seed " << seed;
    const double h = dice.in(0.03, 0.07);
    auto complex = patches ? test::random_patches<Real>(dice, h, dice.in(2, 400))
                           : test::random_shapes<Real>(dice, h);
    test::ChangingOptions<Real> options{test::draw_options<Real>(dice, h, words)};
    // Of its own, so that the rest of a scene is what it was before topologies could change.
    Dice topology_dice(seed + 0x70b0UL);
    test::draw_topology(topology_dice, std::getenv("DSC_FUZZ_TOPOLOGY") != nullptr, h,
                        options.topology, words);
    const auto wildness = wild ? dice.one_of(test::wildness_names) : Wildness::none;
    const RandomFlow flow(dice, 1, wildness);
    const Velocity<Real> velocity = flow.velocity<Real>();
    // From a hundredth of an edge a step to eight.
    const double dt = h * std::pow(10.0, dice.in(-2.0, wild ? 0.9 : 0.0));
    words << ", h " << h << ", dt " << dt << ", wildness "
          << name_in(test::wildness_names, wildness);
    std::unique_ptr<Executor<Real>> executor; // none: sequential
    if (dice.chance(0.6)) {
        // parallel_test says that the number of threads makes no difference.
        const std::uint32_t threads = dice.chance(0.2) ? 2 : 1;
        executor = test::random_executor(dice, complex, options, threads, words);
    }
    const Complex<Real> first = complex;
    std::vector<Edit> edits;
    test::ChangingSimulation<Real> simulation(complex, options, std::move(executor));
    // Torn flows make interfaces of any length, fine sizes meshes of any size: then it is enough,
    // also in the middle of a step.
    constexpr std::size_t enough = 300'000;
    std::atomic<bool> has_enough = false;
    simulation.interrupt_by(&has_enough);
    simulation.add_listener([&](std::span<const Edit> some) {
        edits.insert(edits.end(), some.begin(), some.end());
        has_enough = edits.size() > enough;
    });
    Drawn drawn;
    drawn.words = words.str();
    std::string problem = validate(complex).problem;
    EXPECT_EQ(problem, "") << drawn.words << ", before the first step";
    std::uint64_t examined = 0;
    for (int step = 0; step < 12 && problem.empty() && examined < enough && !has_enough; ++step) {
        const StepReport report =
            simulation.step(velocity, static_cast<Real>(step * dt), static_cast<Real>(dt));
        problem = validate(complex).problem;
        if (problem.empty()) {
            problem = test::interface_fault(complex, simulation.interface());
        }
        EXPECT_EQ(problem, "") << drawn.words << ", step " << step;
        EXPECT_LE(report.sub_steps, 60U) << drawn.words;
        EXPECT_LE(report.passes, report.sub_steps * static_cast<std::uint32_t>(options.max_passes))
            << drawn.words;
        EXPECT_LE(report.held, report.unreached) << drawn.words;
        EXPECT_EQ(report.interface_vertices, simulation.interface().size()) << drawn.words;
        examined += report.operations.examined;
        drawn.moves += report.operations.moves;
        drawn.unreached += report.unreached;
    }
    check_log(first, edits, complex, drawn.words);
    return drawn;
}

struct Kind {
    const char* name;
    bool wild;
    bool patches;
};

class Fuzz : public testing::TestWithParam<Kind> {};

void run_kind(const Kind& kind, std::uint64_t first, std::uint64_t count) {
    std::uint64_t moves = 0;
    double most = 0;
    std::string slowest;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::clock_t start = std::clock();
        const Drawn drawn = seed % 4 == 3 ? survive<float>(seed, kind.wild, kind.patches)
                                          : survive<double>(seed, kind.wild, kind.patches);
        moves += drawn.moves;
        if (testing::Test::HasFailure()) {
            FAIL() << "first failing scene: " << drawn.words;
        }
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (seconds > most) {
            most = seconds;
            slowest = drawn.words;
        }
    }
    std::cout << "most CPU time of a scene: " << most << " s, " << slowest << '\n';
    EXPECT_GT(moves, 100 * count) << "hardly anything moved";
}

TEST_P(Fuzz, EveryStepEndsWithAValidComplex) {
    run_kind(GetParam(), from_environment("DSC_FUZZ_FIRST", 1),
             from_environment("DSC_FUZZ_SEEDS", 20));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Fuzz,
                         testing::Values(Kind{"smooth_shapes", false, false},
                                         Kind{"smooth_patches", false, true},
                                         Kind{"wild_shapes", true, false},
                                         Kind{"wild_patches", true, true}),
                         [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace dsc::fuzz_test
