// SPDX-License-Identifier: MIT
// Random shapes, flows, options and divisions by one to four ranks: each edit, in the order in
// which listeners hear of it, is that of the run without ranks, and so is the mesh by its ids. The
// ranks compare all that they hold after each sub-step. DSC_FUZZ_SEEDS=N runs N scenes, from
// DSC_FUZZ_FIRST.
#include "support/environment.h"
#include "support/parallel_outcome.h"
#include "support/random/options.h"
#include "support/thread_ranks.h"

#include "dsc/io/edit_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace dsc::ranks_fuzz_test {
namespace {

using test::Dice;
using test::from_environment;

/// What can be seen of a run.
struct Seen {
    std::vector<std::uint64_t> ids;  ///< after each step
    std::vector<std::uint64_t> data; ///< after each step
    std::vector<Edit> edits;
    std::vector<std::uint64_t> unreached;
    std::uint64_t passes = 0;
    std::size_t events = 0;
};

void expect_same(const Seen& one, const Seen& other, const std::string& words) {
    EXPECT_EQ(one.ids, other.ids) << words;
    EXPECT_EQ(one.data, other.data) << words;
    EXPECT_EQ(one.unreached, other.unreached) << words;
    EXPECT_EQ(one.events, other.events) << words;
    EXPECT_EQ(one.passes, other.passes) << words;
    ASSERT_EQ(one.edits.size(), other.edits.size()) << words;
    for (std::size_t i = 0; i < one.edits.size(); ++i) {
        const Edit& a = one.edits[i];
        const Edit& b = other.edits[i];
        ASSERT_TRUE(a.kind == b.kind && a.reason == b.reason && a.corner == b.corner &&
                    a.vertex == b.vertex && a.ends == b.ends && a.apexes == b.apexes &&
                    a.made == b.made && a.x == b.x && a.y == b.y)
            << words << ", edit " << i << ", " << to_string(a.kind);
    }
}

template <class Real>
Seen simulate(std::uint64_t seed, Ranks* ranks, std::string& description) {
    Dice dice(seed);
    std::ostringstream words;
    words << "seed " << seed;
    const double h = dice.in(0.03, 0.06);
    auto complex = dice.chance(0.4) ? test::random_patches<Real>(dice, h, dice.in(2, 60))
                                    : test::random_shapes<Real>(dice, h);
    auto options = test::draw_options<Real>(dice, h, words);
    test::draw_topology(dice, false, h, options.topology, words);
    if (dice.chance(0.3)) {
        options.sizes.growth = dice.in(1.1, 1.6);
        words << ", growth " << options.sizes.growth;
    }
    if (dice.chance(0.25)) {
        options.carried_phases = {1};
        words << ", carried";
    }
    const auto wildness =
        dice.chance(0.3) ? dice.one_of(test::wildness_names) : test::Wildness::none;
    const test::RandomFlow flow(dice, 1, wildness);
    const Velocity<Real> velocity = flow.velocity<Real>();
    const double dt = h * std::pow(10.0, dice.in(-1.5, 0.3));
    std::unique_ptr<test::Data<Real>> data;
    if (dice.chance(0.4)) {
        data = std::make_unique<test::Data<Real>>(complex);
        complex.attributes.list().front()->set_field(dice.chance(0.5));
    }
    auto partitioner =
        test::random_partitioner<Real>(dice, dice.one_of(test::partition_families), words);
    SubmeshOptions submeshes =
        test::random_submesh_options(dice, dice.in(1, 2) == 1 ? 1 : 2, words);
    submeshes.ranks = ranks;
    submeshes.checks_ranks = true;
    Seen seen;
    Simulation<Real> simulation(
        complex, options,
        std::make_unique<SubmeshExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                std::move(partitioner), submeshes));
    const std::uint32_t listens = static_cast<std::uint32_t>(seed % 2); // rank 0, or rank 1
    if (ranks == nullptr || ranks->rank() == listens % ranks->size()) {
        simulation.add_listener([&](std::span<const Edit> some) {
            seen.edits.insert(seen.edits.end(), some.begin(), some.end());
        });
    }
    description = words.str();
    for (int step = 0; step < 6; ++step) {
        const StepReport report =
            simulation.step(velocity, static_cast<Real>(step * dt), static_cast<Real>(dt));
        seen.unreached.push_back(report.unreached);
        seen.events += report.events.size();
        seen.passes += report.passes;
        seen.ids.push_back(test::id_hash(complex));
        seen.data.push_back(data ? data->hash() : 0);
    }
    return seen;
}

template <class Real>
void expect_same_by_ranks(std::uint64_t seed) {
    std::string words;
    const Seen alone = simulate<Real>(seed, nullptr, words);
    const auto size = static_cast<std::uint32_t>(2 + seed % 3);
    std::vector<Seen> seen(size);
    std::vector<std::string> texts(size);
    const auto thrown = run_ranks(size, [&](Ranks& ranks) {
        seen[ranks.rank()] = simulate<Real>(seed, &ranks, texts[ranks.rank()]);
    });
    words += ", ranks " + std::to_string(size);
    if (thrown[0]) {
        try {
            std::rethrow_exception(thrown[0]);
        } catch (const std::exception& error) {
            FAIL() << words << ": " << error.what();
        }
    }
    for (Seen& one : seen) {
        if (one.edits.empty()) {
            one.edits = alone.edits; // another one listens
        }
        expect_same(alone, one, words);
    }
    const Seen& listener = seen[seed % 2 % size];
    EXPECT_EQ(listener.edits.size(), alone.edits.size()) << words;
}

void expect_same_of_seed(std::uint64_t seed) {
    if (seed % 5 == 4) {
        expect_same_by_ranks<float>(seed);
    } else {
        expect_same_by_ranks<double>(seed);
    }
}

TEST(RanksFuzz, RanksMakeTheSameEdits) {
    const std::uint64_t first = from_environment("DSC_FUZZ_FIRST", 1);
    const std::uint64_t count = from_environment("DSC_FUZZ_SEEDS", 16);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        expect_same_of_seed(seed);
        ASSERT_FALSE(HasFailure()) << "first failing seed: " << seed;
    }
}

// A vertex on its way vanished, and was then noted as one that had not arrived, by one rank alone.
TEST(RanksFuzz, NothingIsNotedOfTheDead) { expect_same_of_seed(1107); }

} // namespace
} // namespace dsc::ranks_fuzz_test
