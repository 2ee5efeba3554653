// SPDX-License-Identifier: MIT
// Random scenes, options and divisions: coordinates, ids, data and edits are bitwise identical for
// any number of threads.
#include "fuzz/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>

namespace dsc::random_scenes_test {
namespace {

TEST(RandomScenes, AreTheSameForAnyNumberOfThreads) {
    constexpr std::uint64_t count = 60; // test_fuzz has more, without the thread sanitizer
    std::uint64_t edits = 0;
    std::size_t in_parallel = 0;
    for (std::uint64_t seed = 1; seed <= count && !HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937_64 random(1000 + seed); // other seeds than those of test_fuzz
        std::array<std::uint8_t, 1000> bytes;
        std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random() % 256); });
        fuzz::Steps done;
        EXPECT_NO_THROW(done = fuzz::try_steps(bytes));
        edits += done.edits;
        in_parallel += done.threads > 1 && done.submeshes > 2 ? 1 : 0;
    }
    EXPECT_GT(edits, 100 * count) << "hardly anything happened";
    EXPECT_GE(in_parallel, count / 8) << "hardly anything ran in parallel";
}

} // namespace
} // namespace dsc::random_scenes_test
