// SPDX-License-Identifier: MIT
#include "measures/segment_tree.h"

#include "dsc/geometry/points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace dsc::scenes {

namespace {

/// Segments in a leaf of the tree.
constexpr std::size_t leaf = 4;

} // namespace

double Segment::distance(const Point<double>& p) const { return dsc::distance<double>(p, a, b); }

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

double unit_scale(std::span<const Outline> first, std::span<const Outline> second,
                  const std::string& where) {
    const Eigen::AlignedBox2d box = box_around(first, second, where);
    const double size = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    int exponent = 0;
    if (size > 0.0 && std::isfinite(size)) {
        std::frexp(size, &exponent);
    }
    return std::ldexp(1.0, -exponent);
}

SegmentTree::SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)) {
    const std::size_t used = (segments_.size() + leaf - 1) / leaf;
    leaves_ = std::bit_ceil(std::max<std::size_t>(1, used));
    boxes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        boxes_[leaves_ + i / leaf].extend(segments_[i].a);
        boxes_[leaves_ + i / leaf].extend(segments_[i].b);
    }
    for (std::size_t node = leaves_; node-- > 1;) {
        boxes_[node] = boxes_[2 * node];
        boxes_[node].extend(boxes_[2 * node + 1]);
    }
}

template <class Accept>
Near SegmentTree::search(const Point<double>& p, Near best, double enough, Accept accept) const {
    // Every level leaves at most one node behind, and there are at most 64 levels.
    std::array<std::pair<std::size_t, double>, 130> stack;
    std::size_t size = 0;
    stack[size++] = {1, boxes_[1].exteriorDistance(p)};
    while (size > 0) {
        const auto [node, bound] = stack[--size];
        if (bound >= best.distance) {
            continue;
        }
        if (node < leaves_) {
            std::pair near{2 * node, boxes_[2 * node].exteriorDistance(p)};
            std::pair far{2 * node + 1, boxes_[2 * node + 1].exteriorDistance(p)};
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
            if (distance < best.distance && accept(segments_[i])) {
                best = {i, distance};
            }
        }
        if (best.distance <= enough) {
            return best;
        }
    }
    return best;
}

Near SegmentTree::nearest(const Point<double>& p, std::size_t guess, double enough) const {
    const Near first{guess, segments_[guess].distance(p)};
    return first.distance <= enough ? first
                                    : search(p, first, enough, [](const Segment&) { return true; });
}

std::optional<Near> SegmentTree::nearest_along(const Point<double>& p,
                                               const Point<double>& direction,
                                               double within) const {
    const std::size_t none = segments_.size();
    const Near found = search(p, {none, within}, 0.0, [&](const Segment& segment) {
        return direction.dot(segment.b - segment.a) >= 0.0;
    });
    return found.segment == none ? std::nullopt : std::optional(found);
}

} // namespace dsc::scenes
