// SPDX-License-Identifier: MIT
#include "dsc/initial/input/clipping.h"

#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace dsc::initial {

namespace {

// The half plane on one side of a vertical or horizontal line.
struct Side {
    int axis;
    double place;
    bool is_low; // the domain lies above it

    [[nodiscard]] double distance(const Point<double>& p) const {
        return is_low ? p[axis] - place : place - p[axis];
    }
};

std::array<Side, 4> sides_of(const Lattice& lattice) {
    return {{{0, lattice.low.x(), true},
             {0, lattice.high.x(), false},
             {1, lattice.low.y(), true},
             {1, lattice.high.y(), false}}};
}

// The point where an edge meets a side; the same for both directions of the edge.
template <class Real>
Point<double> crossing(const Side& side, Point<double> a, Point<double> b) {
    if (is_left_of(b, a)) {
        std::swap(a, b);
    }
    const double share = (side.place - a[side.axis]) / (b[side.axis] - a[side.axis]);
    Point<double> p = rounded<Real>(Point<double>(a + share * (b - a)));
    p[side.axis] = side.place;
    return p;
}

// Keeps the part on the domain's side of a line (I. E. Sutherland, G. W. Hodgman, "Reentrant
// polygon clipping", 1974). Edges along the line that bound no part of the shape occur twice.
template <class Real>
void clip(Loop& loop, const Side& side) {
    Loop result;
    const std::size_t count = loop.points.size();
    const auto add = [&](const Point<double>& p, std::uint32_t number) {
        if (result.points.empty() || result.points.back() != p) {
            result.points.push_back(p);
            result.numbers.push_back(number);
        }
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Point<double>& a = loop.points[i];
        const Point<double>& b = loop.points[i + 1 == count ? 0 : i + 1];
        const double before = side.distance(a);
        const double after = side.distance(b);
        if (before >= 0) {
            add(a, loop.numbers[i]);
        }
        if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
            add(crossing<Real>(side, a, b), loop.numbers[i]);
        }
    }
    while (result.points.size() > 1 && result.points.front() == result.points.back()) {
        result.points.pop_back();
        result.numbers.pop_back();
    }
    loop.points.swap(result.points);
    loop.numbers.swap(result.numbers);
}

// The smallest distance of its points from a side; negative beyond it.
double min_distance(const Loop& loop, const Side& side) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Point<double>& p : loop.points) {
        smallest = std::min(smallest, side.distance(p));
    }
    return smallest;
}

// Moves points within the tolerance of a side onto it.
void move_to_side(Loop& loop, const Side& side, double tolerance) {
    for (Point<double>& p : loop.points) {
        if (std::abs(side.distance(p)) < tolerance) {
            p[side.axis] = side.place;
        }
    }
}

} // namespace

bool is_left_of(const Point<double>& a, const Point<double>& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

bool is_along_side(const Lattice& lattice, const Point<double>& a, const Point<double>& b) {
    return std::ranges::any_of(sides_of(lattice), [&](const Side& side) {
        return side.distance(a) == 0 && side.distance(b) == 0;
    });
}

template <class Real>
Clipped clip_to_domain(std::vector<Loop>& loops, const Lattice& lattice, double tolerance) {
    Clipped result;
    for (Loop& loop : loops) {
        bool is_clipped = false;
        for (const Side& side : sides_of(lattice)) {
            const double nearest = min_distance(loop, side);
            if (nearest < tolerance) {
                result.is_at_side = true;
                move_to_side(loop, side, tolerance);
                is_clipped = is_clipped || nearest <= -tolerance;
                clip<Real>(loop, side);
            }
            if (loop.points.empty()) {
                break;
            }
        }
        result.loops += is_clipped ? 1 : 0;
    }
    std::erase_if(loops, [](const Loop& loop) { return loop.points.size() < 3; });
    return result;
}

template Clipped clip_to_domain<double>(std::vector<Loop>&, const Lattice&, double);
template Clipped clip_to_domain<float>(std::vector<Loop>&, const Lattice&, double);

} // namespace dsc::initial
