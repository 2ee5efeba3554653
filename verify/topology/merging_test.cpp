// SPDX-License-Identifier: MIT
// Two ends of a short edge merge, and what would be in the way is removed first.
#include "topology/junctions/merging.h"

#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dsc::merging_test {
namespace {

using P = Point<double>;

// v is (0.1, 0) and w the origin. Where v goes to w, the triangle of v, p and q becomes one of w,
// p and q, which lie on a line but for `height`; q is inside the phase, p is not.
Complex<double> with_sliver(double height) {
    const std::vector<P> points{{0.1, 0}, {0, 0},    {0.5, 0.5 + height}, {1, 1},
                                {0, -1},  {1, -0.5}, {-0.2, 1},           {-1, -0.3}};
    enum : std::uint32_t { v, w, q, p, e, f, g, i };
    const std::vector<std::array<std::uint32_t, 3>> triangles{{v, e, f}, {v, f, p}, {v, p, q},
                                                              {v, q, w}, {v, w, e}, {q, p, g},
                                                              {q, g, w}, {w, g, i}, {w, i, e}};
    return make_complex<double>(points, triangles, std::vector<Phase>(triangles.size(), 1));
}

double worst_quality(const Complex<double>& complex) {
    double worst = 1;
    for (const Triangle t : triangles(complex)) {
        worst = std::min(worst, quality(complex, t));
    }
    return worst;
}

Vertex merge(Complex<double>& complex, bool either) {
    const TopologyOptions<double> options;
    std::vector<Event> events;
    TopologyWork<double> work{
        .complex = complex, .options = options, .edge_length = 1, .time = 0, .events = events};
    const Vertex left = merge_ends(work, Vertex{0}, Vertex{1}, either);
    EXPECT_EQ(validate(complex).problem, "");
    return left;
}

TEST(Merging, RemovesAVertexThatWouldLeaveASliver) {
    for (const double height : {0.0, 1e-9}) { // on the line the triangle would have no area
        auto complex = with_sliver(height);
        EXPECT_EQ(merge(complex, false), Vertex{1});
        EXPECT_EQ(complex.vertex_count(), 6U);
        EXPECT_GT(worst_quality(complex), 0.05);
    }
}

TEST(Merging, TakesThePlaceThatLeavesTheBetterTriangles) {
    auto complex = with_sliver(1e-9);
    EXPECT_EQ(merge(complex, true), Vertex{0});
    EXPECT_EQ(complex.vertex_count(), 7U);
    EXPECT_GT(worst_quality(complex), 0.05);
}

TEST(Merging, LeavesEverythingInPlaceWhereAVertexIsLocked) {
    auto complex = with_sliver(0.1);
    complex.set_locked(Vertex{0}, true);
    EXPECT_FALSE(merge(complex, false).is_valid());
    EXPECT_EQ(complex.vertex_count(), 8U);
}

// The curves from v to p and to f sweep a triangle each, of 0.1 along the abscissa and the height
// of their other end.
TEST(Merging, NotesTheAreaThatCurvesSweep) {
    auto complex = with_sliver(0.1);
    constexpr std::array<Phase, 9> phases{1, 2, 3, 3, 1, 3, 3, 4, 1};
    for (std::uint32_t t = 0; t < 9; ++t) {
        complex.set_phase(Triangle{t + 1}, phases[t]);
    }
    const TopologyOptions<double> options;
    std::vector<Event> events;
    TopologyWork<double> work{
        .complex = complex, .options = options, .edge_length = 1, .time = 0, .events = events};
    ASSERT_EQ(merge_ends(work, Vertex{0}, Vertex{1}, false), Vertex{1});
    EXPECT_NEAR(work.swept, 0.1 * 1 / 2 + 0.1 * 0.5 / 2, 1e-12);
}

} // namespace
} // namespace dsc::merging_test
