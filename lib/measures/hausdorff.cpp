// SPDX-License-Identifier: MIT
// Branch and bound. The distance to a fixed segment is convex along an edge, so its values at the
// two ends of a part of an edge bound it from above; a part whose bound exceeds the largest
// distance found so far is halved.
#include "measures/hausdorff.h"

#include "measures/segment_tree.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace dsc::scenes {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// After this number of halvings, a part of an edge has no length in double precision.
constexpr int max_halvings = 60;

/// Absolute error of the result; both curves are scaled to a size of about 1.
constexpr double tolerance = 1e-10;

struct Farthest {
    double distance = 0.0;
    Point<double> point{0.0, 0.0};
};

/// A part of an edge, with a segment of the other curve near each of its ends.
struct Part {
    Point<double> a, b;
    Near near_a, near_b;
    int halvings;
};

/// Upper bound: no point of the part is farther from the other curve.
double bound(const Part& part, const std::vector<Segment>& others) {
    const double by_a =
        std::max(part.near_a.distance, others[part.near_a.segment].distance(part.b));
    const double by_b =
        std::max(part.near_b.distance, others[part.near_b.segment].distance(part.a));
    return std::min(by_a, by_b);
}

Farthest directed(const std::vector<Segment>& from, const SegmentTree& to) {
    Farthest farthest;
    const auto look = [&](const Point<double>& p, std::size_t guess) {
        const Near near = to.nearest(p, guess, farthest.distance);
        if (near.distance > farthest.distance) {
            farthest = {near.distance, p};
        }
        return near;
    };
    // Vertices first: the larger the distance already known, the fewer edges have to be halved.
    std::vector<Near> ends;
    ends.reserve(2 * from.size());
    std::size_t guess = 0;
    for (const Segment& edge : from) {
        ends.push_back(look(edge.a, guess));
        ends.push_back(look(edge.b, ends.back().segment));
        guess = ends.back().segment;
    }
    std::vector<Part> parts;
    for (std::size_t i = 0; i < from.size(); ++i) {
        parts.push_back({from[i].a, from[i].b, ends[2 * i], ends[2 * i + 1], 0});
        while (!parts.empty()) {
            const Part part = parts.back();
            parts.pop_back();
            if (part.halvings >= max_halvings ||
                bound(part, to.segments()) <= farthest.distance + tolerance) {
                continue;
            }
            const Point<double> middle = 0.5 * (part.a + part.b);
            const Near near = look(middle, part.near_a.segment);
            parts.push_back({middle, part.b, near, part.near_b, part.halvings + 1});
            parts.push_back({part.a, middle, part.near_a, near, part.halvings + 1});
        }
    }
    return farthest;
}

} // namespace

HausdorffDistance hausdorff(std::span<const Outline> first, std::span<const Outline> second) {
    const double scale = unit_scale(first, second, "hausdorff");
    HausdorffDistance result;
    if (first.empty() || second.empty()) {
        result.first_to_second = first.empty() ? 0.0 : infinity;
        result.second_to_first = second.empty() ? 0.0 : infinity;
        return result;
    }
    const SegmentTree tree1(segments_of(first, scale));
    const SegmentTree tree2(segments_of(second, scale));
    const Farthest there = directed(tree1.segments(), tree2);
    const Farthest back = directed(tree2.segments(), tree1);
    result.first_to_second = there.distance / scale;
    result.second_to_first = back.distance / scale;
    result.farthest = (there.distance > back.distance ? there.point : back.point) / scale;
    return result;
}

} // namespace dsc::scenes
