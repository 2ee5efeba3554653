// SPDX-License-Identifier: MIT
#include "flows/exact.h"

#include "dsc/geometry/points.h"
#include "measures/symmetric_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

/// New markers are inserted in rounds: each examines the intervals made by the previous one.
constexpr int max_rounds = 40;
/// Largest number of markers.
constexpr std::size_t max_markers = 1U << 20U;
/// One round divides an interval into at most this many parts, because its length is only an
/// estimate.
constexpr double max_parts = 64.0;
/// The initial number of markers on each smooth piece of a curve.
constexpr int first_markers = 256;
/// The number of test points that determine how many steps a flow needs, and the tolerance of their
/// positions in units of the square root of the curve's area. Too long steps move points along the
/// curve rather than off it: only a thousandth of the area swept by such errors shows in own_error.
constexpr int pilots = 128;
constexpr double same_place = 5e-7;

struct Marker {
    double parameter;
    Point<double> place;
    bool corner;
};

double length(const Point<double>& v) { return std::hypot(v.x(), v.y()); }

const Marker& cyclic(const std::vector<Marker>& markers, std::size_t i) {
    return markers[i % markers.size()];
}

double turn_at(const std::vector<Marker>& markers, std::size_t i) {
    const Marker& here = cyclic(markers, i);
    return here.corner ? 0.0
                       : turn_angle<double>(cyclic(markers, i + markers.size() - 1).place,
                                            here.place, cyclic(markers, i + 1).place);
}

void place_markers(const ParametricCurve& curve, const FlowMap& map, std::vector<Marker>& markers) {
    std::vector<Point<double>> points;
    points.reserve(markers.size());
    for (const Marker& marker : markers) {
        points.push_back(curve.point(marker.parameter));
    }
    map(points);
    for (std::size_t i = 0; i < markers.size(); ++i) {
        markers[i].place = points[i];
    }
}

/// Appends the markers that divide the interval (from, from + span) of the parameter.
void divide(double from, double span, int count, std::vector<Marker>& markers) {
    for (int k = 1; k < count; ++k) {
        const double parameter = from + span * k / count;
        const double wrapped = parameter < 1.0 ? parameter : parameter - 1.0;
        markers.push_back({wrapped, Point<double>{0.0, 0.0}, false});
    }
}

std::vector<Marker> spread_markers(const ParametricCurve& curve, const FlowMap& map, double spacing,
                                   double deviation) {
    std::vector<Marker> markers;
    const std::vector<double>& corners = curve.corners;
    const std::size_t pieces = std::max<std::size_t>(1, corners.size());
    for (std::size_t i = 0; i < pieces; ++i) {
        const double begin = corners.empty() ? 0.0 : corners[i];
        const double end = corners.empty()  ? 1.0
                           : i + 1 < pieces ? corners[i + 1]
                                            : corners[0] + 1.0;
        markers.push_back({begin, Point<double>{0.0, 0.0}, !corners.empty()});
        divide(begin, end - begin, first_markers, markers);
    }
    const auto by_parameter = [](const Marker& s, const Marker& t) {
        return s.parameter < t.parameter;
    };
    std::sort(markers.begin(), markers.end(), by_parameter);
    place_markers(curve, map, markers);
    for (int round = 0; round < max_rounds; ++round) {
        std::vector<Marker> added;
        for (std::size_t i = 0; i < markers.size(); ++i) {
            const Marker& here = markers[i];
            const Marker& next = cyclic(markers, i + 1);
            const double distance = length(next.place - here.place);
            const double angle =
                std::max(std::abs(turn_at(markers, i)), std::abs(turn_at(markers, i + 1)));
            const double parts = std::ceil(
                std::max(distance / spacing, std::sqrt(0.125 * distance * angle / deviation)));
            double span = next.parameter - here.parameter;
            span = span > 0.0 ? span : span + 1.0;
            if (parts > 1.0 && span > 1e3 * std::numeric_limits<double>::epsilon()) {
                divide(here.parameter, span, static_cast<int>(std::min(parts, max_parts)), added);
            }
        }
        if (added.empty() || markers.size() + added.size() > max_markers) {
            break;
        }
        place_markers(curve, map, added);
        const auto old = static_cast<std::ptrdiff_t>(markers.size());
        std::sort(added.begin(), added.end(), by_parameter);
        markers.insert(markers.end(), added.begin(), added.end());
        std::inplace_merge(markers.begin(), markers.begin() + old, markers.end(), by_parameter);
    }
    return markers;
}

/// A chord of length d loses an area of curvature * d^3 / 12. Vertices are moved outwards to
/// balance it.
Outline balanced_outline(const std::vector<Marker>& markers) {
    Outline outline;
    outline.reserve(markers.size());
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const Point<double>& here = markers[i].place;
        const Point<double>& before = cyclic(markers, i + markers.size() - 1).place;
        const Point<double>& after = cyclic(markers, i + 1).place;
        const double d1 = length(here - before);
        const double d2 = length(after - here);
        const Point<double> along = after - before;
        const double size = length(along);
        Point<double> pushed = here;
        if (size > 0.0) {
            const double push =
                turn_at(markers, i) * (d1 * d1 * d1 + d2 * d2 * d2) / (6.0 * (d1 + d2) * (d1 + d2));
            pushed += (push / size) * Point<double>{along.y(), -along.x()};
        }
        outline.push_back(pushed);
    }
    return outline;
}

/// The effect of rounding alone, for coordinates of this size.
double rounding_error(std::span<const Outline> outlines) {
    double size = 0.0;
    for (const Outline& outline : outlines) {
        for (const Point<double>& p : outline) {
            size = std::max(size, p.cwiseAbs().maxCoeff());
        }
    }
    return 4.0 * std::numeric_limits<double>::epsilon() * size * perimeter(outlines);
}

/// A number of steps that moves some points of the curve, within the tolerance, to the same
/// positions as twice as many steps.
int half_of_steps(const ParametricCurve& curve, const Flow& flow, double time) {
    Outline first(pilots);
    for (int i = 0; i < pilots; ++i) {
        first[static_cast<std::size_t>(i)] = curve.point(static_cast<double>(i) / pilots);
    }
    const double tolerance = same_place * std::sqrt(curve.area);
    const double max_steps = std::clamp(16.0 * time, 200.0, 1e5);
    for (int steps = 8;; steps += steps / 2) {
        Outline rough = first;
        Outline fine = first;
        runge_kutta_map(flow, 0.0, time, steps)(rough);
        runge_kutta_map(flow, 0.0, time, 2 * steps)(fine);
        const auto is_same = [&](const Point<double>& p, const Point<double>& q) {
            return length(p - q) <= tolerance;
        };
        if (steps >= max_steps || std::equal(rough.begin(), rough.end(), fine.begin(), is_same)) {
            return steps;
        }
    }
}

template <class Move>
ExactShape rigid(std::span<const Outline> first, Move move) {
    ExactShape shape;
    shape.outlines.assign(first.begin(), first.end());
    for (Outline& outline : shape.outlines) {
        for (Point<double>& p : outline) {
            p = move(p);
        }
    }
    shape.area = signed_area(first);
    shape.own_error = rounding_error(shape.outlines);
    return shape;
}

} // namespace

ExactShape translated_shape(std::span<const Outline> first, const Point<double>& displacement) {
    const auto move = [&](const Point<double>& p) -> Point<double> { return p + displacement; };
    return rigid(first, move);
}

ExactShape rotated_shape(std::span<const Outline> first, const Point<double>& centre,
                         double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto move = [&](const Point<double>& p) -> Point<double> {
        const Point<double> d = p - centre;
        return centre + Point<double>{c * d.x() - s * d.y(), s * d.x() + c * d.y()};
    };
    return rigid(first, move);
}

ExactShape exact_circle(const Point<double>& centre, double radius, int vertices) {
    const ParametricCurve curve = circle_curve(centre, radius);
    const double angle = 2.0 * pi / vertices;
    const ParametricCurve outer = circle_curve(centre, radius * std::sqrt(angle / std::sin(angle)));
    ExactShape shape;
    Outline outline;
    outline.reserve(static_cast<std::size_t>(vertices));
    for (int i = 0; i < vertices; ++i) {
        outline.push_back(outer.point(static_cast<double>(i) / vertices));
    }
    shape.outlines.push_back(std::move(outline));
    shape.area = curve.area;
    // Vertices lie outside the circle by 2/3 of the height of a segment, the middles of edges
    // inside by 1/3: the mean of |1/3 - u^2| over 0 < u < 1 is 4 / (9 sqrt 3).
    const double height = 0.125 * radius * angle * angle;
    shape.own_error = 4.0 / (9.0 * std::numbers::sqrt3) * height * 2.0 * pi * radius +
                      rounding_error(shape.outlines);
    return shape;
}

MarkerOptions markers_for(const ParametricCurve& curve, double edge_length) {
    const double length = edge_length / std::sqrt(curve.area);
    return {.spacing = 0.05 * length, .deviation = 2e-4 * length * length};
}

ExactShape mapped_shape(const ParametricCurve& curve, const FlowMap& map, const FlowMap& rough,
                        const MarkerOptions& options) {
    const double unit = std::sqrt(curve.area);
    const double spacing = options.spacing * unit;
    const double deviation = options.deviation * unit;
    ExactShape shape;
    shape.outlines.push_back(balanced_outline(spread_markers(curve, map, spacing, deviation)));
    const Outline check =
        balanced_outline(spread_markers(curve, rough, 2.0 * spacing, 4.0 * deviation));
    shape.area = curve.area;
    // The error of chords falls with the square of their length, and that of the steps with a
    // higher power: if markers are twice as far apart, the difference is at least three times the
    // error of the finer result. Intervals are divided into a whole number of parts, so the actual
    // factor may be smaller.
    const double ratio =
        static_cast<double>(shape.outlines.front().size()) / static_cast<double>(check.size());
    shape.own_error = symmetric_difference(shape.outlines.front(), check) /
                          std::clamp(ratio * ratio - 1.0, 1.0, 3.0) +
                      rounding_error(shape.outlines);
    return shape;
}

ExactShape advected_shape(const ParametricCurve& curve, const Flow& flow, double time,
                          const MarkerOptions& options) {
    const int half = half_of_steps(curve, flow, time);
    return mapped_shape(curve, runge_kutta_map(flow, 0.0, time, 2 * half),
                        runge_kutta_map(flow, 0.0, time, half), options);
}

ExactShape unmoved_shape(const ParametricCurve& curve, const MarkerOptions& options) {
    const FlowMap stay = [](std::span<Point<double>>) {};
    return mapped_shape(curve, stay, stay, options);
}

} // namespace dsc::scenes
