// SPDX-License-Identifier: MIT
// The condition on each edge of the domain boundary, by the name of its side.
#pragma once

#include "fluid/options.h"

#include <Eigen/Geometry>

#include <string_view>
#include <vector>

namespace dsc {

/// The condition on an edge.
struct SideCondition {
    Wall wall = Wall::no_slip;
    std::uint32_t side = no_id; ///< in `FluidOptions::sides`; no_id: none of them
};

/// Finds the domain's edge nearest to a place by a tree of boxes over them in their order, because
/// a curved side has about as many as the mesh has on it.
class SideConditions {
public:
    /// For a domain with this box around it. The options must outlive this. O(edges of the domain).
    SideConditions(const Rectangle& box, const FluidOptions& options);

    /// On an edge of the mesh's boundary with these ends. O(log n) for n edges of the domain.
    [[nodiscard]] SideCondition between(const Point<double>& from, const Point<double>& to) const;

private:
    struct Near {
        double squared;
        std::size_t edge;
    };
    [[nodiscard]] std::string_view nearest_name(const Point<double>& place) const;
    void search(std::size_t node, const Point<double>& place, Near& best) const;

    Rectangle box_;
    const FluidOptions& options_;
    std::size_t leaves_ = 1;
    std::vector<Eigen::AlignedBox2d> boxes_; ///< of the edges below each node
};

} // namespace dsc
