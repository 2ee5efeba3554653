// SPDX-License-Identifier: MIT
#include "topology/fronts/front_curve.h"

#include "dsc/motion/interpolation.h"
#include "topology/fronts/front_point.h"

#include <cmath>
#include <optional>

namespace dsc {

namespace {

/// Cosine of the largest turn (45 degrees) within one bend of a front.
constexpr double bend_cosine = 0.7;
/// The leads of vertices are taken along the normal, which depends on them: after so many rounds
/// the normal hardly changes any more.
constexpr int rounds_of_normal = 3;

// Whether a front goes smoothly through a vertex: where it turns by more, it has a corner.
template <class Real>
bool is_one_bend(const Complex<Real>& complex, std::uint32_t v, const Point<Real>& from,
                 const Point<Real>& at, const Point<Real>& to) {
    return !complex.is_feature(Vertex{v}) && turns_less<Real>(from, at, to, Real(bend_cosine));
}

// `place(v)`: where a vertex counts as being.
template <class Real, class Place>
CurvePoint<Real> point_of_parabola(const Complex<Real>& complex, std::uint32_t v,
                                   const Sector<Real>& sector, const Place& place) {
    const Point<Real> from = place(complex.vertex(next(sector.first)));
    const Point<Real> to = place(complex.vertex(prev(last_of(complex, sector))));
    const Point<Real> middle = place(v);
    if (!is_one_bend<Real>(complex, v, from, middle, to)) {
        return {middle, middle_of(sector)};
    }
    const Point<Real> back = from - middle;
    const Point<Real> ahead = to - middle;
    const Point<Real> tangent = back / back.squaredNorm() - ahead / ahead.squaredNorm();
    return {middle, Point<Real>(-tangent.y(), tangent.x()).normalized()};
}

// `place(v)`: where a vertex counts as being.
template <class Real, class Place>
CurvePoint<Real> point_of_cubic(const Complex<Real>& complex, Corner edge, Real share,
                                const Place& place) {
    const std::uint32_t a = complex.vertex(next(edge));
    const std::uint32_t b = complex.vertex(prev(edge));
    CurveNeighbours<Real> curve{.p1 = place(a), .p2 = place(b)};
    const Corner after = along_outline(complex, edge);
    const Corner before = along_outline(complex, complex.twin(edge));
    if (phase_beyond(complex, before) == complex.phase_at(edge)) {
        curve.p0 = place(complex.vertex(prev(before)));
        curve.has_first = is_one_bend(complex, a, curve.p0, curve.p1, curve.p2);
    }
    if (phase_beyond(complex, after) == phase_beyond(complex, edge)) {
        curve.p3 = place(complex.vertex(prev(after)));
        curve.has_last = is_one_bend(complex, b, curve.p1, curve.p2, curve.p3);
    }
    constexpr Real beside = Real(0.05); // of the edge
    const Point<Real> along =
        curve_point(curve, share + beside) - curve_point(curve, share - beside);
    return {curve_point(curve, share), Point<Real>(-along.y(), along.x()).normalized()};
}

// The point `point_of(place)` where the front is at the time of the simulation. `speed_along`: of
// the front along a normal; if nobody knows it, the front is where its vertices are.
template <class Real, class SpeedAlong, class PointOf>
CurvePoint<Real> point_now(const TopologyWork<Real>& work, const SpeedAlong& speed_along,
                           const PointOf& point_of) {
    const auto at = [&](std::uint32_t v) -> Point<Real> {
        return work.complex.position(Vertex{v});
    };
    CurvePoint<Real> point = point_of(at);
    bool is_tilted = true;
    for (int round = 0; round < rounds_of_normal && is_tilted; ++round) {
        const Point<Real> normal = point.normal;
        const std::optional<Real> speed = speed_along(normal);
        if (!speed) {
            break;
        }
        is_tilted = false;
        point = point_of([&](std::uint32_t v) -> Point<Real> {
            const Real lead = lead_of(work, v, normal, *speed);
            is_tilted = is_tilted || lead != 0;
            return at(v) - lead * normal;
        });
    }
    return point;
}

} // namespace

template <class Real>
Corner last_of(const Complex<Real>& complex, const Sector<Real>& sector) {
    Corner last = sector.first;
    for (std::size_t i = 1; i < sector.count; ++i) {
        last = corner_ccw(complex, last);
    }
    return last;
}

template <class Real>
Point<Real> middle_of(const Sector<Real>& sector) {
    const auto half = static_cast<Real>(sector.angle / 2);
    const Point<Real>& ray = sector.ray;
    return {ray.x() * std::cos(half) - ray.y() * std::sin(half),
            ray.x() * std::sin(half) + ray.y() * std::cos(half)};
}

template <class Real>
Point<Real> normal_now(const TopologyWork<Real>& work, std::uint32_t v,
                       const Sector<Real>& sector) {
    const auto speed = [&](const Point<Real>& normal) {
        return speed_of(work, front_point<Real>(v), normal);
    };
    return point_now(
               work, speed,
               [&](const auto& place) { return point_of_parabola(work.complex, v, sector, place); })
        .normal;
}

template <class Real>
CurvePoint<Real> curve_now(const TopologyWork<Real>& work, Corner edge, Real share,
                           Real other_speed) {
    const FrontPoint<Real> middle = front_point(work.complex, edge, share);
    const auto speed = [&](const Point<Real>& normal) -> std::optional<Real> {
        return speed_of(work, middle, normal).value_or(other_speed);
    };
    return point_now(work, speed, [&](const auto& place) {
        return point_of_cubic(work.complex, edge, share, place);
    });
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Corner last_of(const Complex<Real>&, const Sector<Real>&);                            \
    template Point<Real> middle_of(const Sector<Real>&);                                           \
    template Point<Real> normal_now(const TopologyWork<Real>&, std::uint32_t,                      \
                                    const Sector<Real>&);                                          \
    template CurvePoint<Real> curve_now(const TopologyWork<Real>&, Corner, Real, Real);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
