// SPDX-License-Identifier: MIT
#include "shapes/outline.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "measures/compensated_sum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dsc::scenes {

namespace {

void add_area(const Outline& outline, CompensatedSum& doubled) {
    for (std::size_t i = 2; i < outline.size(); ++i) {
        const Point<double> a = outline[i - 1] - outline[0];
        const Point<double> b = outline[i] - outline[0];
        doubled.add_product(a.x(), b.y());
        doubled.add_product(-a.y(), b.x());
    }
}

void add_perimeter(const Outline& outline, CompensatedSum& length) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point<double> edge = outline[i + 1 == outline.size() ? 0 : i + 1] - outline[i];
        length.add(std::hypot(edge.x(), edge.y()));
    }
}

/// An edge in the search for intersections: its ends, its box and its place in its outline.
struct Side {
    Point<double> a;
    Point<double> b;
    double left, right, low, high;
    std::size_t outline, index;
};

/// For neighbours, `s` ending where `t` begins: true if `t` runs back along `s`.
bool folds_back(const Side& s, const Side& t) {
    return orientation(s.a, s.b, t.b) == 0 &&
           (box_contains<double>(s.a, s.b, t.b) || box_contains<double>(t.a, t.b, s.a));
}

bool conflict(const Side& s, const Side& t, std::size_t size) {
    if (s.outline == t.outline) {
        if ((s.index + 1) % size == t.index) {
            return folds_back(s, t);
        }
        if ((t.index + 1) % size == s.index) {
            return folds_back(t, s);
        }
    }
    return segments_meet<double>(s.a, s.b, t.a, t.b);
}

} // namespace

double signed_area(const Outline& outline) {
    CompensatedSum doubled;
    add_area(outline, doubled);
    return 0.5 * doubled.value();
}

double signed_area(std::span<const Outline> outlines) {
    CompensatedSum doubled;
    for (const Outline& outline : outlines) {
        add_area(outline, doubled);
    }
    return 0.5 * doubled.value();
}

double area_drift(double area, double reference) { return (area - reference) / reference; }

double perimeter(const Outline& outline) {
    CompensatedSum length;
    add_perimeter(outline, length);
    return length.value();
}

double perimeter(std::span<const Outline> outlines) {
    CompensatedSum length;
    for (const Outline& outline : outlines) {
        add_perimeter(outline, length);
    }
    return length.value();
}

double longest_edge(const Outline& outline) {
    double longest = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point<double> edge = outline[i + 1 == outline.size() ? 0 : i + 1] - outline[i];
        longest = std::max(longest, std::hypot(edge.x(), edge.y()));
    }
    return longest;
}

Outline reversed(Outline outline) {
    std::reverse(outline.begin(), outline.end());
    return outline;
}

bool is_simple(std::span<const Outline> outlines) {
    std::vector<Side> sides;
    for (std::size_t o = 0; o < outlines.size(); ++o) {
        const Outline& outline = outlines[o];
        check_outline(outline, "is_simple");
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point<double>& a = outline[i];
            const Point<double>& b = outline[i + 1 == outline.size() ? 0 : i + 1];
            if (a == b) {
                return false;
            }
            sides.push_back({a, b, std::min(a.x(), b.x()), std::max(a.x(), b.x()),
                             std::min(a.y(), b.y()), std::max(a.y(), b.y()), o, i});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& s, const Side& t) { return s.left < t.left; });
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& side = sides[i];
        std::erase_if(active, [&](std::size_t other) { return sides[other].right < side.left; });
        for (const std::size_t other : active) {
            if (sides[other].low <= side.high && side.low <= sides[other].high &&
                conflict(sides[other], side, outlines[side.outline].size())) {
                return false;
            }
        }
        active.push_back(i);
    }
    return true;
}

bool is_simple(const Outline& outline) { return is_simple(std::span(&outline, 1)); }

void check_outline(const Outline& outline, const std::string& where) {
    if (outline.size() < 3) {
        throw InputError({.what = "too few points in an outline",
                          .where = where,
                          .value = std::to_string(outline.size()),
                          .allowed = "at least 3"});
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (!outline[i].allFinite()) {
            throw InputError({.what = "point " + std::to_string(i) + " of an outline is not finite",
                              .where = where,
                              .value = "(" + std::to_string(outline[i].x()) + ", " +
                                       std::to_string(outline[i].y()) + ")",
                              .allowed = "finite coordinates"});
        }
    }
}

} // namespace dsc::scenes
