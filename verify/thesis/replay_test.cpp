// SPDX-License-Identifier: MIT
// Replay of logs with the operations of the thesis in them.
#include "thesis/replay.h"

#include "support/courses.h"

#include "dsc/queries/validate.h"
#include "thesis/local_retriangulation.h"
#include "thesis/thesis_algorithm.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace dsc::thesis_replay_test {
namespace {

using namespace test;

TEST(ThesisLogs, OfRetriangulationAndSubdivisionAreReplayed) {
    Complex<double> complex = disc();
    const Complex<double> first = complex;
    const Options<double> options{.edge_length = 0.8 * disc_h};
    std::vector<Edit> edits;
    Simulation<double> simulation(
        complex, options,
        std::make_unique<Executor<double>>(
            complex, options,
            thesis_algorithm<double>(options, {.small_area = 0.6, .smooth_interface = true})));
    simulation.add_listener(
        [&](std::span<const Edit> some) { edits.insert(edits.end(), some.begin(), some.end()); });
    OperationCounts counts;
    for (int step = 0; step < 12; ++step) {
        counts += simulation.step(swirl, 0.04 * step, 0.04).operations;
    }
    EXPECT_GT(counts.subdivisions, 0U);
    EXPECT_GT(counts.retriangulations, 0U);
    Complex<double> again = first;
    EXPECT_EQ(replay<double>(again, edits, repeat_edit<double>).skipped, 0U);
    EXPECT_EQ(mesh_hash(again), mesh_hash(complex));
}

// Locks are no edits: a log does not say that the application took one off.
TEST(ThesisLogs, OfVerticesThatWereUnlockedAreReplayed) {
    Complex<double> complex = disc();
    Triangle t{1};
    while (local_retriangulation_guard(complex, t) != Verdict::legal) {
        ++t.id;
    }
    const auto corners = complex.vertices_of(t);
    for (const Vertex v : corners) {
        complex.set_locked(v, true);
    }
    Complex<double> again = complex;
    complex.journal.readers = 1;
    EXPECT_EQ(local_retriangulation(complex, t).verdict, Verdict::locked);
    for (const Vertex v : corners) {
        complex.set_locked(v, false);
    }
    EXPECT_EQ(local_retriangulation(complex, t).verdict, Verdict::legal);
    EXPECT_EQ(replay<double>(again, complex.journal.records, repeat_edit<double>).skipped, 0U);
    EXPECT_EQ(mesh_hash(again), mesh_hash(complex));
}

// As in a file that is damaged.
TEST(ThesisLogs, WithIdsThatNoRunHasAreSkipped) {
    const Complex<double> first = disc();
    const auto [a, b, c] = first.vertices_of(Triangle{1});
    for (const std::uint32_t id : {0U, 1'000'000'000U}) {
        const Edit edit{.kind = EditKind::insert_triangle,
                        .corner = 4 * id,
                        .ends = {a, b},
                        .apexes = {c, {}},
                        .made = {no_id, 1}};
        Complex<double> again = first;
        EXPECT_EQ(replay<double>(again, std::span(&edit, 1), repeat_edit<double>).skipped, 1U);
        EXPECT_EQ(mesh_hash(again), mesh_hash(first));
        EXPECT_EQ(validate(again).problem, "");
    }
}

} // namespace
} // namespace dsc::thesis_replay_test
