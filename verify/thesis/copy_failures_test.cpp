// SPDX-License-Identifier: MIT
// Exceptions in a copied submesh are passed on, and leave a complex and a simulation that can
// continue; options that make no sense are refused.
#include "support/copy_testing.h"
#include "support/random/scene.h"

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>

namespace dsc::copy_failures_test {
namespace {

using test::everywhere;
using test::in_copies;

struct Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

TEST(CopyExecutor, PassesOnWhatAVelocityThrows) {
    constexpr double h = 0.03;
    auto complex = test::disc_complex<double>(h);
    Options<double> options;
    options.edge_length = h / 1.6; // upkeep splits the interface first
    auto simulation = in_copies(complex, options, {.submeshes = 4, .threads = 2});
    const std::uint32_t vertices = complex.vertex_count();
    const Velocity<double> bad = [](std::span<const Point<double>>, double,
                                    std::span<Point<double>>) { throw Fault("no velocity"); };
    EXPECT_THROW((void)simulation.step(bad, 0, 1), Fault);
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_GT(complex.vertex_count(), vertices);
    // What the split created is looked at in the next step, although nothing moves there.
    const auto rest = simulation.step(everywhere(0, 0), 0, 1).operations;
    EXPECT_EQ(rest.interface_splits, 0U);
    EXPECT_GT(rest.examined, 0U);
    EXPECT_EQ(simulation.step(everywhere(0.01, 0), 0, 1).unreached, 0U);
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
}

// A pass throws in some submesh of some round, before or after the others ran there. The step is
// lost, but not the simulation.
TEST(CopyExecutor, GoesOnAfterAPassThrew) {
    constexpr double h = 0.03;
    enum class Where { upkeep, red, black, whole };
    for (const Where where : {Where::upkeep, Where::red, Where::black, Where::whole}) {
        for (const bool before : {true, false}) {
            SCOPED_TRACE(std::to_string(static_cast<int>(where)) + (before ? ", first" : ", last"));
            auto complex = test::disc_complex<double>(h);
            Options<double> options;
            options.edge_length = h;
            // Slabs narrower than two edges leave all the work for the last run.
            const std::uint32_t n = where == Where::whole ? 30 : 6;
            std::atomic<bool> faulty{true};
            std::atomic<std::uint32_t> runs{0}; // of submeshes: counts their first passes
            std::atomic<int> thrown{0};
            const Pass<double> fault{
                "fault", [&](Work<double>& work) {
                    const bool is_whole = work.submesh.region.is_whole();
                    const std::uint32_t run = is_whole || work.epoch > 1 ? runs.load() : runs++;
                    const bool here = where == Where::upkeep || where == Where::whole
                                          ? is_whole
                                          : !is_whole && run == (where == Where::red ? 5 : n + 5);
                    if (faulty && here) {
                        ++thrown;
                        throw Fault("as seeded");
                    }
                }};
            auto algorithm = default_algorithm<double>();
            auto& passes = where == Where::upkeep ? algorithm.upkeep : algorithm.motion;
            passes.insert(before ? passes.begin() : passes.end(), fault);
            auto simulation =
                in_copies(complex, options, {.submeshes = n, .threads = 3}, algorithm);
            const std::uint64_t hash = mesh_hash(complex);
            EXPECT_THROW((void)simulation.step(everywhere(0.01, 0), 0, 1), Fault);
            EXPECT_GE(thrown, 1);
            if (where == Where::red || where == Where::upkeep) {
                EXPECT_EQ(mesh_hash(complex), hash) << "nothing was merged";
            } else if (where == Where::black) {
                EXPECT_NE(mesh_hash(complex), hash) << "red was merged";
            }
            EXPECT_EQ(validate(complex).problem, "");
            EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
            // A vertex that was on the way when the step was lost must not arrive in a later one.
            faulty = false;
            EXPECT_EQ(simulation.step(everywhere(0, 0), 0, 1).operations.moves, 0U);
            EXPECT_EQ(simulation.step(everywhere(0.01, 0), 0, 1).unreached, 0U);
            EXPECT_EQ(validate(complex).problem, "");
            EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
        }
    }
}

TEST(CopyExecutor, RefusesOptionsThatMakeNoSense) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    struct Seeded {
        const char* where;
        CopyOptions copy;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::array<Seeded, 7> faults{{
        {"submeshes", {.submeshes = 0}},
        {"submeshes", {.submeshes = 70000}},
        {"threads", {.threads = 0}},
        {"threads", {.threads = 5000}},
        {"normal", {.normal_x = 0}},
        {"normal", {.normal_y = 1}},
        {"normal", {.normal_x = nan}},
    }};
    for (const auto& fault : faults) {
        try {
            CopyExecutor<double> executor(complex, options, default_algorithm<double>(),
                                          fault.copy);
            ADD_FAILURE() << "accepted: " << fault.where;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), fault.where);
        }
    }
}

} // namespace
} // namespace dsc::copy_failures_test
