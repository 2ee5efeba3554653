// SPDX-License-Identifier: MIT
// A vertex p with neighbours a and b is projected to the exact curve, and so are a and b; the exact
// turn is that of the polyline of the three projections. As these are about as far apart as the
// vertices, a turn between chords is compared with a turn between chords, and a corner of the exact
// curve counts wherever it lies between a and b.
//
// Projections do not always give the right stretch of the curve:
// - They nearly coincide if vertices outside a corner are all nearest to the corner itself, or if
//   an edge is perpendicular to the curve. The direction between them is then meaningless.
// - Their order differs from that of the vertices if the polygon folds back. Their polyline would
//   also fold, and the fold would not be detected.
// So the stretch is measured in arc length: from p's projection back to a's and forward to b's, but
// in either direction at least a fraction of the edge of the polygon. Short edges of the polygon
// itself need no exception: if their turn is large, the polygon is jagged.
// - The nearest point lies on the far side of a filament that is thinner than the error of p. The
//   curve runs in the opposite direction there; a nearby point where it runs in the right direction
//   is used instead.
#include "measures/jaggedness.h"

#include "dsc/geometry/points.h"
#include "measures/compensated_sum.h"
#include "measures/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace dsc::scenes {

namespace {

/// The shortest stretch of the exact curve on either side of a vertex, relative to the edge there:
/// less than the distance between projections of any smooth polygon.
constexpr double shortest_stretch = 0.25;

/// The allowed turn at a vertex: this multiple of the exact curve's turn, plus a constant.
constexpr double turn_factor = 2.0;
constexpr double turn_slack_deg = 2.0;

double turn_deg(const Point<double>& a, const Point<double>& b, const Point<double>& c) {
    return turn_angle<double>(a, b, c) * (180.0 / std::numbers::pi);
}

/// A point of the exact curves, given by the arc length before it, counted over all outlines in
/// turn.
struct Place {
    std::size_t segment = 0;
    double arc = 0.0;
};

/// The exact curves, searchable by place and by arc length.
class ExactCurves {
public:
    ExactCurves(std::span<const Outline> outlines, double scale)
        : tree_(segments_of(outlines, scale)) {
        for (const Outline& outline : outlines) {
            first_.push_back(outline_.size());
            outline_.insert(outline_.end(), outline.size(), first_.size() - 1);
        }
        first_.push_back(outline_.size());
        CompensatedSum arc;
        for (const Segment& segment : tree_.segments()) {
            begin_.push_back(arc.value());
            arc.add((segment.b - segment.a).norm());
        }
        begin_.push_back(arc.value());
    }

    /// The point nearest to p; a point where the curve runs along `direction` is preferred if it is
    /// at most `reach` farther away.
    [[nodiscard]] Place project(const Point<double>& p, const Point<double>& direction,
                                double reach, std::size_t guess) const {
        Near near = tree_.nearest(p, guess, 0.0);
        const Segment& nearest = tree_.segments()[near.segment];
        if (direction.dot(nearest.b - nearest.a) < 0.0) {
            near = tree_.nearest_along(p, direction, near.distance + reach).value_or(near);
        }
        const Segment& found = tree_.segments()[near.segment];
        const double fraction = nearest_fraction<double>(p, found.a, found.b);
        return {near.segment, begin_[near.segment] +
                                  fraction * (begin_[near.segment + 1] - begin_[near.segment])};
    }

    /// The arc length from one place forward to another; negative if the way back is shorter;
    /// `otherwise` if they are on different curves.
    [[nodiscard]] double ahead(const Place& from, const Place& to, double otherwise) const {
        return outline_[from.segment] != outline_[to.segment]
                   ? otherwise
                   : std::remainder(to.arc - from.arc, length(from));
    }

    [[nodiscard]] Point<double> point(const Place& from, double ahead) const {
        const std::size_t outline = outline_[from.segment];
        const double start = begin_[first_[outline]];
        double arc = std::fmod(from.arc + ahead - start, length(from));
        arc = start + (arc < 0.0 ? arc + length(from) : arc);
        const auto range = begin_.begin();
        const auto found =
            std::upper_bound(range + static_cast<std::ptrdiff_t>(first_[outline]) + 1,
                             range + static_cast<std::ptrdiff_t>(first_[outline + 1]), arc);
        const auto i = static_cast<std::size_t>(found - range) - 1;
        const Segment& segment = tree_.segments()[i];
        const double size = begin_[i + 1] - begin_[i];
        const double fraction = size > 0.0 ? std::clamp((arc - begin_[i]) / size, 0.0, 1.0) : 0.0;
        return segment.a + fraction * (segment.b - segment.a);
    }

private:
    /// Length of the curve that contains a place.
    [[nodiscard]] double length(const Place& place) const {
        const std::size_t outline = outline_[place.segment];
        return begin_[first_[outline + 1]] - begin_[first_[outline]];
    }

    SegmentTree tree_;
    std::vector<std::size_t> outline_; ///< of each segment
    std::vector<std::size_t> first_;   ///< segment of each outline, and the end
    std::vector<double> begin_;        ///< arc length before each segment, and the end
};

double exact_turn_deg(const ExactCurves& curves, const Place& a, const Place& p, const Place& b,
                      double edge_before, double edge_after) {
    const double before =
        std::max(-curves.ahead(p, a, -edge_before), shortest_stretch * edge_before);
    const double after = std::max(curves.ahead(p, b, edge_after), shortest_stretch * edge_after);
    return turn_deg(curves.point(p, -before), curves.point(p, 0.0), curves.point(p, after));
}

} // namespace

Jaggedness measure_jaggedness(std::span<const Outline> polygons, std::span<const Outline> exact) {
    const double scale = unit_scale(polygons, exact, "measure_jaggedness");
    Jaggedness result;
    if (polygons.empty() || exact.empty()) {
        return result;
    }
    const ExactCurves curves(exact, scale);
    std::size_t guess = 0;
    for (const Outline& polygon : polygons) {
        const std::size_t n = polygon.size();
        std::vector<Point<double>> points;
        for (const Point<double>& p : polygon) {
            points.emplace_back(scale * p);
        }
        std::vector<double> edges; // edges[i] ends in vertex i
        for (std::size_t i = 0; i < n; ++i) {
            edges.push_back((points[i] - points[(i + n - 1) % n]).norm());
        }
        std::vector<Place> places;
        for (std::size_t i = 0; i < n; ++i) {
            places.push_back(curves.project(points[i],
                                            points[(i + 1) % n] - points[(i + n - 1) % n],
                                            std::max(edges[i], edges[(i + 1) % n]), guess));
            guess = places.back().segment;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t before = (i + n - 1) % n;
            const std::size_t after = (i + 1) % n;
            const double turn = std::abs(turn_deg(points[before], points[i], points[after]));
            const double exact_turn = std::abs(exact_turn_deg(
                curves, places[before], places[i], places[after], edges[i], edges[after]));
            const double excess = turn - (turn_factor * exact_turn + turn_slack_deg);
            if (excess > result.largest_excess_deg) {
                result.largest_excess_deg = excess;
                result.worst = polygon[i];
            }
        }
    }
    return result;
}

} // namespace dsc::scenes
