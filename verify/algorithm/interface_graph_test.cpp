// SPDX-License-Identifier: MIT
// The neighbours of interface vertices along the interface: in loops, at holes and junctions, and
// at the domain boundary.
#include "dsc/algorithm/interface_sight.h"

#include "support/interface_view_testing.h"
#include "support/random/scene.h"
#include "support/small_meshes.h"

#include "dsc/passes/interface/list.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::interface_graph_test {
namespace {

// A graph of a complex, with the positions of its vertices.
struct Seen {
    explicit Seen(Complex<double>& complex_in) : Seen(complex_in, collect_interface(complex_in)) {}
    Seen(Complex<double>& complex_in, const std::vector<std::uint32_t>& list_in)
        : complex(complex_in), list(list_in) {
        test::build(graph, complex, list);
        for (const std::uint32_t v : list) {
            positions.push_back(complex.position(Vertex{v}));
        }
    }
    [[nodiscard]] InterfaceView<double> view() const { return graph.view(complex, positions); }
    [[nodiscard]] std::size_t index_of(std::uint32_t vertex) const {
        return static_cast<std::size_t>(std::ranges::find(list, vertex) - list.begin());
    }

    Complex<double>& complex;
    std::vector<std::uint32_t> list;
    InterfaceGraph<double> graph;
    std::vector<Point<double>> positions;
};

// The vertices of the closed curve through i, and the area that it has on its left.
struct Loop {
    std::size_t vertices = 0;
    double area = 0;
};
Loop loop_through(const InterfaceView<double>& view, std::size_t i) {
    Loop loop;
    std::size_t at = i;
    do {
        const Point<double>& p = view.positions[at];
        const Point<double>& q = view.positions[view.next[at]];
        loop.area += (p.x() * q.y() - p.y() * q.x()) / 2;
        ++loop.vertices;
        at = view.next[at];
    } while (at != i && loop.vertices <= view.size());
    return loop;
}

TEST(InterfaceGraph, ClosedCurvesGoRoundTheLargerPhase) {
    const std::vector<Shape> shapes{{test::circle_points({0.5, 0.5}, 0.4, 60), 1},
                                    {test::circle_points({0.5, 0.5}, 0.2, 30), exterior_phase},
                                    {test::circle_points({0.5, 0.5}, 0.1, 20), 2}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = 0.05});
    const Seen seen(complex);
    const auto view = seen.view();
    EXPECT_EQ(test::view_fault(view), "");
    EXPECT_TRUE(view.junctions.empty());
    std::vector<std::size_t> sizes{0, 0, 0};
    for (std::size_t i = 0; i < view.size(); ++i) {
        const double radius = (view.positions[i] - Point<double>(0.5, 0.5)).norm();
        const std::size_t which = radius > 0.3 ? 0 : (radius > 0.15 ? 1 : 2);
        const double sign = which == 1 ? -1 : 1;
        const Loop loop = loop_through(view, i);
        sizes[which] = loop.vertices;
        EXPECT_NEAR(loop.area, sign * std::numbers::pi * radius * radius, 0.01);
        EXPECT_EQ(view.left[i], which == 2 ? 2U : 1U);
        EXPECT_EQ(view.right[i], exterior_phase);
        // Out of the larger phase: away from the middle, but at the hole.
        const Point<double> outwards =
            sign * (view.positions[i] - Point<double>(0.5, 0.5)) / radius;
        EXPECT_GT(normal(view, i).dot(outwards), 0.99);
        EXPECT_NEAR(curvature(view, i), sign / radius, 1e-6 / radius);
    }
    EXPECT_EQ(sizes[0] + sizes[1] + sizes[2], view.size());
}

// Six triangles about vertex 0; triangle i lies between the vertices i + 1 and i + 2.
Complex<double> fan_of(const std::array<Phase, 6>& phases) {
    auto complex = test::hexagon<double>();
    for (std::uint32_t i = 0; i < 6; ++i) {
        complex.set_phase(Triangle{i + 1}, phases.at(i));
    }
    return complex;
}

TEST(InterfaceGraph, AJunctionHasArmsCounterClockwise) {
    auto complex = fan_of({1, 1, 2, 2, 3, 3});
    const Seen seen(complex);
    const auto view = seen.view();
    ASSERT_EQ(test::view_fault(view), "");
    ASSERT_EQ(view.size(), 7U);
    const std::size_t middle = seen.index_of(0);
    EXPECT_EQ(view.next[middle], no_id);
    EXPECT_EQ(view.previous[middle], no_id);
    EXPECT_FALSE(view.is_on_boundary(middle));
    const auto arms = arms_of(view, middle);
    ASSERT_EQ(arms.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(arms[k].left, arms[(k + 1) % 3].right) << "arm " << k;
    }
    for (const Phase phase : {1U, 2U, 3U}) {
        EXPECT_TRUE(borders_on(view, middle, phase));
    }
    EXPECT_FALSE(borders_on(view, middle, 0));
    EXPECT_DOUBLE_EQ(length(view, middle), 1.5);
    EXPECT_EQ(normal(view, middle), Point<double>(0, 0));
    EXPECT_EQ(curvature(view, middle), 0);

    // Where two phases meet at the side of the domain three edges do; in between there is a curve
    // with the outside on its right.
    for (std::uint32_t v = 1; v <= 6; ++v) {
        const std::size_t i = seen.index_of(v);
        EXPECT_TRUE(view.is_on_boundary(i));
        EXPECT_EQ(view.is_junction(i), v % 2 == 1) << v;
        EXPECT_EQ(arms_of(view, i).size(), v % 2 == 1 ? 3U : 0U) << v;
        if (v % 2 == 0) {
            EXPECT_EQ(view.left[i], v / 2);
            EXPECT_EQ(view.right[i], border_phase);
            EXPECT_EQ(view.vertices[view.next[i]], Vertex{v % 6 + 1});
        }
    }
}

TEST(InterfaceGraph, WhereACurveMeetsTheDomainBoundaryIsAJunction) {
    auto complex = fan_of({1, 1, 1, 0, 0, 0});
    const Seen seen(complex);
    const auto view = seen.view();
    ASSERT_EQ(test::view_fault(view), "");
    EXPECT_EQ(view.size(), 5U); // the boundary of phase 0 is no interface
    const std::size_t middle = seen.index_of(0);
    EXPECT_EQ(view.vertices[view.previous[middle]], Vertex{4});
    EXPECT_EQ(view.vertices[view.next[middle]], Vertex{1});
    for (const std::uint32_t v : {1U, 4U}) {
        const std::size_t i = seen.index_of(v);
        EXPECT_TRUE(view.is_junction(i));
        EXPECT_TRUE(view.is_on_boundary(i));
        ASSERT_EQ(arms_of(view, i).size(), 2U);
        EXPECT_TRUE(borders_on(view, i, 1) && borders_on(view, i, 0));
    }
}

TEST(InterfaceGraph, TwoSheetsThatTouchAreAJunction) {
    auto complex = fan_of({1, 0, 0, 1, 0, 0});
    const Seen seen(complex);
    const auto view = seen.view();
    EXPECT_EQ(test::view_fault(view), "");
    EXPECT_EQ(arms_of(view, seen.index_of(0)).size(), 4U);
}

TEST(InterfaceGraph, CornersAndLocksAreMarked) {
    auto complex = test::disc_complex<double>(0.1);
    const auto list = collect_interface(complex);
    complex.vertices[list[2]].flags |= vertex_feature;
    complex.set_locked(Vertex{list[3]}, true);
    const Seen seen(complex, list);
    const auto view = seen.view();
    EXPECT_EQ(test::view_fault(view), "");
    EXPECT_TRUE(view.is_feature(2));
    EXPECT_FALSE(view.is_feature(3));
    EXPECT_EQ(view.flags[3], interface_locked);
    EXPECT_EQ(view.flags[4], 0);
}

} // namespace
} // namespace dsc::interface_graph_test
