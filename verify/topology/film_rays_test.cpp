// SPDX-License-Identifier: MIT
// Rays across a film, chords, and the region that they make up, on small grids.
#include "support/small_meshes.h"
#include "support/topology/topology_testing.h"

#include "dsc/geometry/predicates.h"
#include "dsc/queries/validate.h"
#include "topology/films/chords.h"
#include "topology/films/film_ray.h"
#include "topology/films/film_region.h"

#include <algorithm>
#include <optional>

namespace dsc::film_rays_test {
namespace {

// A band of phase 0 from y = 1 to y = 4 between phase 1 and phase 2.
Complex<double> band() {
    return test::grid({-4, 1, 2, 7}, {0, 1, 1.75, 2.5, 4, 5}, [](const Point<double>& p) {
        return p.y() < 1 ? Phase{1} : (p.y() > 4 ? Phase{2} : exterior_phase);
    });
}

// The half-edge of the film at y = 1 that begins at x = 1.
Corner lower_sheet(const Complex<double>& complex) {
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (complex.phase(t) == exterior_phase && is_sheet(complex, c) &&
                complex.phase_at(complex.twin(c)) == 1 &&
                complex.position(Vertex{complex.vertex(next(c))}).x() == 1) {
                return c;
            }
        }
    }
    return no_id;
}

TEST(FilmRay, CrossesTheFilm) {
    const auto complex = band();
    const Corner sheet = lower_sheet(complex);
    ASSERT_NE(sheet, no_id);
    double reached = 0;
    const FilmRay<double> ray =
        cross_film(complex, sheet, 3.5, [&](Triangle t, double from, double to) {
            EXPECT_EQ(complex.phase(t), exterior_phase);
            EXPECT_EQ(from, reached);
            EXPECT_GE(to, from);
            reached = to;
        });
    ASSERT_NE(ray.opposite, no_id);
    EXPECT_EQ(complex.phase_at(complex.twin(ray.opposite)), 2U);
    EXPECT_DOUBLE_EQ(ray.thickness, 3);
    EXPECT_EQ(reached, ray.thickness);
    EXPECT_DOUBLE_EQ(ray.middle.x(), 1.5);
    EXPECT_DOUBLE_EQ(ray.middle.y(), 2.5);
}

TEST(FilmRay, EndsAtItsLengthAndAtTheWall) {
    const auto complex = band();
    const auto nothing = [](Triangle, double, double) {};
    const Corner sheet = lower_sheet(complex);
    EXPECT_EQ(cross_film(complex, sheet, 2.9, nothing).opposite, no_id);
    EXPECT_EQ(cross_film(complex, complex.twin(sheet), 9.0, nothing).opposite, no_id);
}

// What a change of the topology works on, at an edge length of 1.
struct Work {
    explicit Work(Complex<double>& complex, double contact) {
        options = test::changing();
        options.contact = contact;
        work.emplace(TopologyWork<double>{
            .complex = complex, .options = options, .edge_length = 1, .time = 0, .events = events});
    }
    TopologyOptions<double> options;
    std::vector<Event> events;
    std::optional<TopologyWork<double>> work;
};

// The same with an upper sheet that rises by `rise` above the lower one.
Complex<double> wedge(double rise) {
    const std::vector<std::vector<Point<double>>> rows{
        {{0, 0}, {1, 0}, {2, 0}, {3, 0}},
        {{0, 1}, {1, 1}, {2, 1}, {3, 1}},
        {{0, 2}, {1, 2}, {2, 2 + rise}, {3, 2 + rise}},
        {{0, 9}, {1, 9}, {2, 9}, {3, 9}}};
    return test::cells_of(rows, [rise](const Point<double>& p) {
        const double top = 2 + rise * std::clamp(p.x() - 1, 0.0, 1.0);
        return p.y() < 1 ? Phase{1} : (p.y() > top ? Phase{2} : exterior_phase);
    });
}

TEST(Chord, EndsOnASheetThatFacesIt) {
    auto gentle = wedge(2);
    Work work(gentle, 4);
    EXPECT_DOUBLE_EQ(find_chord(*work.work, lower_sheet(gentle)).ray.thickness, 2);
    auto steep = wedge(5);
    Work other(steep, 4);
    EXPECT_EQ(find_chord(*other.work, lower_sheet(steep)).ray.opposite, no_id);
}

TEST(Chord, IsShorterThanTheContactDistanceOfBothSheets) {
    auto complex = band();
    for (const double contact : {2.9, 3.1}) {
        Work work(complex, contact);
        EXPECT_EQ(find_chord(*work.work, lower_sheet(complex)).ray.opposite != no_id, contact > 3);
        work.options.pairs = {
            {.one = 0, .other = 2, .rule = Topology::change, .contact = 6 - contact}};
        EXPECT_EQ(find_chord(*work.work, lower_sheet(complex)).ray.opposite, no_id);
    }
}

// The ray passes one of the four triangles of each cell by; it would stay behind as a notch.
TEST(FilmRegion, HasNoNotches) {
    auto complex = band();
    Work work(complex, 4);
    FilmRegion<double> region(*work.work, exterior_phase, 4);
    region.add_ray(lower_sheet(complex));
    region.fill();
    for (const Triangle t : triangles(complex)) {
        const Point<double> p = centroid(complex, t);
        if (p.x() > 1 && p.x() < 2 && complex.phase(t) == exterior_phase) {
            EXPECT_TRUE(region.contains(t)) << p.x() << ", " << p.y();
        }
    }
}

// Each phase takes what is nearer to its sheet.
TEST(FilmRegion, IsDividedHalfway) {
    auto complex = band();
    Work work(complex, 4);
    FilmRegion<double> region(*work.work, exterior_phase, 4);
    region.add_ray(lower_sheet(complex));
    const double area = region.give_all();
    double one = 0;
    double two = 0;
    for (const Triangle t : triangles(complex)) {
        const Point<double> p = centroid(complex, t);
        if (p.x() > 1 && p.x() < 2 && p.y() > 1 && p.y() < 4) {
            const double its = doubled_area(complex, t) / 2;
            one += complex.phase(t) == 1 ? its : 0;
            two += complex.phase(t) == 2 ? its : 0;
            EXPECT_TRUE(complex.phase(t) != 1 || p.y() < 2.5) << p.y();
            EXPECT_TRUE(complex.phase(t) != 2 || p.y() > 2.5) << p.y();
        }
    }
    EXPECT_GT(one, 0.5);
    EXPECT_GT(two, 0.5);
    EXPECT_DOUBLE_EQ(one + two, area);
}

// Vertex 0 lies on the left of the line from vertex 1 to vertex 2, by less than the rounding of a
// product; the middle between these two lies on its right, where the sign of the product says left.
TEST(FilmRegion, IsStraightenedOnlyToWhereNoTriangleIsTurnedOver) {
    const std::vector<Point<double>> points{{0x1.d244a038274dcp-2, 0x1.d30c0e5967d9bp-2},
                                            {0x1.2785a781dd289p-3, 0x1.2f23ee84f2e01p-3},
                                            {0x1.88633657b0033p-1, 0x1.874312b82b214p-1},
                                            {0.3, 0.61},
                                            {0.64, 0.27},
                                            {0.58, 0.95},
                                            {-0.04, 0.33}};
    auto complex = test::build<double>(
        points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}, {2, 5, 3}, {3, 6, 1}},
        {exterior_phase, exterior_phase, exterior_phase, 2, 1, 1});
    ASSERT_EQ(validate(complex).problem, "");
    const Point<double> middle = (points[1] + points[2]) / 2;
    ASSERT_LT(orientation<double>(middle, points[1], points[2]), 0);
    ASSERT_GT(cross<double>(points[1] - middle, points[2] - middle), 0);
    Work work(complex, 4);
    FilmRegion<double> region(*work.work, exterior_phase, 4);
    for (const Triangle t : triangles(complex, exterior_phase)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (complex.phase_at(complex.twin(c)) == 1) {
                region.add_ray(c);
            }
        }
    }
    region.smooth();
    EXPECT_EQ(complex.position(Vertex{0}), points[0]);
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::film_rays_test
