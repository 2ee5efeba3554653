// SPDX-License-Identifier: MIT
#include "geometric_flows/growth_fans.h"

#include "dsc/motion/movement.h"
#include "dsc/operations/edge_split.h"
#include "geometric_flows/growth_notches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dsc {

namespace {

// In edge lengths.
constexpr double beside = 0.05; // distance of the vertices of a fan at the start
constexpr double roomy = 0.25;  // the radius at which they move to their rays
constexpr double grown = 1.5;   // the radius from which on a fan may dissolve
constexpr double stray = 1e-3;  // a vertex farther from its ray than this leaves the fan
constexpr std::uint32_t max_members = 32;

// The normal at the feature of the sheet on one side. False if another submesh owns part of it.
template <class Real>
bool sheet_normal(GrowthFronts<Real>& fronts, const Star<Real>& star, const GrowthBend<Real>& bend,
                  std::uint32_t incident_edge, Point<Real>& normal) {
    Star<Real>& next_star = fronts.work.other_star;
    const bool gathered =
        gather(fronts.complex, fronts.work.submesh.region, star.link[incident_edge], next_star);
    if (!next_star.owned) {
        return false;
    }
    const Point<Real> before = link_point(star, incident_edge);
    Point<Real> first = before;
    if (const GrowthBend<Real> next = gathered ? fronts.bend_of(next_star) : GrowthBend<Real>{};
        next.known && !fronts.is_feature(next_star.vertex)) {
        first = incident_edge == bend.in ? next.from : next.to;
    }
    const Point<Real> tangent = end_tangent<Real>(first, before, bend.at);
    normal = incident_edge == bend.in ? Point<Real>(tangent.y(), -tangent.x())
                                      : Point<Real>(-tangent.y(), tangent.x());
    return true;
}

// Puts up to `wanted` vertices on the edge from v, the farthest first; returns how many.
template <class Real>
std::uint32_t split_towards(GrowthFronts<Real>& fronts, std::uint32_t v, std::uint32_t to,
                            std::uint32_t wanted, std::span<std::uint32_t> made) {
    const Point<Real> at = fronts.complex.position(Vertex{v});
    const Point<Real> edge = fronts.complex.position(Vertex{to}) - at;
    const Real length = edge.norm();
    const Real spacing =
        std::min(fronts.lengths(beside), Real(0.5) * length / static_cast<Real>(wanted + 1));
    std::uint32_t count = 0;
    for (std::uint32_t k = wanted; k > 0; --k) {
        const Point<Real> point = at + (spacing * static_cast<Real>(k) / length) * edge;
        const Corner corner = fronts.complex.find_half_edge(Vertex{v}, Vertex{to});
        if (corner == no_id || !owns_place(fronts.work.submesh.region, point)) {
            break;
        }
        const SplitResult result = edge_split(fronts.work.submesh, corner, point);
        if (result.verdict != Verdict::legal) {
            break;
        }
        to = result.vertex.id;
        made[count++] = to;
    }
    return count;
}

// Puts the vertex on its ray, if there is room.
template <class Real>
void place_on_ray(GrowthFronts<Real>& fronts, const Star<Real>& star, FanRay<Real>& ray,
                  Real radius) {
    const Point<Real> target = ray.source + radius * ray.direction;
    if (owns_place(fronts.work.submesh.region, target) &&
        all_positive(star, target.x(), target.y())) {
        rewire::move(fronts.complex, fronts.work.log, star.vertex, target.x(), target.y(),
                     MoveReason::flow);
        ray.state = FanState::open;
    }
}

template <class Real>
void end_closing(GrowthFronts<Real>& fronts, const Star<Real>& star, const GrowthBend<Real>& bend) {
    FanRay<Real>& ray = fronts.rays[Vertex{star.vertex}];
    const bool is_last = ray.to_last == 0;
    if (is_last || !(fronts.collapse_into(star, bend.out) || fronts.collapse_into(star, bend.in))) {
        ray = {};
        fronts.complex.set_feature(Vertex{star.vertex}, is_last);
    }
}

// Closes a fan that would vanish in this sub-step. The sheets meet in a notch on the other side
// of the source: the last vertex moves there, and the others to places close to it on the first
// sheet, from where they can be removed without harm.
template <class Real>
void close_fan(GrowthFronts<Real>& fronts, const Star<Real>& star, const GrowthBend<Real>& bend,
               bool is_inside) {
    FanRay<Real>& ray = fronts.rays[Vertex{star.vertex}];
    const Real radius = along(ray, bend.at);
    const Real time = fronts.way(bend.speed) / std::abs(bend.speed);
    const Real left = std::abs(radius) - fronts.lengths(GrowthFronts<Real>::margin);
    // A vertex inside the fan gets a second chance to be removed, as its star may not allow it
    // at first.
    if (is_inside && left < 2 * fronts.way(bend.speed) &&
        (fronts.collapse_into(star, bend.in) || fronts.collapse_into(star, bend.out))) {
        return;
    }
    if (left > fronts.way(bend.speed)) {
        return;
    }
    const Real to_first = static_cast<Real>(ray.to_first);
    const Real to_last = static_cast<Real>(ray.to_last);
    const Point<Real> first = turned<Real>(ray.direction, to_first);
    const Point<Real> sum = first + turned<Real>(ray.direction, to_last);
    const Point<Real> notch =
        ray.source + 2 * (radius + bend.speed * time) / sum.squaredNorm() * sum;
    const Real share = to_last / (to_last - to_first);
    const Point<Real> place = notch + fronts.lengths(GrowthFronts<Real>::margin) * share *
                                          Point<Real>(first.y(), -first.x());
    ray.direction = (place - bend.at) / time;
    ray.state = FanState::closing;
}

} // namespace

template <class Real>
void open_fan(GrowthFronts<Real>& fronts, std::uint32_t v, const GrowthBend<Real>& bend) {
    const Star<Real>& star = fronts.work.star;
    Point<Real> first;
    Point<Real> last;
    if (!sheet_normal(fronts, star, bend, bend.in, first) ||
        !sheet_normal(fronts, star, bend, bend.out, last)) {
        fronts.work.deferred.remeshing(v);
        return;
    }
    const Real angle = std::atan2(cross<Real>(first, last), first.dot(last));
    if (angle * bend.turn <= 0) {
        return; // nearly a half turn
    }
    if (std::abs(angle) < fronts.smooth_angle) { // the chords of one bend, and no feature
        fronts.complex.set_feature(Vertex{v}, false);
        return;
    }
    const auto edges = std::min(
        static_cast<std::uint32_t>(std::ceil(std::abs(angle) / fronts.fan_angle)), max_members - 1);
    const std::uint32_t before = edges / 2;
    const std::uint32_t after = edges - before;
    const IdPool& pool = *fronts.work.submesh.pool;
    if (!pool.may_grow &&
        (pool.vertices.size() < edges || pool.triangles.size() < 2 * std::size_t{edges})) {
        fronts.work.deferred.remeshing(v);
        return;
    }
    // The members of the fan, in the order of the curve.
    std::array<std::uint32_t, max_members> members{};
    std::uint32_t count = 0;
    const std::uint32_t in = star.link[bend.in];
    const std::uint32_t out = star.link[bend.out];
    count += split_towards(fronts, v, in, before, std::span(members).first(before));
    members[count++] = v;
    const std::uint32_t found =
        split_towards(fronts, v, out, after, std::span(members).subspan(count, after));
    std::reverse(members.begin() + count, members.begin() + count + found);
    count += found;
    for (std::uint32_t k = 0; k < count; ++k) {
        const Real by = count > 1 ? angle * static_cast<Real>(k) / static_cast<Real>(count - 1) : 0;
        const Point<Real> direction = turned<Real>(first, by);
        const Vertex member{members[k]};
        const Real start = (fronts.complex.position(member) - bend.at).dot(direction);
        fronts.rays[member] = {bend.at,
                               direction,
                               static_cast<float>(start),
                               static_cast<float>(-by),
                               k + 1 == count ? 0 : static_cast<float>(angle - by),
                               FanState::opening};
        fronts.complex.set_feature(member, true);
    }
}

template <class Real>
void tend_fan(GrowthFronts<Real>& fronts, const Star<Real>& star, const GrowthBend<Real>& bend) {
    const Vertex v{star.vertex};
    FanRay<Real>& ray = fronts.rays[v];
    const FanRay<Real>& before = fronts.rays[Vertex{star.link[bend.in]}];
    const FanRay<Real>& after = fronts.rays[Vertex{star.link[bend.out]}];
    const bool is_inside = belong_together(before, ray) && belong_together(ray, after);
    if (ray.state == FanState::closing) {
        end_closing(fronts, star, bend);
        return;
    }
    if (ray.state == FanState::inserted) {
        if (!is_inside) {
            ray = {};
            return;
        }
        const Real radius = (along(before, bend.from) + along(after, bend.to)) / 2;
        place_on_ray(fronts, star, ray, radius);
        return;
    }
    const Real radius = along(ray, bend.at);
    if (ray.state == FanState::opening) {
        if (std::abs(radius) > fronts.lengths(roomy)) {
            place_on_ray(fronts, star, ray, radius);
        }
        return;
    }
    const Real aside = std::abs(cross<Real>(ray.direction, bend.at - ray.source));
    // If the speed depends on the position, rays bend.
    const auto differs = [&](const FanRay<Real>& other, const Point<Real>& at) {
        return belong_together(ray, other) && other.state == FanState::open &&
               std::abs(along(other, at) - radius) > fronts.lengths(stray);
    };
    const bool is_free = std::abs(radius) > fronts.lengths(grown) &&
                         (differs(before, bend.from) || differs(after, bend.to));
    if (aside > fronts.lengths(stray) || is_free) {
        ray = {};
        mark_notch(fronts, v.id, bend);
    } else if (bend.speed * radius < 0) {
        close_fan(fronts, star, bend, is_inside);
    } else if (is_inside && std::abs(radius) > fronts.lengths(grown)) {
        fronts.complex.set_feature(v, false);
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void open_fan(GrowthFronts<Real>&, std::uint32_t, const GrowthBend<Real>&);           \
    template void tend_fan(GrowthFronts<Real>&, const Star<Real>&, const GrowthBend<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
