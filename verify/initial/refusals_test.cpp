// SPDX-License-Identifier: MIT
// Invalid domains, options, shapes and curves, each with its message; and input just inside the
// limits, which is accepted. Outlines and curves are checked by the same code, so each rule is
// tested on only one of them.
#include "dsc/initial/initial_complex.h"
#include "dsc/initial/input/input_check.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dsc::refusals_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Drawn>
struct Row {
    std::vector<Drawn> drawn;
    std::string where;
    std::string words;
};

template <class Real = double, class Drawn>
void build(const std::vector<Drawn>& drawn, double h = 0.05, const Rectangle& domain = {},
           Detail detail = Detail::thin) {
    (void)initial_complex<Real>(domain, drawn, {.edge_length = h, .detail = detail});
}

template <class Real = double, class Drawn>
void expect_refused(const std::vector<Row<Drawn>>& rows, Detail detail = Detail::thin) {
    for (const Row<Drawn>& row : rows) {
        test::expect_refusal([&] { build<Real>(row.drawn, 0.05, {}, detail); }, row.where,
                             row.words);
    }
}

Shape square(double x, double y, double side, Phase phase = 1) {
    return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, phase};
}

const Curve across{{{0, 0.5}, {1, 0.5}}, 1, 0};

TEST(InitialErrors, OptionsAndDomain) {
    struct Input {
        double h;
        Rectangle domain;
        std::string where, words;
        bool in_float = false;
    };
    const std::vector<Input> inputs{
        {0, {}, "edge_length", "above 0"},
        {-1, {}, "edge_length", "above 0"},
        {infinity, {}, "edge_length", "above 0"},
        {nan, {}, "edge_length", "above 0"},
        {1e-110, {{0, 0}, {1e-109, 1e-109}}, "edge_length", "scale other scenes with choose_frame"},
        {1e110, {{0, 0}, {1e111, 1e111}}, "edge_length", "scale other scenes with choose_frame"},
        {1.5, {}, "edge_length", "smaller side of the domain"},
        {0.3, {{0, 0}, {1, 0.2}}, "edge_length", "smaller side of the domain"},
        {1e-5, {}, "edge_length", "triangles"},
        {1, {{1e15, 0}, {1e15 + 64, 64}}, "edge_length", "resolution"},
        {0.05, {{1e5, 0}, {1e5 + 1, 1}}, "edge_length", "resolution", true},
        {0.1, {{0, 0}, {0, 1}}, "domain", "empty"},
        {0.1, {{1, 0}, {0, 1}}, "domain", "empty"},
        {1, {{-1e200, 0}, {1e200, 1e200}}, "domain", "out of range"},
        {0.1, {{0, nan}, {1, 1}}, "domain", "not finite"},
        {0.1, {{0, 0}, {infinity, 1}}, "domain", "not finite"},
        {1e39, {{0, 0}, {1e40, 1e40}}, "domain", "not finite", true}};
    for (const Input& input : inputs) {
        const std::vector<Shape> none;
        test::expect_refusal(
            [&] {
                input.in_float ? build<float>(none, input.h, input.domain)
                               : build<double>(none, input.h, input.domain);
            },
            input.where, input.words);
    }
    test::expect_refusal(
        [] { (void)initial_complex<double>({}, {}, {.edge_length = 0.1, .improve_rounds = -1}); },
        "improve_rounds", "0 or more");
}

TEST(InitialErrors, TheLeastEdgeLengthsAreAllowed) {
    const double h = initial::min_initial_edge_length;
    const double steps = initial::min_steps * std::numeric_limits<double>::epsilon();
    const Rectangle small{{0, 0}, {4 * h, 4 * h}};
    const Rectangle far{{1 - 4 * steps, 1 - 4 * steps}, {1, 1}};
    for (const auto& [domain, smallest] : {std::pair{small, h}, std::pair{far, steps}}) {
        EXPECT_TRUE(validate(initial_complex<double>(domain, {}, {.edge_length = smallest})).ok());
        EXPECT_THROW(build(std::vector<Shape>{}, 0.99 * smallest, domain), InputError);
    }
}

TEST(InitialErrors, OneLine) {
    const Shape good = square(0.1, 0.1, 0.1);
    Shape lost = square(0.5, 0.5, 0.2);
    lost.outline[2].x() = nan;
    expect_refused<double, Shape>({
        {{good, lost}, "shape 1, point 2", "not finite"},
        {{good, {{}, 1}}, "shape 1", "too few"},
        {{square(0.5, 0.5, 0.2, border_phase)}, "shape 0", "reserved"},
    });
    expect_refused<double, Shape>(
        {{{{{{0.2, 0.2}, {0.4, 0.4}}, 1}}, "shape 0", "too few"},
         {{square(0.5, 0.5, 0.03)}, "shape 0", "smaller than the edge length: got 0.0424"},
         {{{{{0.2, 0.2}, {0.4, 0.2}, {0.4, 0.202}, {0.2, 0.202}}, 1}},
          "shape 0, edge 1",
          "too short for the mesh: got 0.002"}},
        Detail::keep);
    expect_refused<double, Curve>({
        {{across, {{{0, 0.2}, {0.5, infinity}, {1, 0.2}}, 1, 0}}, "curve 1, point 1", "not finite"},
        {{across, {{}, 1, 0}}, "curve 1", "too few points"},
        {{{{{0, 0.5}}, 1, 0}}, "curve 0", "too few points: got 1"},
        {{{{{0.2, 0.5}, {0.4, 0.5}, {0.2, 0.5}}, 1, 0}}, "curve 0", "too few points: got 2"},
        {{{across.points, border_phase, 0}}, "curve 0", "reserved"},
        {{{across.points, 0, border_phase}}, "curve 0", "reserved"},
        {{across, {{{0, 0.2}, {1, 0.2}}, 3, 3}},
         "curve 1",
         "got 3; allowed: two phases that differ"},
    });
}

TEST(InitialErrors, Sides) {
    const std::string outside = "outside the domain or too close";
    expect_refused<double, Shape>(
        {{{square(1.1, 0.5, 0.2), square(-2, 0.5, 0.2)}, "shape 0", "all shapes lie outside"}});
    expect_refused<double, Curve>({
        {{{{{0, 0.5}, {1.1, 0.5}}, 1, 0}}, "curve 0, point 1", outside},
        {{{{{0, 0.5}, {0.5, 1}, {1, 0.5}}, 1, 0}}, "curve 0, point 1", outside},
        {{{{{0, 0.5}, {0.5, 1e-5}, {1, 0.5}}, 1, 0}}, "curve 0, point 1", outside},
        {{{{{1e-9, 0.5}, {1, 0.5}}, 1, 0}}, "curve 0, point 0", outside},
        {{{{{0, 0.2}, {0, 0.8}}, 1, 0}}, "curve 0, edge 0", "runs along a side"},
        {{{{{0, 0}, {0.9, 0.0003}, {0.9, 0.5}, {0, 0.4}}, 1, 0}},
         "curve 0, edge 0",
         "runs along a side"},
    });
    EXPECT_NO_THROW(build(std::vector<Curve>{{{{0, 0.5}, {0.5, 6e-5}, {1, 0.5}}, 1, 0}}));
}

TEST(InitialErrors, Ends) {
    const std::string inside = "ends inside the domain";
    const Curve right{{{0.5, 0.5}, {1, 0.5}}, 1, 0};
    expect_refused<double, Curve>({
        {{across, {{{0, 0.2}, {0.5, 0.2}}, 1, 0}}, "curve 1, point 1", inside},
        {{{{{0.2, 0.2}, {0.5, 0.2}, {1, 0.3}}, 1, 0}}, "curve 0, point 0", inside},
        // A curve that ends inside an edge of another curve does not form a junction.
        {{across, {{{0.5, 0.5}, {0.5, 1}}, 1, 0}}, "curve 1, point 0", inside},
        {{{{{0, 0.5}, {std::nextafter(0.5, 0), 0.5}}, 1, 0}, right}, "curve 0, point 1", inside},
    });
    EXPECT_NO_THROW(build(std::vector<Curve>{{{{0, 0.5}, {0.5, 0.5}}, 1, 0}, right}));
}

// Messages of contacts; geometry/contacts_test.cpp tests how they are found.
TEST(InitialErrors, Contacts) {
    expect_refused<double, Shape>({
        {{{{{0.2, 0.2}, {0.6, 0.6}, {0.6, 0.2}, {0.2, 0.6}}, 1}},
         "shape 0, edge 0",
         "cross, touch or overlap: got contact with shape 0, edge 2"},
        {{square(0.2, 0.2, 0.2), square(0.3, 0.3, 0.2, 2)},
         "shape 0, edge 2",
         "got contact with shape 1, edge 3"},
        {{square(0.2, 0.2, 0.2), square(0.2, 0.2, 0.2, 2)}, "shape 1", "area with shape 0 at (0."},
        {{square(0.2, 0.2, 0.2), square(0.3, 0.2, 0.2, 2)}, "shape 1", "area with shape 0 at (0."},
    });
    const double beside = std::nextafter(0.4, 1);
    expect_refused<double, Curve>({
        {{across, {{{0.5, 0}, {0.5, 1}}, 1, 0}}, "curve 0, edge 0", "contact with curve 1, edge 0"},
        // Two curves end on an inner point of a third.
        {{{{{0, 0.2}, {0.5, 0.5}, {1, 0.2}}, 0, 1},
          {{{0, 0.8}, {0.5, 0.5}}, 1, 0},
          {{{0.5, 0.5}, {1, 0.8}}, 1, 0}},
         "curve 0, edge 0",
         "contact with curve 1, edge 0"},
        // A point is so close to an edge that rounding could move the edge's new points across it.
        {{{{{0.2, 0}, {0.6, 1}}, 1, 0}, {{{1, 0.3}, {0.4, 0.5}, {1, 0.7}}, 1, 0}},
         "curve 0, edge 0",
         "contact with curve 1, edge 0"},
    });
    // A point lies exactly on an edge, whose pieces are rounded to one or the other side of it.
    for (const double side : {0.0, 1.0}) {
        const Curve tip{{{0.2, side}, {0.25, 0.34375}, {0.3, side}}, 1, 0};
        expect_refused<double, Curve>(
            {{{{{{0, 0.25}, {1, 0.625}}, 1, 0}, tip}, "curve 0, edge 0", "contact with curve 1"}});
    }
    EXPECT_NO_THROW(build(std::vector<Curve>{{{{0.4, 0}, {0.4, 1}}, 1, 2},
                                             {{{1, 0.3}, {beside, 0.51}, {1, 0.7}}, 2, 0}}));
}

TEST(InitialErrors, Phases) {
    const std::string same = "same phase as its surroundings";
    expect_refused<double, Shape>({
        {{square(0.2, 0.2, 0.2, 0)}, "shape 0", same},
        {{square(0.2, 0.2, 0.2, 4), square(0.5, 0.2, 0.2, 0)}, "shape 1", same},
    });
    EXPECT_NO_THROW(build(std::vector<Shape>{square(0.2, 0.2, 0.6, 4), square(0.3, 0.3, 0.4, 0)}));
    const auto ring = [](double left) {
        return Curve{
            {{left, 0.5}, {left + 0.1, 0.4}, {left + 0.2, 0.5}, {left + 0.1, 0.6}, {left, 0.5}},
            2,
            1};
    };
    expect_refused<double, Curve>({
        {{{{{0, 0.3}, {1, 0.3}}, 1, 0}, {{{0, 0.6}, {1, 0.6}}, 0, 2}},
         "curve 1",
         "two phases for one region: got phase 2 on the right of curve 1, phase 1 on the left of "
         "curve 0"},
        // A bridge between two rings has the same region on both sides.
        {{ring(0.2), ring(0.6), {{{0.2, 0.5}, {0, 0.5}}, 1, 0}},
         "curve 2",
         "two phases for one region"},
    });
}

TEST(InitialErrors, FloatsThatCollide) {
    const double more = 0.5 + 1e-9;
    const std::vector<Curve> close{{{{0, 0.5}, {0.5, 0.5}, {more, 0.5}, {1, 0.5}}, 1, 0}};
    const std::vector<Curve> first{{{{0.3, 0.5}, {0.3 + 1e-12, 0.5}, {1, 0.5}}, 1, 0}};
    const std::vector<Curve> far{{{{0, 0.5}, {0.5, 1e39}, {1, 0.5}}, 1, 0}};
    const std::vector<Curve> ends{{{{0, 0.5}, {0.5, 0.5}}, 1, 0},
                                  {{{0.5, 0.5}, {1, 0.5}}, 1, 2},
                                  {{{0.5, 0.5}, {0.5, 0}}, 2, 0},
                                  {{{0, 0.4}, {0.5 - 1e-9, 0.5}}, 0, 3}};
    const std::vector<Curve> doubled{{{{0, 0.5}, {0, 0.5}, {1, 0.5}}, 1, 0}};
    expect_refused<float, Curve>({{close, "curve 0, edge 1", "points collide when rounded"},
                                  {first, "curve 0, edge 0", "points collide when rounded"},
                                  {doubled, "curve 0, edge 0", "length 0"}},
                                 Detail::keep);
    expect_refused<float, Curve>({
        {far, "curve 0, point 1", "not finite"},
        {ends, "curve 3", "ends of curves collide when rounded"},
    });
    expect_refused<double, Curve>({{ends, "curve 3, point 1", "ends inside the domain"}});
    EXPECT_NO_THROW(build(close));
}

TEST(InitialOutlines, MayBeginAtAnyOfTheirVerticesAndGoEitherWay) {
    std::vector<Point<double>> points{{3, 5}, {1, 1}, {0, 0}, {1, -1}, {4, -1}};
    for (int way = 0; way < 2; ++way, std::reverse(points.begin(), points.end())) {
        for (std::size_t first = 0; first < points.size(); ++first) {
            const std::vector<Shape> shapes{{points, 1}};
            const auto complex =
                initial_complex<double>({{-1, -2}, {6, 6}}, shapes, {.edge_length = 1});
            EXPECT_TRUE(validate(complex).ok());
            EXPECT_NEAR(phase_area(complex, 1), 12, 1e-12) << way << ' ' << first;
            std::rotate(points.begin(), points.begin() + 1, points.end());
        }
    }
}

} // namespace
} // namespace dsc::refusals_test
