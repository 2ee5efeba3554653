// SPDX-License-Identifier: MIT
// Changes of topology on meshes so small that what must happen can be read off them.
#include "topology/change.h"

#include "support/small_meshes.h"

#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"
#include "topology/junctions/sectors.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace dsc::by_hand_test {
namespace {

std::vector<Suspect<double>> all_vertices(const Complex<double>& complex) {
    std::vector<Suspect<double>> suspects;
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        suspects.push_back({p.x(), p.y(), v.id, true, true, true, true});
    }
    return suspects;
}

double area_of_phase(const Complex<double>& complex, Phase phase) {
    double sum = 0;
    for (const Triangle t : triangles(complex, phase)) {
        sum += area(complex, t);
    }
    return sum;
}

// A square of two halves in phases 2 and 3, and one triangle of phase 1 between them, two of whose
// edges border on phase 2.
TEST(ByHand, ASmallPieceGoesToWhomItBordersOnMost) {
    for (const Phase most : {Phase{2}, Phase{3}}) {
        auto complex = test::grid<double>(4);
        const Phase least = most == 2 ? 3 : 2;
        const Triangle piece = *triangles(complex).begin();
        for (const Triangle t : triangles(complex)) {
            complex.set_phase(t, most);
        }
        // One in the middle, and the neighbour across a single short edge of it.
        Triangle middle = piece;
        for (const Triangle t : triangles(complex)) {
            const auto v = complex.vertices_of(t);
            const Point<double> centre =
                (complex.position(v[0]) + complex.position(v[1]) + complex.position(v[2])) / 3;
            if ((centre - Point<double>(1.7, 1.7)).norm() < 0.3) {
                middle = t;
            }
        }
        complex.set_phase(middle, 1);
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(middle.id, i);
            if (length(complex, complex.edge(c)) < 1.1) {
                complex.set_phase(Triangle{triangle_of(complex.twin(c))}, least);
                break;
            }
        }
        TopologyOptions<double> options;
        options.rule = Topology::change;
        options.contact = 1e-3; // no film is as thin
        options.least_area = 0.6;
        // That of the neighbour alone is as small: it may not vanish first.
        options.pairs = {{.one = 2, .other = 3, .rule = Topology::keep}};
        std::vector<Event> events;
        const double before = area_of_phase(complex, most);
        std::vector<Suspect<double>> suspects = all_vertices(complex);
        change_topology<double>(complex, options, 1.0, suspects, 0, events);
        EXPECT_EQ(area_of_phase(complex, 1), 0);
        EXPECT_NEAR(area_of_phase(complex, most), before + 0.5, 1e-12);
    }
}

TEST(ByHand, AnglesAreCounterClockwiseUpToAFullTurn) {
    using std::numbers::pi;
    const Point<double> right(1, 0);
    EXPECT_NEAR(angle_between<double>(right, {0, 1}), pi / 2, 1e-15);
    EXPECT_NEAR(angle_between<double>(right, {0, -1}), 3 * pi / 2, 1e-15);
    EXPECT_NEAR(angle_between<double>(right, {1, 0}), 2 * pi, 1e-15);
}

} // namespace
} // namespace dsc::by_hand_test
