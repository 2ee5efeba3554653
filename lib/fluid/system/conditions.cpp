// SPDX-License-Identifier: MIT
#include "fluid/system/conditions.h"

#include "dsc/geometry/points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace dsc {

namespace {

// A side of the box around the domain.
struct BoxSide {
    const char* name;
    Wall wall;
};

BoxSide box_side(const Point<double>& from, const Point<double>& to, const Rectangle& box,
                 const Walls& walls) {
    const auto is_on = [&](int axis, double place) {
        return from[axis] == place && to[axis] == place;
    };
    return is_on(0, box.low.x())    ? BoxSide{"left", walls.left}
           : is_on(0, box.high.x()) ? BoxSide{"right", walls.right}
           : is_on(1, box.low.y())  ? BoxSide{"bottom", walls.bottom}
           : is_on(1, box.high.y()) ? BoxSide{"top", walls.top}
                                    : BoxSide{"other", walls.other};
}

} // namespace

SideConditions::SideConditions(const Rectangle& box, const FluidOptions& options)
    : box_(box), options_(options) {
    const std::vector<DomainEdge>& edges = options.domain_edges;
    if (edges.empty() || options.sides.empty()) {
        return;
    }
    leaves_ = std::bit_ceil(edges.size());
    boxes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        boxes_[leaves_ + i].extend(edges[i].from).extend(edges[i].to);
    }
    for (std::size_t node = leaves_ - 1; node > 0; --node) {
        boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]);
    }
}

// Of several edges at the same distance, the first one.
void SideConditions::search(std::size_t node, const Point<double>& place, Near& best) const {
    if (node >= leaves_) {
        const DomainEdge& edge = options_.domain_edges[node - leaves_];
        const Near found{squared_distance<double>(place, edge.from, edge.to), node - leaves_};
        if (std::pair(found.squared, found.edge) < std::pair(best.squared, best.edge)) {
            best = found;
        }
        return;
    }
    const auto squared = [&](std::size_t child) {
        return boxes_[child].isEmpty() ? std::numeric_limits<double>::infinity()
                                       : boxes_[child].squaredExteriorDistance(place);
    };
    std::array<std::pair<double, std::size_t>, 2> children{
        {{squared(2 * node), 2 * node}, {squared(2 * node + 1), 2 * node + 1}}};
    std::ranges::sort(children);
    for (const auto& [distance, child] : children) {
        constexpr double rounding = 1e-12; // relative, of the two distances
        if (distance <= (1 + rounding) * best.squared && !boxes_[child].isEmpty()) {
            search(child, place, best);
        }
    }
}

// The name of the domain's edge nearest to a place; empty if it has none.
std::string_view SideConditions::nearest_name(const Point<double>& place) const {
    if (boxes_.empty()) {
        return {};
    }
    Near best{std::numeric_limits<double>::infinity(), 0};
    search(1, place, best);
    return options_.domain_edges[best.edge].side;
}

SideCondition SideConditions::between(const Point<double>& from, const Point<double>& to) const {
    const auto [box_name, wall] = box_side(from, to, box_, options_.walls);
    const Point<double> middle = midpoint<double>(from, to);
    if (options_.wall_at) {
        return {.wall = options_.wall_at(middle)};
    }
    if (options_.sides.empty()) {
        return {.wall = wall};
    }
    const std::string_view given = nearest_name(middle);
    const auto side =
        std::ranges::find(options_.sides, given.empty() ? box_name : given, &FluidSide::name);
    if (side != options_.sides.end()) {
        return {side->wall, static_cast<std::uint32_t>(side - options_.sides.begin())};
    }
    return {.wall = given.empty() ? wall : Wall::no_slip};
}

} // namespace dsc
