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
class OnFront {
public:
    explicit OnFront(const TopologyWork<Real>& work) : work_(work) {}

    [[nodiscard]] std::optional<Point<Real>> way_at(const FrontPoint<Real>& point) const {
        return mean_of(point, Point<Real>(Point<Real>::Zero()),
                       [this](std::uint32_t v) { return way_of(v); });
    }
    [[nodiscard]] std::optional<Real> speed_at(const FrontPoint<Real>& point,
                                               const Point<Real>& normal) const {
        return mean_of(point, Real(0), [&](std::uint32_t v) { return speed_of(v, normal); });
    }
    [[nodiscard]] Real lead_at(const FrontPoint<Real>& point, const Point<Real>& normal,
                               Real speed) const {
        Real sum = 0;
        for (const auto& end : point.ends) {
            sum += end.v != no_id ? end.weight * lead_of(end.v, normal, speed) : Real(0);
        }
        return sum;
    }
    [[nodiscard]] bool is_blocked_at(const FrontPoint<Real>& point) const {
        return std::ranges::any_of(
            point.ends, [this](const auto& end) { return end.v != no_id && is_blocked(end.v); });
    }

private:
    // The mean of what the ends know.
    template <class Value, class Ask>
    [[nodiscard]] static std::optional<Value> mean_of(const FrontPoint<Real>& point, Value sum,
                                                      const Ask& ask) {
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
    // The target of a vertex that did not arrive; null if it has none any more.
    [[nodiscard]] const Missed<Real>* target_of(std::uint32_t v) const {
        const auto found = std::ranges::lower_bound(work_.missed, v, {}, &Missed<Real>::vertex);
        if (found == work_.missed.end() || found->vertex != v || !is_noted(v)) {
            return nullptr;
        }
        const NotedPlace<Real>& before = work_.places[Vertex{v}];
        return before.x == found->before.x && before.y == found->before.y ? &*found : nullptr;
    }
    [[nodiscard]] std::optional<Point<Real>> way_of(std::uint32_t v) const {
        const Real share = work_.ahead[Vertex{v}].share;
        if (!is_noted(v) || share < static_cast<Real>(min_moved)) {
            return std::nullopt;
        }
        const Missed<Real>* const missed = target_of(v);
        const Point<Real> end = missed != nullptr ? missed->target : at(v);
        return (end - place_before(work_, v)) / share;
    }
    [[nodiscard]] std::optional<Real> speed_of(std::uint32_t v, const Point<Real>& normal) const {
        if (!is_junction(v) && (!is_blocked(v) || target_of(v) != nullptr)) {
            if (const auto way = way_of(v)) {
                return way->dot(normal);
            }
        }
        const Real speed = work_.ahead[Vertex{v}].speed;
        return speed > 0 ? std::optional<Real>(speed * work_.dt) : std::nullopt;
    }
    [[nodiscard]] Real lead_of(std::uint32_t v, const Point<Real>& normal, Real speed) const {
        if (const Missed<Real>* const missed = target_of(v)) {
            return (at(v) - missed->target).dot(normal);
        }
        const TimeAhead<Real>& ahead = work_.ahead[Vertex{v}];
        const Real lead = ahead.time / work_.dt * speed;
        // The end of a seam may be slower than the place where the fronts would meet.
        return is_junction(v) && is_noted(v)
                   ? lead + (at(v) - place_before(work_, v)).dot(normal) - ahead.share * speed
                   : lead;
    }
    [[nodiscard]] bool is_blocked(std::uint32_t v) const {
        return (work_.complex.vertices[v].flags & vertex_contact) != 0;
    }

    [[nodiscard]] Point<Real> at(std::uint32_t v) const {
        return work_.complex.position(Vertex{v});
    }
    [[nodiscard]] bool is_noted(std::uint32_t v) const {
        return work_.notes[Vertex{v}].round == work_.round;
    }
    [[nodiscard]] bool is_junction(std::uint32_t v) const {
        return !is_noted(v) || (work_.notes[Vertex{v}].what & noted_junction) != 0;
    }

    const TopologyWork<Real>& work_;
};

} // namespace

template <class Real>
std::optional<Point<Real>> way_of(const TopologyWork<Real>& work, const FrontPoint<Real>& point) {
    return OnFront<Real>(work).way_at(point);
}

template <class Real>
std::optional<Real> speed_of(const TopologyWork<Real>& work, const FrontPoint<Real>& point,
                             const Point<Real>& normal) {
    return OnFront<Real>(work).speed_at(point, normal);
}

template <class Real>
Real lead_of(const TopologyWork<Real>& work, const FrontPoint<Real>& point,
             const Point<Real>& normal, Real speed) {
    return OnFront<Real>(work).lead_at(point, normal, speed);
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
    return OnFront<Real>(work).is_blocked_at(point);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::optional<Point<Real>> way_of(const TopologyWork<Real>&,                          \
                                               const FrontPoint<Real>&);                           \
    template std::optional<Real> speed_of(const TopologyWork<Real>&, const FrontPoint<Real>&,      \
                                          const Point<Real>&);                                     \
    template Real lead_of(const TopologyWork<Real>&, const FrontPoint<Real>&, const Point<Real>&,  \
                          Real);                                                                   \
    template void put_ahead(TopologyWork<Real>&, std::uint32_t, Real, Real);                       \
    template bool is_blocked(const TopologyWork<Real>&, const FrontPoint<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
