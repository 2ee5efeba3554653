// SPDX-License-Identifier: MIT
// Branch and bound. The distance to one fixed segment is convex along an edge, so that the two ends
// of (a part of) an edge bound it from above; a part whose bound exceeds what was found already is
// halved. Nearest segments come from a tree of boxes over the edges in their order along the
// curves: unlike a grid, it does not mind how far apart or how unequal the curves are.
#include "scenes/hausdorff.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace dsc::scenes {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Halving an edge more often than this leaves nothing of it in double precision.
constexpr int most_halvings = 60;

struct Segment {
    Point<double> a;
    Point<double> b;

    [[nodiscard]] double distance(const Point<double>& p) const {
        const double dx = b.x() - a.x();
        const double dy = b.y() - a.y();
        const double px = p.x() - a.x();
        const double py = p.y() - a.y();
        const double dot = dx * px + dy * py;
        const double square = dx * dx + dy * dy;
        if (dot <= 0.0) {
            return std::sqrt(px * px + py * py);
        }
        if (dot >= square) {
            const double qx = p.x() - b.x();
            const double qy = p.y() - b.y();
            return std::sqrt(qx * qx + qy * qy);
        }
        return std::abs(dx * py - dy * px) / std::sqrt(square);
    }
};

struct Box {
    double left = infinity;
    double right = -infinity;
    double low = infinity;
    double high = -infinity;

    void include(const Point<double>& p) {
        left = std::min(left, p.x());
        right = std::max(right, p.x());
        low = std::min(low, p.y());
        high = std::max(high, p.y());
    }
    void include(const Box& box) {
        left = std::min(left, box.left);
        right = std::max(right, box.right);
        low = std::min(low, box.low);
        high = std::max(high, box.high);
    }
    /// No point of the box is nearer. Infinite for an empty box.
    [[nodiscard]] double distance(const Point<double>& p) const {
        const double x = std::max({left - p.x(), p.x() - right, 0.0});
        const double y = std::max({low - p.y(), p.y() - high, 0.0});
        return std::sqrt(x * x + y * y);
    }
};

/// A segment and its distance from a point that was asked for.
struct Near {
    std::size_t segment = 0;
    double distance = infinity;
};

class SegmentTree {
public:
    explicit SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)) {
        const std::size_t used = (segments_.size() + leaf - 1) / leaf;
        leaves_ = std::bit_ceil(std::max<std::size_t>(1, used));
        boxes_.resize(2 * leaves_);
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            boxes_[leaves_ + i / leaf].include(segments_[i].a);
            boxes_[leaves_ + i / leaf].include(segments_[i].b);
        }
        for (std::size_t node = leaves_; node-- > 1;) {
            boxes_[node] = boxes_[2 * node];
            boxes_[node].include(boxes_[2 * node + 1]);
        }
    }

    [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

    /// The segment nearest to p, or any that is not farther than `enough`. `guess` is tried first.
    [[nodiscard]] Near nearest(const Point<double>& p, std::size_t guess, double enough) const {
        Near best{guess, segments_[guess].distance(p)};
        if (best.distance <= enough) {
            return best;
        }
        // Every level leaves at most one node behind, and there are at most 64 levels.
        std::array<std::pair<std::size_t, double>, 130> stack;
        std::size_t size = 0;
        stack[size++] = {1, boxes_[1].distance(p)};
        while (size > 0) {
            const auto [node, bound] = stack[--size];
            if (bound >= best.distance) {
                continue;
            }
            if (node < leaves_) {
                std::pair near{2 * node, boxes_[2 * node].distance(p)};
                std::pair far{2 * node + 1, boxes_[2 * node + 1].distance(p)};
                if (far.second < near.second) {
                    std::swap(near, far);
                }
                stack[size++] = far;
                stack[size++] = near;
                continue;
            }
            const std::size_t begin = (node - leaves_) * leaf;
            const std::size_t end = std::min(begin + leaf, segments_.size());
            for (std::size_t i = begin; i < end; ++i) {
                const double distance = segments_[i].distance(p);
                if (distance < best.distance) {
                    best = {i, distance};
                }
            }
            if (best.distance <= enough) {
                return best;
            }
        }
        return best;
    }

private:
    static constexpr std::size_t leaf = 4;

    std::vector<Segment> segments_;
    std::size_t leaves_ = 1;
    std::vector<Box> boxes_;
};

struct Farthest {
    double distance = 0.0;
    Point<double> point{0.0, 0.0};
};

/// A part of an edge, with a segment of the other curve that is near to either end.
struct Part {
    Point<double> a, b;
    Near near_a, near_b;
    int halvings;
};

/// No point of the part is farther from the other curve.
double bound(const Part& part, const std::vector<Segment>& others) {
    const double by_a =
        std::max(part.near_a.distance, others[part.near_a.segment].distance(part.b));
    const double by_b =
        std::max(part.near_b.distance, others[part.near_b.segment].distance(part.a));
    return std::min(by_a, by_b);
}

Farthest directed(const std::vector<Segment>& from, const SegmentTree& to, double tolerance) {
    Farthest farthest;
    const auto look = [&](const Point<double>& p, std::size_t guess) {
        const Near near = to.nearest(p, guess, farthest.distance);
        if (near.distance > farthest.distance) {
            farthest = {near.distance, p};
        }
        return near;
    };
    // Vertices first: the larger the distance already known, the fewer edges need a second look.
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
            if (part.halvings >= most_halvings ||
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

void include(std::span<const Outline> outlines, Box& box) {
    for (const Outline& outline : outlines) {
        check_outline(outline, "hausdorff");
        for (const Point<double>& p : outline) {
            box.include(p);
        }
    }
}

/// The edges, scaled by a power of two so that no square under- or overflows.
std::vector<Segment> segments_of(std::span<const Outline> outlines, double scale) {
    std::vector<Segment> segments;
    for (const Outline& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            segments.push_back(
                {scale * outline[i], scale * outline[i + 1 == outline.size() ? 0 : i + 1]});
        }
    }
    return segments;
}

} // namespace

HausdorffDistance hausdorff(std::span<const Outline> first, std::span<const Outline> second,
                            const HausdorffOptions& options) {
    if (!(options.tolerance > 0.0)) {
        throw InputError("tolerance", "hausdorff", std::to_string(options.tolerance), "above 0");
    }
    Box box;
    include(first, box);
    include(second, box);
    HausdorffDistance result;
    if (first.empty() || second.empty()) {
        result.first_to_second = first.empty() ? 0.0 : infinity;
        result.second_to_first = second.empty() ? 0.0 : infinity;
        return result;
    }
    int exponent = 0;
    std::frexp(std::max(box.right - box.left, box.high - box.low), &exponent);
    const double scale = std::ldexp(1.0, -exponent);
    const SegmentTree tree1(segments_of(first, scale));
    const SegmentTree tree2(segments_of(second, scale));
    const Farthest there = directed(tree1.segments(), tree2, options.tolerance);
    const Farthest back = directed(tree2.segments(), tree1, options.tolerance);
    result.first_to_second = there.distance / scale;
    result.second_to_first = back.distance / scale;
    result.farthest = (there.distance > back.distance ? there.point : back.point) / scale;
    return result;
}

} // namespace dsc::scenes
