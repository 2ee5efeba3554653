// SPDX-License-Identifier: MIT
// Networks of curves that make no sense, each with its message; and the search for contacts against
// all pairs.
#include "dsc/base/error.h"
#include "dsc/geometry/contacts.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/initial_complex.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <string>

namespace dsc::curve_errors_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class Real = double>
void build(const std::vector<Curve>& curves, double h = 0.05) {
    static_cast<void>(dsc::initial_complex<Real>({}, curves, {.edge_length = h}));
}

template <class Real = double>
void expect_error(const std::vector<Curve>& curves, const std::string& where,
                  const std::string& words, double h = 0.05) {
    test::expect_refusal([&] { build<Real>(curves, h); }, where, words);
}

const Curve across{{{0, 0.5}, {1, 0.5}}, 1, 0};

TEST(CurveErrors, OneCurve) {
    expect_error({across, {{}, 1, 0}}, "curve 1", "too few points");
    expect_error({{{{0, 0.5}}, 1, 0}}, "curve 0", "too few points: got 1");
    expect_error({{{{0.2, 0.5}, {0.4, 0.5}, {0.2, 0.5}}, 1, 0}}, "curve 0",
                 "too few points: got 2");
    for (const double bad : {infinity, -infinity, not_a_number}) {
        expect_error({across, {{{0, 0.2}, {0.5, bad}, {1, 0.2}}, 1, 0}}, "curve 1, point 1",
                     "not finite");
    }
    expect_error({{across.points, dsc::border_phase, 0}}, "curve 0", "reserved");
    expect_error({{across.points, 0, dsc::border_phase}}, "curve 0", "reserved");
    expect_error({across, {{{0, 0.2}, {1, 0.2}}, 3, 3}}, "curve 1",
                 "got 3; allowed: two phases that differ");
    expect_error({{{{0, 0.5}, {0.5, 0.5}, {0.5, 0.5}, {1, 0.5}}, 1, 0}}, "curve 0, edge 1",
                 "no length");
    expect_error({across}, "edge_length", "above 0", 0);
    expect_error({across}, "edge_length", "smaller side of the domain", 1.5);
}

TEST(CurveErrors, Sides) {
    expect_error({{{{0, 0.5}, {1.1, 0.5}}, 1, 0}}, "curve 0, point 1",
                 "outside the domain or too close");
    expect_error({{{{0, 0.5}, {0, 1.5}}, 1, 0}}, "curve 0, point 1",
                 "outside the domain or too close");
    expect_error({{{{0, 0.5}, {0.5, 1}, {1, 0.5}}, 1, 0}}, "curve 0, point 1",
                 "outside the domain or too close");
    expect_error({{{{0, 0.5}, {0.5, 1e-5}, {1, 0.5}}, 1, 0}}, "curve 0, point 1",
                 "outside the domain or too close");
    EXPECT_NO_THROW(build({{{{0, 0.5}, {0.5, 6e-5}, {1, 0.5}}, 1, 0}}));
    expect_error({{{{1e-9, 0.5}, {1, 0.5}}, 1, 0}}, "curve 0, point 0",
                 "outside the domain or too close");
    expect_error({{{{0, 0.2}, {0, 0.8}}, 1, 0}}, "curve 0, edge 0", "runs along a side");
    expect_error({{{{0.2, 1}, {0.8, 1}}, 1, 0}}, "curve 0, edge 0", "runs along a side");
    expect_error({{{{0, 0}, {1, 0.0003}, {0.9, 0.5}, {0, 0.4}}, 1, 0}}, "curve 0, point 1",
                 "outside the domain or too close");
    expect_error({{{{0, 0}, {0.9, 0.0003}, {0.9, 0.5}, {0, 0.4}}, 1, 0}}, "curve 0, edge 0",
                 "runs along a side");
}

TEST(CurveErrors, Ends) {
    expect_error({across, {{{0, 0.2}, {0.5, 0.2}}, 1, 0}}, "curve 1, point 1",
                 "ends inside the domain");
    expect_error({{{{0.2, 0.2}, {0.5, 0.2}, {1, 0.3}}, 1, 0}}, "curve 0, point 0",
                 "ends inside the domain");
    // An end on the middle of another curve is no junction.
    expect_error({across, {{{0.5, 0.5}, {0.5, 1}}, 1, 0}}, "curve 1, point 0",
                 "ends inside the domain");
    const Curve right{{{0.5, 0.5}, {1, 0.5}}, 1, 0};
    EXPECT_NO_THROW(build({{{{0, 0.5}, {0.5, 0.5}}, 1, 0}, right}));
    expect_error({{{{0, 0.5}, {std::nextafter(0.5, 0), 0.5}}, 1, 0}, right}, "curve 0, point 1",
                 "ends inside the domain");
}

TEST(CurveErrors, Contacts) {
    expect_error({across, {{{0.5, 0}, {0.5, 1}}, 1, 0}}, "curve 0, edge 0",
                 "cross, touch or overlap: got contact with curve 1, edge 0");
    expect_error({{{{0, 0.2}, {0.6, 0.2}, {0.6, 0.6}, {0.3, 0.6}, {0.3, 0}}, 1, 0}},
                 "curve 0, edge 0", "contact with curve 0, edge 3");
    // A point on an edge, on a point; ends on a point that is no end; an overlap; two the same.
    expect_error({across, {{{0, 0.8}, {0.37, 0.5}, {1, 0.8}}, 1, 0}}, "curve 0, edge 0",
                 "contact with curve 1, edge 0");
    expect_error(
        {{{{0, 0.2}, {0.5, 0.5}, {1, 0.2}}, 1, 0}, {{{0, 0.8}, {0.5, 0.5}, {1, 0.8}}, 1, 0}},
        "curve 0, edge 0", "contact with curve 1, edge 0");
    expect_error({{{{0, 0.2}, {0.5, 0.5}, {1, 0.2}}, 0, 1},
                  {{{0, 0.8}, {0.5, 0.5}}, 1, 0},
                  {{{0.5, 0.5}, {1, 0.8}}, 1, 0}},
                 "curve 0, edge 0", "contact with curve 1, edge 0");
    expect_error({{{{0, 0.5}, {0.6, 0.5}, {0.3, 0.5}, {0.3, 1}}, 1, 0}}, "curve 0, edge 0",
                 "contact with curve 0, edge 1");
    expect_error({across, across}, "curve 0, edge 0", "contact with curve 1, edge 0");
    expect_error({{{{0.2, 0.2}, {0.4, 0.4}, {0.6, 0.6}, {0.2, 0.2}}, 1, 0}}, "curve 0, edge 0",
                 "contact with curve 0, edge 2");
    // A point beside an edge by less than rounding moves the points that cut it.
    const double beside = std::nextafter(0.4, 1);
    expect_error({{{{0.2, 0}, {0.6, 1}}, 1, 0}, {{{1, 0.3}, {0.4, 0.5}, {1, 0.7}}, 1, 0}},
                 "curve 0, edge 0", "contact with curve 1, edge 0");
    // A point exactly on an edge whose pieces are moved away from it, to one side or the other.
    for (const double side : {0.0, 1.0}) {
        const Curve tip{{{0.2, side}, {0.25, 0.34375}, {0.3, side}}, 1, 0};
        expect_error({{{{0, 0.25}, {1, 0.625}}, 1, 0}, tip}, "curve 0, edge 0",
                     "contact with curve 1");
    }
    EXPECT_NO_THROW(
        build({{{{0.4, 0}, {0.4, 1}}, 1, 2}, {{{1, 0.3}, {beside, 0.51}, {1, 0.7}}, 2, 0}}));
}

TEST(CurveErrors, PhasesThatContradict) {
    expect_error({{{{0, 0.3}, {1, 0.3}}, 1, 0}, {{{0, 0.6}, {1, 0.6}}, 0, 2}}, "curve 1",
                 "two phases for one region: got phase 2 on the right of curve 1, phase 1 on the "
                 "left of curve 0");
    // A bridge between two rings has one region on both sides.
    const auto ring = [](double left) {
        return Curve{
            {{left, 0.5}, {left + 0.1, 0.4}, {left + 0.2, 0.5}, {left + 0.1, 0.6}, {left, 0.5}},
            2,
            1};
    };
    expect_error({ring(0.2), ring(0.6), {{{0.2, 0.5}, {0, 0.5}}, 1, 0}}, "curve 2",
                 "two phases for one region");
}

TEST(CurveErrors, FloatsThatCollide) {
    const std::vector<Curve> close{{{{0, 0.5}, {0.5, 0.5}, {0.5 + 1e-9, 0.5}, {1, 0.5}}, 1, 0}};
    EXPECT_NO_THROW(build<double>(close));
    expect_error<float>(close, "curve 0, edge 1", "points collide when rounded");
    const std::vector<Curve> ends{{{{0, 0.5}, {0.5, 0.5}}, 1, 0},
                                  {{{0.5, 0.5}, {1, 0.5}}, 1, 2},
                                  {{{0.5, 0.5}, {0.5, 0}}, 2, 0},
                                  {{{0, 0.4}, {0.5 - 1e-9, 0.5}}, 0, 3}};
    expect_error<double>(ends, "curve 3, point 1", "ends inside the domain");
    expect_error<float>(ends, "curve 3", "ends of curves collide when rounded");
    const std::vector<Curve> twins{{{{0, 0.5}, {1, 0.5}}, 1, 0},
                                   {{{0, 0.5 + 1e-9}, {1, 0.5 + 1e-9}}, 2, 1}};
    EXPECT_NO_THROW(build<double>(twins, 0.5));
    expect_error<float>(twins, "curve 1", "ends of curves collide when rounded", 0.5);
}

// --- the search for contacts against all pairs ---------------------------------------------------

struct Lines {
    std::vector<Point<double>> points;
    std::vector<NetworkLine> lines;
};

// Lines between points of a coarse lattice. Ends at the same place now and then have the same
// number.
Lines random_lines(std::mt19937& random) {
    Lines result;
    std::map<std::pair<double, double>, std::uint32_t> numbers;
    const auto number = [&](double x, double y) {
        const auto [at, fresh] =
            numbers.try_emplace({x, y}, static_cast<std::uint32_t>(result.points.size()));
        if (fresh || random() % 64 == 0) {
            at->second = static_cast<std::uint32_t>(result.points.size());
            result.points.emplace_back(x, y);
        }
        return at->second;
    };
    const std::size_t count = 2 + random() % 5;
    while (result.lines.size() < count) {
        std::array<double, 4> at{};
        for (double& c : at) {
            c = static_cast<double>(random() % 12);
        }
        if (at[0] != at[2] || at[1] != at[3]) {
            const std::uint32_t from = number(at[0], at[1]);
            result.lines.push_back({from, number(at[2], at[3])});
        }
    }
    return result;
}

// Any common point counts that is not the place of a common number.
bool touch(const Lines& lines, const NetworkLine& s, const NetworkLine& t) {
    const auto& p = lines.points;
    const auto inside = [&](std::uint32_t v, const NetworkLine& e) {
        return dsc::orientation<double>(p[e.from], p[e.to], p[v]) == 0 &&
               dsc::box_contains<double>(p[e.from], p[e.to], p[v]);
    };
    for (const std::uint32_t v : {s.from, s.to}) {
        if (v != t.from && v != t.to && inside(v, t)) {
            return true;
        }
    }
    for (const std::uint32_t v : {t.from, t.to}) {
        if (v != s.from && v != s.to && inside(v, s)) {
            return true;
        }
    }
    if ((s.from == t.from && s.to == t.to) || (s.from == t.to && s.to == t.from)) {
        return true;
    }
    const auto side = [&](const NetworkLine& e, std::uint32_t v) {
        return dsc::orientation<double>(p[e.from], p[e.to], p[v]);
    };
    return side(s, t.from) * side(s, t.to) < 0 && side(t, s.from) * side(t, s.to) < 0;
}

std::optional<LineContact> contact_in(const Lines& lines) {
    return find_contact(lines.points, lines.lines);
}

// Whether there is a contact. The sweep finds one if there is, and one that is true.
bool expect_same_as_all_pairs(const Lines& lines) {
    bool expected = false;
    for (std::uint32_t e = 0; e < lines.lines.size(); ++e) {
        for (std::uint32_t f = e + 1; f < lines.lines.size(); ++f) {
            expected = expected || touch(lines, lines.lines[e], lines.lines[f]);
        }
    }
    const auto contact = contact_in(lines);
    EXPECT_EQ(contact.has_value(), expected);
    if (contact) {
        EXPECT_LT(contact->line, contact->other);
        EXPECT_TRUE(touch(lines, lines.lines[contact->line], lines.lines[contact->other]));
    }
    return expected;
}

TEST(Contacts, AgreeWithAllPairs) {
    std::mt19937 random(5);
    std::size_t with = 0;
    std::size_t without = 0;
    for (int i = 0; i < 20000; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        (expect_same_as_all_pairs(random_lines(random)) ? with : without) += 1;
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(with, 4000U);
    EXPECT_GT(without, 4000U);
}

TEST(Contacts, OfALongOutlineAreFoundInOneSweep) {
    Lines comb; // every edge overlaps all others in y
    const std::uint32_t teeth = 50000;
    for (std::uint32_t i = 0; i < teeth; ++i) {
        comb.points.emplace_back(2.0 * i, 0.0);
        comb.points.emplace_back(2.0 * i + 1, 1.0);
    }
    comb.points.emplace_back(2.0 * teeth, -1.0);
    comb.points.emplace_back(-1.0, -1.0);
    const auto count = static_cast<std::uint32_t>(comb.points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        comb.lines.push_back({i, (i + 1) % count});
    }
    EXPECT_FALSE(contact_in(comb));
    comb.points[70001].y() = -2;
    EXPECT_TRUE(contact_in(comb));
}

} // namespace

} // namespace dsc::curve_errors_test
