// SPDX-License-Identifier: MIT
#include "topology/fronts/front_point.h"

#include <algorithm>

namespace dsc {

namespace {

/// The way of a vertex that moved for less than this share of a sub-step says nothing.
constexpr double min_moved = 0.02;
/// A vertex is put at most so many sub-steps ahead.
constexpr double max_shares = 8;

template <class Real>
bool is_noted(const TopologyWork<Real>& work, std::uint32_t v) {
    return work.notes[Vertex{v}].round == work.round;
}

template <class Real>
bool was_junction(const TopologyWork<Real>& work, std::uint32_t v) {
    return !is_noted(work, v) || (work.notes[Vertex{v}].what & noted_junction) != 0;
}

template <class Real>
bool is_stopped(const TopologyWork<Real>& work, std::uint32_t v) {
    return (work.complex.vertices[v].flags & vertex_contact) != 0;
}

// The target of a vertex that did not arrive; null if it has none any more.
template <class Real>
const Missed<Real>* target_of(const TopologyWork<Real>& work, std::uint32_t v) {
    const auto found = std::ranges::lower_bound(work.missed, v, {}, &Missed<Real>::vertex);
    if (found == work.missed.end() || found->vertex != v || !is_noted(work, v)) {
        return nullptr;
    }
    const NotedPlace<Real>& before = work.places[Vertex{v}];
    return before.x == found->before.x && before.y == found->before.y ? &*found : nullptr;
}

template <class Real>
std::optional<Point<Real>> way_at(const TopologyWork<Real>& work, std::uint32_t v) {
    const Real share = work.ahead[Vertex{v}].share;
    if (!is_noted(work, v) || share < static_cast<Real>(min_moved)) {
        return std::nullopt;
    }
    const Missed<Real>* const missed = target_of(work, v);
    const Point<Real> end = missed != nullptr ? missed->target : work.complex.position(Vertex{v});
    return (end - place_before(work, v)) / share;
}

template <class Real>
std::optional<Real> speed_at(const TopologyWork<Real>& work, std::uint32_t v,
                             const Point<Real>& normal) {
    if (!was_junction(work, v) && (!is_stopped(work, v) || target_of(work, v) != nullptr)) {
        if (const auto way = way_at(work, v)) {
            return way->dot(normal);
        }
    }
    const Real speed = work.ahead[Vertex{v}].speed;
    return speed > 0 ? std::optional<Real>(speed * work.dt) : std::nullopt;
}

// The mean of what the ends know.
template <class Value, class Real, class Ask>
std::optional<Value> mean_of(const FrontPoint<Real>& point, Value sum, const Ask& ask) {
    Real weight = 0;
    for (const auto& end : point.ends) {
        if (const std::optional<Value> value =
                end.v != no_id ? ask(end.v) : std::optional<Value>()) {
            sum += end.weight * *value;
            weight += end.weight;
        }
    }
    return weight > 0 ? std::optional<Value>(sum / weight) : std::nullopt;
}

} // namespace

template <class Real>
std::optional<Point<Real>> way_of(const TopologyWork<Real>& work, const FrontPoint<Real>& point) {
    return mean_of(point, Point<Real>(Point<Real>::Zero()),
                   [&](std::uint32_t v) { return way_at(work, v); });
}

template <class Real>
std::optional<Real> speed_of(const TopologyWork<Real>& work, const FrontPoint<Real>& point,
                             const Point<Real>& normal) {
    return mean_of(point, Real(0), [&](std::uint32_t v) { return speed_at(work, v, normal); });
}

template <class Real>
Real lead_of(const TopologyWork<Real>& work, std::uint32_t v, const Point<Real>& normal,
             Real speed) {
    const Point<Real> place = work.complex.position(Vertex{v});
    if (const Missed<Real>* const missed = target_of(work, v)) {
        return (place - missed->target).dot(normal);
    }
    const TimeAhead<Real>& ahead = work.ahead[Vertex{v}];
    const Real lead = ahead.time / work.dt * speed;
    // The end of a seam may be slower than the place where the fronts would meet.
    return was_junction(work, v) && is_noted(work, v)
               ? lead + (place - place_before(work, v)).dot(normal) - ahead.share * speed
               : lead;
}

template <class Real>
void put_ahead(TopologyWork<Real>& work, std::uint32_t v, Real shares, Real speed) {
    constexpr auto most = static_cast<Real>(max_shares);
    TimeAhead<Real>& ahead = work.ahead[Vertex{v}];
    ahead.time = std::clamp(shares, -most, most) * work.dt;
    ahead.speed = speed / work.dt;
}

template <class Real>
bool is_blocked(const TopologyWork<Real>& work, const FrontPoint<Real>& point) {
    return std::ranges::any_of(
        point.ends, [&](const auto& end) { return end.v != no_id && is_stopped(work, end.v); });
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::optional<Point<Real>> way_of(const TopologyWork<Real>&,                          \
                                               const FrontPoint<Real>&);                           \
    template std::optional<Real> speed_of(const TopologyWork<Real>&, const FrontPoint<Real>&,      \
                                          const Point<Real>&);                                     \
    template Real lead_of(const TopologyWork<Real>&, std::uint32_t, const Point<Real>&, Real);     \
    template void put_ahead(TopologyWork<Real>&, std::uint32_t, Real, Real);                       \
    template bool is_blocked(const TopologyWork<Real>&, const FrontPoint<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
