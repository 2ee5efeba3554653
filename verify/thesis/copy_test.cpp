// SPDX-License-Identifier: MIT
// Parallel DSC as printed (thesis, algorithm 6.3), in copied submeshes: no work deferred at a
// boundary is lost. An exception in a copy is passed on, and leaves a complex and a simulation that
// can continue.
#include "dsc/complex/gather.h"
#include "thesis/copies/copy_executor.h"

#include "support/copy_testing.h"
#include "support/random/scene.h"
#include "support/refusal.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <atomic>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dsc::copy_test {
namespace {

using test::constant;
using test::in_copies;

// In some round, every active and every moving vertex is in a submesh that owns its star, with its
// own target: none is missed or processed twice, whichever boundaries it lies on.
TEST(CopyExecutor, HandsOnWhatBoundariesKeepFromBeingDone) {
    constexpr double h = 0.03;
    const Point<double> way(0.002, 0.001);
    for (const std::uint32_t n : {1U, 2U, 8U, 40U}) {
        SCOPED_TRACE("submeshes " + std::to_string(n));
        auto complex = test::disc_complex<double>(h);
        Options<double> options;
        options.edge_length = h;
        using Place = std::pair<double, double>;
        std::mutex mutex;
        std::map<Place, int> looked_at;
        std::map<Place, int> moved;
        int threads = 0; // at most at once
        Algorithm<double> algorithm;
        algorithm.remeshing.push_back({"activate all", [](Work<double>& work) {
                                           for (std::uint32_t v = 0;
                                                v < work.complex.vertex_bound(); ++v) {
                                               work.activate(v);
                                           }
                                       }});
        algorithm.motion.push_back(
            {"note", [&](Work<double>& work) {
                 const std::lock_guard lock(mutex);
                 threads = std::max(threads, omp_get_num_threads());
                 const auto owns_star = [&](std::uint32_t v) {
                     return gather(work.complex, work.submesh.region, v, work.star) &&
                            work.star.owned;
                 };
                 const auto place = [&](std::uint32_t v) {
                     return Place(work.complex.vertices[v].x, work.complex.vertices[v].y);
                 };
                 for (const std::uint32_t v : work.active) {
                     if (owns_star(v)) {
                         ++looked_at[place(v)];
                     } else {
                         work.deferred.star(v);
                     }
                 }
                 for (const auto& moving_vertex : work.moving_vertices) {
                     if (owns_star(moving_vertex.vertex)) {
                         ++moved[place(moving_vertex.vertex)];
                         const auto p = work.complex.position(Vertex{moving_vertex.vertex});
                         EXPECT_LT(
                             (p + way - Point<double>(moving_vertex.x, moving_vertex.y)).norm(),
                             1e-12);
                     } else {
                         work.deferred.moving_vertex(moving_vertex);
                     }
                 }
                 work.active.clear();
                 work.moving_vertices.clear();
             }});
        CopyExecutor<double> executor(complex, options, algorithm, {.submeshes = n, .threads = 2});
        (void)executor.compute_targets(constant<double>(way.x(), way.y()), 0, 1);
        EXPECT_EQ(executor.move().unreached, 0U);
        EXPECT_EQ(looked_at.size(), complex.vertex_count());
        EXPECT_EQ(moved.size(), executor.interface_size());
        for (const auto* done : {&looked_at, &moved}) {
            for (const auto& [place, times] : *done) {
                EXPECT_EQ(times, 1) << "at " << place.first << ", " << place.second;
            }
        }
        EXPECT_EQ(executor.costs().rounds, n > 1 ? 2U : 1U);
        EXPECT_EQ(threads, n > 1 ? 2 : 1);
    }
}

// If submeshes run out of ids for new vertices, the rest of the work is deferred and done later.
TEST(CopyExecutor, GoesOnWhereIdsRunOut) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.004;
    options.interface.longest = 20; // no new interface vertices, so submeshes get fewer ids
    std::atomic<int> ran_out{0};
    auto algorithm = default_algorithm<double>();
    algorithm.motion.push_back(
        {"look", [&](Work<double>& work) {
             ran_out += work.submesh.pool->vertices.empty() && !work.submesh.pool->may_grow ? 1 : 0;
         }});
    auto simulation = in_copies(complex, options, {.submeshes = 2}, algorithm);
    for (int step = 0; step < 6; ++step) {
        (void)simulation.step(constant<double>(0.004, 0.003), 0, 1);
        test::expect_sound(complex, simulation);
    }
    EXPECT_GT(ran_out, 0);
    auto alone = test::disc_complex<double>(0.05);
    Simulation<double> sequential(alone, options);
    for (int step = 0; step < 6; ++step) {
        (void)sequential.step(constant<double>(0.004, 0.003), 0, 1);
    }
    EXPECT_NEAR(complex.vertex_count(), alone.vertex_count(), 0.1 * alone.vertex_count());
}

// --- failures ------------------------------------------------------------------------------------
struct Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A pass throws in some submesh of some round, before or after the others ran there. The step is
// lost, but not the simulation.
TEST(CopyExecutor, GoesOnAfterAPassThrew) {
    constexpr double h = 0.03;
    enum class Where { remeshing, red, black, whole };
    for (const Where where : {Where::remeshing, Where::red, Where::black, Where::whole}) {
        for (const bool before : {true, false}) {
            SCOPED_TRACE(std::to_string(static_cast<int>(where)) + (before ? ", first" : ", last"));
            auto complex = test::disc_complex<double>(h);
            Options<double> options;
            options.edge_length = h;
            // Slabs narrower than two edges defer all work to the last, serial run.
            const std::uint32_t n = where == Where::whole ? 30 : 6;
            std::atomic<bool> faulty{true};
            std::atomic<std::uint32_t> runs{0}; // runs of submeshes, counted by their first passes
            std::atomic<int> thrown{0};
            const Pass<double> fault{
                "fault", [&](Work<double>& work) {
                    const bool is_whole = work.submesh.region.is_whole();
                    const std::uint32_t run = is_whole || work.epoch > 1 ? runs.load() : runs++;
                    const bool here = where == Where::remeshing || where == Where::whole
                                          ? is_whole
                                          : !is_whole && run == (where == Where::red ? 5 : n + 5);
                    if (faulty && here) {
                        ++thrown;
                        throw Fault("as seeded");
                    }
                }};
            auto algorithm = default_algorithm<double>();
            auto& passes = where == Where::remeshing ? algorithm.remeshing : algorithm.motion;
            passes.insert(before ? passes.begin() : passes.end(), fault);
            auto simulation =
                in_copies(complex, options, {.submeshes = n, .threads = 3}, algorithm);
            const std::uint64_t hash = mesh_hash(complex);
            EXPECT_THROW((void)simulation.step(constant<double>(0.01, 0), 0, 1), Fault);
            EXPECT_GE(thrown, 1);
            if (where == Where::red || where == Where::remeshing) {
                EXPECT_EQ(mesh_hash(complex), hash) << "nothing was merged";
            } else if (where == Where::black) {
                EXPECT_NE(mesh_hash(complex), hash) << "red was merged";
            }
            test::expect_sound(complex, simulation);
            // A vertex that was moving when the step failed must not arrive in a later one.
            faulty = false;
            EXPECT_EQ(simulation.step(constant<double>(0, 0), 0, 1).operations.moves, 0U);
            EXPECT_EQ(simulation.step(constant<double>(0.01, 0), 0, 1).unreached, 0U);
            test::expect_sound(complex, simulation);
        }
    }
}

TEST(CopyExecutor, RefusesOptionsThatMakeNoSense) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::pair<std::string, CopyOptions>> faults{
        {"submeshes", {.submeshes = 0}}, {"submeshes", {.submeshes = 70000}},
        {"threads", {.threads = 0}},     {"threads", {.threads = 5000}},
        {"normal", {.normal_x = 0}},     {"normal", {.normal_y = 1}},
        {"normal", {.normal_x = nan}}};
    for (const auto& fault : faults) {
        test::expect_refusal([&] { (void)in_copies(complex, options, fault.second); }, fault.first);
    }
}

} // namespace
} // namespace dsc::copy_test
