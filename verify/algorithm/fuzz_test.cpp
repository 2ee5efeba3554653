// SPDX-License-Identifier: MIT
// Random shapes in random flows, now and then wild ones: whatever is asked, every step ends, and
// ends with a valid complex. The seeds are fixed; DSC_FUZZ_SEEDS=N runs N scenes of each kind, and
// DSC_FUZZ_FIRST says where to begin.
#include "support/random_scene.h"
#include "support/random_submeshes.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>

namespace dsc {
namespace {

using test::Dice;
using test::RandomFlow;
using test::Wildness;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

struct Drawn {
    std::string words; ///< to say what failed
    std::uint64_t moves = 0;
    std::uint64_t unreached = 0;
};

template <class Real>
void draw_options(Dice& dice, Options<Real>& options) {
    options.integrator = static_cast<Integrator>(dice.in(0, 2));
    options.insertion = static_cast<Insertion>(dice.in(0, 1));
    options.max_sub_steps = 60;
    if (dice.chance(0.3)) {
        options.phases.shortest = dice.in(0.0, 0.6);
        // Shorter ones only make the mesh large.
        options.phases.longest = std::max(0.8, 2.05 * options.phases.shortest) + dice.in(0.0, 1.5);
        options.phases.collapse_quality = dice.in(0.0, 0.6);
        options.phases.smooth_quality = dice.in(0.0, 1.0);
        options.interface.shortest = dice.in(0.0, 0.8);
        options.interface.longest = 2.05 * options.interface.shortest + dice.in(0.1, 1.0);
        options.interface.deviation = dice.in(0.0, 0.3);
        options.interface.corner_degrees = dice.in(1.0, 180.0);
        options.sub_step = dice.in(0.05, 2.0);
    }
    if (dice.chance(0.3)) {
        options.shuffle_seed = 17;
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
    Options<Real> options;
    options.edge_length = static_cast<Real>(h);
    draw_options(dice, options);
    const auto wildness =
        wild ? static_cast<Wildness>(dice.in(0, test::wildness_count - 1)) : Wildness::none;
    const RandomFlow flow(dice, 1, wildness);
    const Velocity<Real> velocity = flow.velocity<Real>();
    // From a hundredth of an edge a step to eight.
    const double dt = h * std::pow(10.0, dice.in(-2.0, wild ? 0.9 : 0.0));
    words << ", h " << h << ", dt " << dt << ", wildness " << static_cast<int>(wildness);
    std::unique_ptr<Executor<Real>> executor; // none: sequential
    if (dice.chance(0.6)) {
        // parallel_test says that the number of threads makes no difference.
        const std::uint32_t threads = dice.chance(0.2) ? 2 : 1;
        executor = test::random_executor(dice, complex, options, threads, words);
    }
    Simulation<Real> simulation(complex, options, std::move(executor));
    Drawn drawn;
    drawn.words = words.str();
    std::string problem = validate(complex).problem;
    EXPECT_EQ(problem, "") << drawn.words << ", before the first step";
    // Torn flows make interfaces of any length: then it is enough.
    for (int step = 0; step < 12 && problem.empty() && complex.triangle_count() < 12'000; ++step) {
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
        drawn.moves += report.operations.moves;
        drawn.unreached += report.unreached;
    }
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
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const Drawn drawn = seed % 4 == 3 ? survive<float>(seed, kind.wild, kind.patches)
                                          : survive<double>(seed, kind.wild, kind.patches);
        moves += drawn.moves;
        if (testing::Test::HasFailure()) {
            FAIL() << "first failing scene: " << drawn.words;
        }
    }
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
} // namespace dsc
