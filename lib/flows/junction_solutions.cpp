// SPDX-License-Identifier: MIT
#include "flows/junction_solutions.h"

#include "dsc/base/error.h"
#include "flows/arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dsc::scenes {

namespace {

using std::numbers::pi;
constexpr double first_slope = std::numbers::sqrt3;
/// The number of RK4 steps from the junction to the point where the curve reaches its asymptote:
/// the error is below 1e-12.
constexpr int steps = 1 << 14;

/// The curve at one xi. The equation is of first order in the slope p and in w = u - xi u', which
/// tends to 0 as the curve approaches its asymptote:  p' = (1 + p^2) w / 2,  w' = -xi p'.
struct Place {
    double xi = 0;
    double p = first_slope;
    double w = 0;
    double integral = 0; ///< of u, from the junction on

    [[nodiscard]] double u() const { return w + xi * p; }
    /// The derivatives: of p, w and the integral; d xi = 1.
    [[nodiscard]] Place rate() const {
        const double bend = (1 + p * p) * w / 2;
        return {1, bend, -xi * bend, u()};
    }
    [[nodiscard]] Place after(const Place& by, double share) const {
        return {xi + share * by.xi, p + share * by.p, w + share * by.w,
                integral + share * by.integral};
    }
};

Place at_junction(double c) { return {c / 2, first_slope, -c / 2 * first_slope, 0}; }

/// The distance from the junction at which the curve equals its asymptote up to rounding: it
/// approaches the asymptote like exp(-xi^2 / 4), or faster.
double reach(double c) { return std::sqrt(c * c / 4 + 169) - c / 2; }

Place advance(const Place& from, double by) {
    const Place a = from.rate();
    const Place b = from.after(a, by / 2).rate();
    const Place c = from.after(b, by / 2).rate();
    const Place d = from.after(c, by).rate();
    return from.after(a, by / 6).after(b, by / 3).after(c, by / 3).after(d, by / 6);
}

/// The direction far from the junctions for an edge that opens with this factor.
double asymptote(double c) {
    Place place = at_junction(c);
    const double step = reach(c) / steps;
    for (int i = 0; i < steps; ++i) {
        place = advance(place, step);
    }
    return std::atan(place.p);
}

/// The part of the sector on one side of the x axis, in units of sqrt(t) from the centre: its area,
/// and its curve from the junction to the side of the box.
struct Part {
    std::vector<Point<double>> curve;
    bool leaves_by_side = true; ///< or else at `top`
    double area = 0;
};

/// Ends the curve at the point where its next step, of length `by`, leaves the box.
void leave(const Place& from, double by, double side, double top, Part& part) {
    Place last = advance(from, std::min(by, side - from.xi));
    part.leaves_by_side = last.u() <= top;
    if (!part.leaves_by_side) {
        // Newton's method, from below on a concave curve.
        last = from;
        for (int i = 0; i < 8; ++i) {
            last = advance(from, last.xi + (top - last.u()) / last.p - from.xi);
        }
    }
    part.curve.emplace_back(part.leaves_by_side ? side : last.xi,
                            part.leaves_by_side ? last.u() : top);
    part.area = last.integral + (part.leaves_by_side ? 0 : (side - last.xi) * top);
}

Part part_within(double c, double side, double top) {
    Part part;
    Place place = at_junction(c);
    part.curve.emplace_back(place.xi, 0);
    const double step = reach(c) / steps;
    for (int i = 0; i < steps; ++i) {
        const Place next = advance(place, step);
        if (next.xi >= side || next.u() >= top) {
            leave(place, step, side, top, part);
            return part;
        }
        place = next;
        part.curve.emplace_back(place.xi, place.u());
    }
    place.w = 0; // along the asymptote, for which a step of any length is exact
    leave(place, side - place.xi, side, top, part);
    return part;
}

/// The same at time 0.
Part part_of_ray(double theta, double side, double top) {
    const double slope = std::tan(theta);
    const bool by_side = side * slope <= top;
    const double x = by_side ? side : top / slope;
    const double y = by_side ? side * slope : top;
    return {{{0, 0}, {x, y}}, by_side, x * y / 2 + (side - x) * top};
}

} // namespace

ExactShape lens_shape(const Lens& lens) {
    const double r = std::sqrt(lens.area / (2 * pi / 3 - std::numbers::sqrt3 / 2));
    const Point<double> to(0, r * std::cos(pi / 3)); // the centre of the arc below
    ExactShape shape;
    append_arcs({lens.centre, lens.axis.normalized()},
                {{to, r, 7 * pi / 6, 11 * pi / 6}, {-to, r, pi / 6, 5 * pi / 6}}, shape);
    return shape;
}

double opening_factor(double theta) {
    double low = 0;
    double high = 1;
    while (asymptote(high) > theta) {
        low = high;
        high *= 2;
    }
    for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
        const double middle = (low + high) / 2;
        (asymptote(middle) > theta ? low : high) = middle;
    }
    return (low + high) / 2;
}

ExactShape right_sector(const FourSectors& sectors, double time, const Rectangle& box) {
    const double c = opening_factor(sectors.theta);
    const double size = time > 0 ? std::sqrt(time) : 1;
    const double side = (box.high.x() - sectors.centre.x()) / size;
    require(time == 0 || c / 2 < side, "time", time, "until the right junction leaves the box");
    const double above = (box.high.y() - sectors.centre.y()) / size;
    const double below = (sectors.centre.y() - box.low.y()) / size;
    const auto part = [&](double top) {
        return time > 0 ? part_within(c, side, top) : part_of_ray(sectors.theta, side, top);
    };
    const Part upper = part(above);
    const Part lower = part(below);

    ExactShape shape;
    Outline outline;
    for (const Point<double>& p : lower.curve) {
        outline.emplace_back(sectors.centre + size * Point<double>(p.x(), -p.y()));
    }
    if (!lower.leaves_by_side) {
        outline.emplace_back(box.high.x(), box.low.y());
    }
    if (!upper.leaves_by_side) {
        outline.push_back(box.high);
    }
    for (std::size_t i = upper.curve.size() - 1; i > 0; --i) { // both begin at the junction
        outline.emplace_back(sectors.centre + size * upper.curve[i]);
    }
    shape.area = (upper.area + lower.area) * size * size;
    // The sector is convex beside its curves, so all chords are on one side of them.
    constexpr double of_shooting = 1e-11;
    shape.own_error =
        std::abs(shape.area - signed_area(outline)) + of_shooting * perimeter(outline) * size;
    shape.outlines.push_back(std::move(outline));
    return shape;
}

} // namespace dsc::scenes
