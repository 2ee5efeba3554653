// SPDX-License-Identifier: MIT
// Finds the triangles of a surface near a point or a box: not public.
#pragma once

#include "dsc3/initial/shapes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace dsc3 {

using Triangle3 = std::array<std::uint32_t, 3>;

inline Box box_of(const TriangleSurface& surface, const Triangle3& t) {
    const Point& a = surface.points[t[0]];
    const Point& b = surface.points[t[1]];
    const Point& c = surface.points[t[2]];
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

inline Real squared_distance_to(const Box& box, const Point& p) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(0).squaredNorm();
}

inline bool overlap(const Box& a, const Box& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

// A tree of boxes around triangles, which it does not own. The first child is stored directly after
// its parent.
class BoxTree {
public:
    explicit BoxTree(const TriangleSurface& surface) : surface_(surface) {
        order_.resize(surface.triangles.size());
        std::iota(order_.begin(), order_.end(), 0U);
        build(0, static_cast<std::uint32_t>(order_.size()));
    }

    // Calls `visit(triangle)` for the triangles in boxes with `is_near(box)`, which may become
    // stricter during the search. Visits the child first for which `comes_first(its box, the
    // other)`.
    template <class IsNear, class ComesFirst, class Visit>
    void search(IsNear is_near, ComesFirst comes_first, Visit visit, std::uint32_t node = 0) const {
        const Node& here = nodes_[node];
        if (!is_near(here.box)) {
            return;
        }
        if (here.second == 0) {
            for (std::uint32_t i = here.begin; i < here.end; ++i) {
                visit(order_[i]);
            }
            return;
        }
        const bool is_first = comes_first(nodes_[node + 1].box, nodes_[here.second].box);
        search(is_near, comes_first, visit, is_first ? node + 1 : here.second);
        search(is_near, comes_first, visit, is_first ? here.second : node + 1);
    }

private:
    static constexpr std::uint32_t leaf_size = 4;
    struct Node {
        Box box;
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t second = 0; ///< child; 0: a leaf
    };

    void build(std::uint32_t begin, std::uint32_t end) {
        const auto node = static_cast<std::uint32_t>(nodes_.size());
        Box box{Point::Constant(std::numeric_limits<Real>::infinity()),
                Point::Constant(-std::numeric_limits<Real>::infinity())};
        for (std::uint32_t i = begin; i < end; ++i) {
            const Box one = box_of(surface_, surface_.triangles[order_[i]]);
            box = {box.low.cwiseMin(one.low), box.high.cwiseMax(one.high)};
        }
        nodes_.push_back({box, begin, end, 0});
        if (end - begin <= leaf_size) {
            return;
        }
        Eigen::Index axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        const auto place = [&](std::uint32_t t) {
            const auto& [a, b, c] = surface_.triangles[t];
            return surface_.points[a][axis] + surface_.points[b][axis] + surface_.points[c][axis];
        };
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                         [&](std::uint32_t s, std::uint32_t t) {
                             return place(s) != place(t) ? place(s) < place(t) : s < t;
                         });
        build(begin, middle);
        nodes_[node].second = static_cast<std::uint32_t>(nodes_.size());
        build(middle, end);
    }

    const TriangleSurface& surface_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace dsc3
