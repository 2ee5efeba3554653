// SPDX-License-Identifier: MIT
// Shapes, domains and options that make no sense, each with its message.
#include "dsc/base/error.h"
#include "dsc/initial/initial_complex.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace dsc::shape_errors_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Shape square(double x, double y, double side, dsc::Phase phase = 1) {
    return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, phase};
}

template <class Real = double>
void expect_error(const std::vector<Shape>& shapes, const std::string& where,
                  const std::string& words, double edge_length = 0.05, const Rectangle& domain = {},
                  int rounds = 12) {
    test::expect_refusal(
        [&] {
            (void)dsc::initial_complex<Real>(
                domain, shapes, {.edge_length = edge_length, .improve_rounds = rounds});
        },
        where, words);
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

} // namespace dsc::shape_errors_test
