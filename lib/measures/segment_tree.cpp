// SPDX-License-Identifier: MIT
#include "measures/segment_tree.h"

#include "dsc/geometry/points.h"

#include <algorithm>
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
void SegmentTree::search(std::size_t node, double bound, const Query& query, Accept accept,
                         Near& best) const {
    if (bound >= best.distance || best.distance <= query.enough) {
        return;
    }
    if (node < leaves_) {
        const double left = boxes_[2 * node].exteriorDistance(query.point);
        const double right = boxes_[2 * node + 1].exteriorDistance(query.point);
        const bool is_right_first = right < left;
        search(2 * node + (is_right_first ? 1 : 0), std::min(left, right), query, accept, best);
        search(2 * node + (is_right_first ? 0 : 1), std::max(left, right), query, accept, best);
        return;
    }
    const std::size_t begin = (node - leaves_) * leaf;
    const std::size_t end = std::min(begin + leaf, segments_.size());
    for (std::size_t i = begin; i < end; ++i) {
        const double distance = segments_[i].distance(query.point);
        if (distance < best.distance && accept(segments_[i])) {
            best = {i, distance};
        }
    }
}

Near SegmentTree::nearest(const Point<double>& p, std::size_t guess, double enough) const {
    Near best{guess, segments_[guess].distance(p)};
    search(
        1, 0, {p, enough}, [](const Segment&) { return true; }, best);
    return best;
}

std::optional<Near> SegmentTree::nearest_along(const Point<double>& p,
                                               const Point<double>& direction,
                                               double within) const {
    const std::size_t none = segments_.size();
    Near best{none, within};
    const auto runs_along = [&](const Segment& segment) {
        return direction.dot(segment.b - segment.a) >= 0.0;
    };
    search(1, 0, {p, 0}, runs_along, best);
    return best.segment == none ? std::nullopt : std::optional(best);
}

} // namespace dsc::scenes
