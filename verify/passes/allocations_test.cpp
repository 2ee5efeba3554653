// SPDX-License-Identifier: MIT
// A step allocates nothing once its lists have grown: what it needs is kept from step to step. The
// program's own operator new counts.
#include "support/simulation_testing.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::uint64_t> allocations = 0;
} // namespace

// Not inlined: GCC 12 would see memory of `new` go to `free`, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    if (void* const memory = std::malloc(size > 0 ? size : 1)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}

namespace dsc::allocations_test {
namespace {

using test::disc_complex;
using test::options_for;

TEST(Allocations, AreNotMadeInAStep) {
    auto complex = disc_complex<double>(test::coarse);
    const auto options = options_for<double>(test::coarse);
    Simulation<double> simulation(complex, options);
    // There and back, so that no list becomes longer than it was.
    const auto flow = test::constant<double>(0.2 * test::coarse, 0);
    const auto back = test::constant<double>(-0.2 * test::coarse, 0);
    std::uint64_t counted = 0;
    std::uint64_t examined = 0;
    for (int step = 0; step < 80; ++step) {
        const std::uint64_t before = allocations;
        const StepReport report = simulation.step(step / 10 % 2 == 0 ? flow : back, 0, 1);
        if (step >= 40) {
            counted += allocations - before;
            examined += report.operations.examined;
        }
    }
    EXPECT_GT(examined, 2'000U);
    // Some for the test's own flow, a few where a list grows after all.
    EXPECT_LE(counted, examined / 50);
}

} // namespace
} // namespace dsc::allocations_test
