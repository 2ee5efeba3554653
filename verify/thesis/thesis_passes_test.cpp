// SPDX-License-Identifier: MIT
// The passes of the thesis's algorithm, each on a mesh where only that pass has work: its effect,
// and the vertices that it activates.
#include "thesis/algorithm/thesis_algorithm.h"

#include "support/simulation_testing.h"
#include "support/small_meshes.h"

#include "dsc/complex/ranges.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace dsc::thesis_passes_test {
namespace {

using test::options_for;

void run_pass_named(Work<double>& work, std::string_view name, const ThesisThresholds& thresholds) {
    const auto algorithm = thesis_algorithm<double>(work.options, thresholds);
    for (const auto* passes : {&algorithm.remeshing, &algorithm.motion}) {
        const auto pass = std::ranges::find(*passes, name, &Pass<double>::name);
        if (pass != passes->end()) {
            pass->run(work);
            return;
        }
    }
    FAIL() << "no pass is named " << name;
}

// The disc turns by less than 30 degrees at each vertex, and by more than 5.
TEST(ThesisPasses, SmoothingOfTheInterfaceWakesWhatItMovesAndKeepsCorners) {
    for (const double feature_degrees : {5.0, 40.0}) {
        auto complex = test::disc_complex<double>(0.1);
        auto options = options_for<double>(0.1);
        options.interface.feature_degrees = feature_degrees;
        Work<double> work(complex, options);
        work.epoch = 1;
        work.log.readers = 1;
        work.interface = collect_interface(complex);
        // Moves a vertex away from the middle between its neighbours.
        const Vertex off{work.interface.front()};
        const Vertex next{work.interface[1]};
        complex.set_position(off, complex.position(off) +
                                      0.2 * (complex.position(next) - complex.position(off)));
        run_pass_named(work, "interface smoothing", {.smooth_interface = true});
        EXPECT_EQ(work.log.counts.smoothed > 0, feature_degrees > 30) << feature_degrees;
        std::size_t moved = 0;
        for (const Edit& edit : work.log.records) {
            if (edit.kind == EditKind::move) {
                ++moved;
                EXPECT_EQ(complex.vertices[edit.vertex.id].stamp, work.epoch);
            }
        }
        EXPECT_EQ(work.log.counts.smoothed, moved);
        EXPECT_EQ(work.active.size(), moved);
    }
}

// Only a vertex close to the domain boundary is active; the triangle between it and the boundary is
// far too small.
TEST(ThesisPasses, RetriangulationWakesTheCornersThatAreLeft) {
    auto complex = test::grid<double>(6);
    constexpr std::uint32_t close = 7 + 1;
    complex.set_position(Vertex{close}, {1, 0.15});
    const auto options = options_for<double>(1);
    Work<double> work(complex, options);
    work.epoch = 1;
    work.activate(close);
    run_pass_named(work, "coarsening: local retriangulation", {});
    ASSERT_GT(work.log.counts.retriangulations, 0U);
    EXPECT_FALSE(complex.is_alive(Vertex{close}));
    EXPECT_GT(work.active.size(), 1U);
    // Only boundary vertices stay.
    for (const std::uint32_t v : work.active) {
        const Point<double> p = complex.position(Vertex{v});
        EXPECT_TRUE(v == close || p.x() == 0 || p.y() == 0) << p.transpose();
    }
}

TEST(ThesisPasses, FlipsRepairWhatIsNotDelaunayAndNothingElse) {
    // Two triangles with the longer diagonal of a rhombus, which must be flipped, and two more that
    // are Delaunay.
    auto complex = test::build<double>({{0, 0}, {1, -0.4}, {2, 0}, {1, 0.4}, {1, 3}},
                                       {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {0, 3, 4}}, {0, 0, 0, 0});
    const auto options = options_for<double>(1);
    Work<double> work(complex, options);
    work.epoch = 1;
    for (const Vertex v : vertices(complex)) {
        work.activate(v.id);
    }
    run_pass_named(work, "optimization: edge flip", {});
    EXPECT_EQ(work.log.counts.flips, 1U);
    for (const Edge e : edges(complex)) {
        EXPECT_TRUE(is_border(complex.twin(e.id)) || is_delaunay(complex, e.id));
    }
}

} // namespace
} // namespace dsc::thesis_passes_test
