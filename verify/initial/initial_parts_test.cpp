// SPDX-License-Identifier: MIT
// The parts of the initial complex one by one, each against the plainest way to the same answer,
// and the errors for input that makes no sense.
#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/interface.h"
#include "dsc/initial/build/lattice.h"
#include "dsc/queries/validate.h"
#include "support/initial_testing.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace dsc::initial_parts_test {
namespace {

using Kind = WalkEnd::Kind;

TEST(Lattice, IsAValidComplexOfEverySize) {
    for (std::uint32_t columns = 1; columns < 6; ++columns) {
        for (std::uint32_t rows = 1; rows < 6; ++rows) {
            dsc::initial::Lattice lattice{{-1, 2}, {3, 3},        columns,
                                          rows,    4.0 / columns, 1.0 / rows};
            Complex<double> complex;
            dsc::initial::write_lattice(lattice, 0, complex);
            const auto report = dsc::validate(complex);
            ASSERT_TRUE(report.ok()) << columns << " x " << rows << ": " << report.problem;
            EXPECT_EQ(report.triangles, (2 * columns + 1) * rows);
            EXPECT_EQ(report.components, 1U);
            EXPECT_EQ(report.unused_vertices, 0U);
        }
    }
}

TEST(Lattice, FindsATriangleNearEachPoint) {
    const auto lattice = dsc::initial::fit_lattice({0, 0}, {2, 1}, 0.05);
    Complex<double> complex;
    dsc::initial::write_lattice(lattice, 0, complex);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 1000; ++i) {
        const Point<double> p(2 * share(random), share(random));
        const auto& v = complex.triangles[lattice.triangle_near(p)].v;
        EXPECT_LT((complex.position(Vertex{v[0]}) - p).norm(), 0.11);
    }
}

TEST(Locate, AgreesWithEveryTrianglesSigns) {
    const auto lattice = dsc::initial::fit_lattice({0, 0}, {1, 1}, 0.2);
    Complex<double> complex;
    dsc::initial::write_lattice(lattice, 0, complex);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.01, 0.99);
    std::vector<dsc::Corner> stack;
    std::size_t places[4] = {0, 0, 0, 0};
    for (int i = 0; i < 400; ++i) {
        Point<double> p(share(random), share(random));
        if (i % 4 == 1) { // on a vertex, or halfway along an edge
            p = complex.position(
                Vertex{static_cast<std::uint32_t>(random() % complex.vertex_bound())});
        } else if (i % 4 == 2) {
            const auto& v = complex.triangles[1 + random() % (complex.triangle_bound() - 1)].v;
            p = (complex.position(Vertex{v[0]}) + complex.position(Vertex{v[1]})) / 2;
        }
        const auto start =
            static_cast<std::uint32_t>(1 + random() % (complex.triangle_bound() - 1));
        const auto location = dsc::initial::locate(complex, start, p);
        ASSERT_NE(location.kind, Kind::stopped);
        ++places[static_cast<std::size_t>(location.kind)];
        int zeros = 0;
        dsc::Corner c = location.corner;
        for (int side = 0; side < 3; ++side, c = dsc::next(c)) {
            const int sign =
                dsc::orientation<double>(complex.position(Vertex{complex.vertex(dsc::next(c))}),
                                         complex.position(Vertex{complex.vertex(dsc::prev(c))}), p);
            ASSERT_GE(sign, 0);
            zeros += sign == 0 ? 1 : 0;
        }
        EXPECT_EQ(zeros, location.kind == Kind::triangle ? 0 : location.kind == Kind::edge ? 1 : 2);
        if (location.kind == Kind::vertex) {
            EXPECT_EQ(complex.position(Vertex{complex.vertex(location.corner)}), p);
        }
        const std::uint32_t v = dsc::initial::insert_point(complex, location, p, stack);
        EXPECT_EQ(complex.position(Vertex{v}), p);
        const auto report = dsc::validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
    }
    EXPECT_GT(places[0], 20U);
    EXPECT_GT(places[1], 20U);
    EXPECT_GT(places[2], 20U);
    EXPECT_EQ(test::sizes_of(complex).not_delaunay, 0U);
}

TEST(Locate, StopsAtTheSidesAndAtTheInterface) {
    const auto lattice = dsc::initial::fit_lattice({0, 0}, {1, 1}, 0.1);
    Complex<double> complex;
    dsc::initial::write_lattice(lattice, 0, complex);
    EXPECT_EQ(dsc::initial::locate(complex, 1, Point<double>(0.5, 1.5)).kind, Kind::stopped);
    EXPECT_EQ(dsc::initial::locate(complex, 1, Point<double>(0.5, 0.95)).kind, Kind::triangle);
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        complex.triangles[t].phase = complex.position(Vertex{complex.triangles[t].v[0]}).y() > 0.5;
    }
    EXPECT_EQ(dsc::initial::locate(complex, 1, Point<double>(0.5, 0.95)).kind, Kind::stopped);
}

// Segments through a triangulation that knows nothing of them.
TEST(Segments, AreRecoveredThroughAnything) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0.02, 0.98);
        const auto lattice = dsc::initial::fit_lattice({0, 0}, {1, 1}, 0.5);
        Complex<double> complex;
        dsc::initial::write_lattice(lattice, 0, complex);
        std::vector<dsc::Corner> stack;
        const auto insert = [&](const Point<double>& p) {
            return dsc::initial::insert_point(complex, dsc::initial::locate(complex, 1, p), p,
                                              stack);
        };
        for (int i = 0; i < 120; ++i) {
            // Also many points on one line, which is what a segment may run along.
            insert(i % 3 == 0 ? Point<double>(std::round(64 * share(random)) / 64, 0.5)
                              : Point<double>(share(random), share(random)));
        }
        const auto first = static_cast<std::uint32_t>(seed % 2 == 0 ? 1 : 2);
        dsc::initial::Chains chains;
        chains.push_back(
            {insert({0.01, 0.5}), insert({0.99, 0.5}), insert({0.7, 0.9 - 0.1 * first})});
        chains.push_back({insert({0.05, 0.03}), insert({0.9, 0.04}), insert({0.5, 0.07})});
        for (auto& chain : chains) {
            chain.push_back(chain.front());
        }
        const auto touched = dsc::initial::recover_segments(complex, chains);
        EXPECT_FALSE(touched.empty());
        EXPECT_GT(chains.front().size(), 20U) << "vertices on a segment become part of it";
        const auto report = dsc::validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        for (const auto& chain : chains) {
            EXPECT_EQ(chain.front(), chain.back());
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                const Vertex a{chain[i]};
                const Vertex b{chain[i + 1]};
                EXPECT_TRUE(complex.find_edge(a, b).is_valid());
            }
        }
    }
}

// --- errors --------------------------------------------------------------------------------------

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Shape square(double x, double y, double side, dsc::Phase phase = 1) {
    return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, phase};
}

template <class Real = double>
void expect_error(const std::vector<Shape>& shapes, const std::string& where,
                  const std::string& words, double edge_length = 0.05, const Rectangle& domain = {},
                  int rounds = 12) {
    try {
        static_cast<void>(dsc::initial_complex<Real>(
            domain, shapes, {.edge_length = edge_length, .improve_rounds = rounds}));
        ADD_FAILURE() << "no error; expected: " << where << ": " << words;
    } catch (const dsc::InputError& error) {
        EXPECT_EQ(error.where(), where) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        EXPECT_FALSE(error.value().empty());
        EXPECT_FALSE(error.allowed().empty());
    }
}

TEST(InitialErrors, OptionsAndDomain) {
    for (const double h : {0.0, -1.0, infinity, not_a_number}) {
        expect_error({}, "edge_length", "above 0", h);
    }
    expect_error({}, "edge_length", "choose_frame brings any scene there", 1e-110,
                 {{0, 0}, {1e-109, 1e-109}});
    expect_error({}, "edge_length", "choose_frame brings any scene there", 1e110,
                 {{0, 0}, {1e111, 1e111}});
    expect_error({}, "improve_rounds", "0 or more", 0.1, {}, -1);
    expect_error({}, "edge_length", "smaller side of the domain", 1.5);
    expect_error({}, "edge_length", "smaller side of the domain", 0.3, {{0, 0}, {1, 0.2}});
    expect_error({}, "edge_length", "triangles", 1e-5);
    expect_error({}, "edge_length", "resolve", 1.0, {{1e15, 0}, {1e15 + 64, 64}});
    expect_error<float>({}, "edge_length", "resolve", 0.05, {{1e5, 0}, {1e5 + 1, 1}});
    expect_error({}, "domain", "empty", 0.1, {{0, 0}, {0, 1}});
    expect_error({}, "domain", "empty", 0.1, {{1, 0}, {0, 1}});
    expect_error({}, "domain", "out of range", 1, {{-1e200, 0}, {1e200, 1e200}});
    expect_error({}, "domain", "not finite", 0.1, {{0, not_a_number}, {1, 1}});
    expect_error({}, "domain", "not finite", 0.1, {{0, 0}, {infinity, 1}});
    expect_error<float>({}, "domain", "not finite", 1e39, {{0, 0}, {1e40, 1e40}});
}

TEST(InitialErrors, OneOutline) {
    const Shape good = square(0.1, 0.1, 0.1);
    Shape bad = square(0.5, 0.5, 0.2);
    bad.outline[2].x() = not_a_number;
    expect_error({good, bad}, "shape 1, point 2", "not finite");
    bad.outline[2].x() = infinity;
    expect_error({good, bad}, "shape 1, point 2", "not finite");
    expect_error({good, {{}, 1}}, "shape 1", "too few");
    expect_error({{{{0.2, 0.2}, {0.4, 0.4}}, 1}}, "shape 0", "too few");
    bad = square(0.5, 0.5, 0.2);
    bad.outline[3] = bad.outline[2];
    expect_error({bad}, "shape 0, edge 2", "no length");
    bad = square(0.5, 0.5, 0.2);
    bad.outline.push_back(bad.outline.front());
    expect_error({bad}, "shape 0, edge 4", "no length");
    expect_error({{{{0.2, 0.2}, {0.4, 0.4}, {0.6, 0.6}, {0.3, 0.3}}, 1}}, "shape 0, edge 0",
                 "overlap");
    expect_error({square(0.5, 0.5, 0.2, dsc::border_phase)}, "shape 0", "reserved");
    expect_error({square(0.5, 0.5, 0.04)}, "shape 0", "smaller side of the shape");
    expect_error({square(0.8, 0.5, 0.2)}, "shape 0, point 1", "outside the domain or too close");
    expect_error({square(0.79999, 0.5, 0.2)}, "shape 0, point 1",
                 "outside the domain or too close");
    expect_error({square(-0.1, 0.5, 0.2)}, "shape 0, point 0", "outside the domain or too close");
    expect_error({square(2, 2, 0.2)}, "shape 0, point 0", "outside the domain or too close");
}

TEST(InitialErrors, Contacts) {
    expect_error({{{{0.2, 0.2}, {0.6, 0.6}, {0.6, 0.2}, {0.2, 0.6}}, 1}}, "shape 0, edge 0",
                 "cross, touch or overlap: got contact with shape 0, edge 2");
    // A vertex on another edge, a vertex on another vertex, a spike.
    expect_error({{{{0.2, 0.2}, {0.6, 0.2}, {0.6, 0.6}, {0.4, 0.2}, {0.2, 0.6}}, 1}},
                 "shape 0, edge 0", "contact with shape 0");
    expect_error({{{{0.2, 0.2}, {0.4, 0.4}, {0.6, 0.2}, {0.6, 0.6}, {0.4, 0.4}, {0.2, 0.6}}, 1}},
                 "shape 0, edge 0", "contact with shape 0");
    expect_error({{{{0.2, 0.2}, {0.6, 0.2}, {0.4, 0.2}, {0.4, 0.6}}, 1}}, "shape 0, edge 0",
                 "contact with shape 0");
    expect_error({square(0.2, 0.2, 0.2), square(0.3, 0.3, 0.2, 2)}, "shape 0, edge 2",
                 "got contact with shape 1, edge 3");
    expect_error({square(0.2, 0.2, 0.2), square(0.4, 0.2, 0.2, 2)}, "shape 0, edge 0",
                 "contact with shape 1");
    expect_error({square(0.2, 0.2, 0.2), square(0.2, 0.2, 0.2, 2)}, "shape 0, edge 0",
                 "contact with shape 1");
    expect_error({square(0.2, 0.2, 0.4), square(0.3, 0.2, 0.2, 2)}, "shape 0, edge 0",
                 "contact with shape 1");
}

TEST(InitialErrors, Phases) {
    expect_error({square(0.2, 0.2, 0.2, 0)}, "shape 0", "phase of what is around it");
    expect_error({square(0.3, 0.3, 0.2, 4), square(0.2, 0.2, 0.4, 4)}, "shape 0",
                 "phase of what is around it");
    expect_error({square(0.2, 0.2, 0.6, 4), square(0.3, 0.3, 0.4, 0), square(0.4, 0.4, 0.1, 0)},
                 "shape 2", "phase of what is around it");
    EXPECT_NO_THROW(static_cast<void>(dsc::initial_complex<double>(
        {}, std::vector<Shape>{square(0.2, 0.2, 0.6, 4), square(0.3, 0.3, 0.4, 0)},
        {.edge_length = 0.05})));
}

TEST(InitialErrors, FloatsThatCollide) {
    Shape shape = square(0.5, 0.5, 0.2);
    shape.outline.insert(shape.outline.begin() + 1, Point<double>(0.5 + 1e-9, 0.5));
    EXPECT_NO_THROW(static_cast<void>(
        dsc::initial_complex<double>({}, std::vector<Shape>{shape}, {.edge_length = 0.05})));
    expect_error<float>({shape}, "shape 0, edge 0", "collide when rounded");
    // Apart as doubles, the same line as floats.
    expect_error<float>({square(0.2, 0.2, 0.2),
                         {{{0.4 + 1e-9, 0.2}, {0.6, 0.2}, {0.6, 0.4}, {0.4 + 1e-9, 0.4}}, 2}},
                        "shape 0, edge 0", "contact with shape 1");
}

} // namespace

} // namespace dsc::initial_parts_test
