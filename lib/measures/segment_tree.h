// SPDX-License-Identifier: MIT
// Finds the edge of outlines nearest to a point, by a tree of boxes over the edges in their order
// along the curves. Unlike a grid, it is efficient for distant and unequal curves, too.
#pragma once

#include "shapes/outline.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dsc::scenes {

struct Segment {
    Point<double> a;
    Point<double> b;

    [[nodiscard]] double distance(const Point<double>& p) const;
};

/// The edges of all outlines in their order, scaled.
[[nodiscard]] std::vector<Segment> segments_of(std::span<const Outline> outlines, double scale);

/// The power of two that scales the box around both sets to a size from 1/2 to 1, so that no square
/// under- or overflows and scaling is exact. Throws InputError with `where` for an outline with
/// fewer than three points, or with a point that is not finite.
[[nodiscard]] double unit_scale(std::span<const Outline> first, std::span<const Outline> second,
                                const std::string& where);

/// A segment and its distance from a query point.
struct Near {
    std::size_t segment = 0;
    double distance = std::numeric_limits<double>::infinity();
};

/// A tree over n segments, at least one; built in O(n), queried in O(log n) if the point is near
/// the segments.
class SegmentTree {
public:
    explicit SegmentTree(std::vector<Segment> segments);

    [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

    /// The segment nearest to p, or any within the distance `enough`. `guess` is tried first.
    [[nodiscard]] Near nearest(const Point<double>& p, std::size_t guess, double enough) const;

    /// The segment nearest to p among those that do not run against `direction`; empty if no such
    /// segment is nearer than `within`.
    [[nodiscard]] std::optional<Near>
    nearest_along(const Point<double>& p, const Point<double>& direction, double within) const;

private:
    struct Query {
        Point<double> point;
        double enough; ///< the search ends at this distance
    };

    /// Replaces `best` by the nearest accepted segment below a node, if that is nearer.
    template <class Accept>
    void search(std::size_t node, double bound, const Query& query, Accept accept,
                Near& best) const;

    std::vector<Segment> segments_;
    std::size_t leaves_ = 1;
    std::vector<Eigen::AlignedBox2d> boxes_; ///< of the segments below each node
};

} // namespace dsc::scenes
