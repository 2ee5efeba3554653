// SPDX-License-Identifier: MIT
#include "thesis/operations/smoothing.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

namespace dsc {

namespace {

// The tests common to every smoothing; `summary` is filled in if the vertex is in the submesh.
template <class Real>
Verdict check_star(const Complex<Real>& complex, const Region& region, Vertex vertex,
                   StarSummary& summary) {
    if (!complex.is_alive(vertex)) {
        return Verdict::not_a_simplex;
    }
    if (!owns(complex, region, vertex.id)) {
        return Verdict::on_submesh_boundary;
    }
    summary = inspect(complex, region, vertex.id);
    if (summary.on_boundary) {
        return Verdict::on_boundary;
    }
    return summary.owned ? Verdict::legal : Verdict::on_submesh_boundary;
}

// Moves the vertex to `target` if no star triangle inverts and the quality of the star rises.
template <class Real>
Verdict move_if_better(const Submesh<Real>& submesh, Vertex vertex, const Point<Real>& target) {
    Complex<Real>& complex = submesh.complex;
    // A vertex must not leave its submesh while others run. If its neighbours are owned and regions
    // are convex, it cannot, except by rounding.
    if (!submesh.region.owns(vertex.id, static_cast<double>(target.x()),
                             static_cast<double>(target.y()))) {
        return Verdict::on_submesh_boundary;
    }
    const Point<Real> here = complex.position(vertex);
    bool positive = true;
    Real before = std::numeric_limits<Real>::infinity();
    Real after = std::numeric_limits<Real>::infinity();
    turn(complex, vertex.id, [&](Corner c) {
        const auto p = complex.position(Vertex{complex.vertex(next(c))});
        const auto q = complex.position(Vertex{complex.vertex(prev(c))});
        positive = positive && orientation<Real>(target, p, q) > 0;
        before = std::min(before, sine_squared<Real>(here, p, q));
        after = std::min(after, sine_squared<Real>(target, p, q));
    });
    if (!positive) {
        return Verdict::inverts;
    }
    if (!(after > before)) {
        return Verdict::no_gain;
    }
    rewire::move(complex, *submesh.log, vertex.id, target.x(), target.y(), MoveReason::smoothing);
    rethrow_failure(submesh);
    return Verdict::legal;
}

// The interface beyond `at`, coming from `from`: no_id where it ends, branches, turns sharply or
// leaves the submesh (there, others may be moving it at this moment).
template <class Real>
std::uint32_t beyond(const Complex<Real>& complex, const Region& region, std::uint32_t from,
                     std::uint32_t at, double cosine) {
    std::uint32_t count = 0;
    std::uint32_t other = no_id;
    const StarSummary summary = for_each_interface_edge(complex, at, [&](std::uint32_t w) {
        ++count;
        other = w != from ? w : other;
    });
    if (count != 2 || summary.on_boundary || !owns(complex, region, other)) {
        return no_id;
    }
    const auto position = [&](std::uint32_t v) { return complex.position(Vertex{v}); };
    return turns_more<Real>(position(from), position(at), position(other), cosine) ? no_id : other;
}

// The second point has the knot 0 and is near every point that is evaluated.
template <class Real>
Point<Real> on_curve(std::span<const Point<Real>> points, std::span<const Real> knots, Real at) {
    return lagrange<Real>(points, knots, at, points[1]);
}

// Distances to the two ends that differ by less than this share of their sum count as equal: the
// exact position of the vertex on the curve does not matter.
template <class Real>
inline constexpr Real equal_lengths = Real(1e-4);

// Bisection halves the bracket each time, so this is enough for any curve.
inline constexpr int max_bisections = 24;

// The knot in (0, knots[2]) whose point is equally far from points[0] and points[2].
template <class Real>
Real equalising_knot(std::span<const Point<Real>> points, std::span<const Real> knots) {
    Real low = 0;
    Real high = knots[2];
    Real at = Real(0.5) * (knots[0] + knots[2]); // exact on a straight line
    for (int i = 0; i < max_bisections; ++i) {
        const Point<Real> p = on_curve(points, knots, at);
        const Real to_near = (p - points[0]).norm();
        const Real to_far = (p - points[2]).norm();
        if (std::abs(to_near - to_far) <= equal_lengths<Real> * (to_near + to_far)) {
            break;
        }
        (to_near < to_far ? low : high) = at;
        // Along the curve one length grows as the other shrinks: half the difference is the step of
        // Newton's method, apart from the effect of the bend.
        const Real newton = at + Real(0.5) * (to_far - to_near);
        at = newton > low && newton < high ? newton : Real(0.5) * (low + high);
    }
    return at;
}

} // namespace

template <class Real>
Verdict detail::laplacian_smoothing(const Submesh<Real>& submesh, Vertex vertex) {
    const Complex<Real>& complex = submesh.complex;
    StarSummary summary;
    const Verdict verdict = check_star(complex, submesh.region, vertex, summary);
    if (verdict != Verdict::legal) {
        return verdict;
    }
    if (summary.interface_edges > 0) {
        return Verdict::on_interface;
    }
    if (complex.is_locked(vertex)) {
        return Verdict::locked;
    }
    // Relative to the vertex, so that an offset of the coordinates does not cost precision.
    const Point<Real> here = complex.position(vertex);
    Point<Real> sum = Point<Real>::Zero();
    std::uint32_t count = 0;
    turn(complex, vertex.id, [&](Corner c) {
        sum += complex.position(Vertex{complex.vertex(next(c))}) - here;
        ++count;
    });
    if (count == 0) {
        return Verdict::no_gain;
    }
    return move_if_better<Real>(submesh, vertex, here + sum / static_cast<Real>(count));
}

template <class Real>
Verdict detail::interface_smoothing(const Submesh<Real>& submesh, Vertex vertex,
                                    const InterfaceSmoothingOptions& options) {
    const Complex<Real>& complex = submesh.complex;
    if (!(options.feature_degrees >= 0 && options.feature_degrees <= 180)) {
        throw InputError({.what = "feature_degrees out of range",
                          .where = "interface_smoothing",
                          .value = to_text(options.feature_degrees),
                          .allowed = "0 to 180 degrees"});
    }
    if (!(options.step >= 0 && options.step <= 1)) {
        throw InputError({.what = "step out of range",
                          .where = "interface_smoothing",
                          .value = to_text(options.step),
                          .allowed = "0 to 1"});
    }
    StarSummary summary;
    const Verdict verdict = check_star(complex, submesh.region, vertex, summary);
    if (verdict != Verdict::legal) {
        return verdict;
    }
    if (summary.interface_edges != 2) {
        return Verdict::on_interface;
    }
    std::array<std::uint32_t, 2> ends{};
    std::uint32_t count = 0;
    for_each_interface_edge(complex, vertex.id, [&](std::uint32_t w) { ends[count++] = w; });
    const double cosine = std::cos(options.feature_degrees * std::numbers::pi / 180);
    const Point<Real> here = complex.position(vertex);
    const auto position = [&](std::uint32_t v) { return complex.position(Vertex{v}); };
    if (turns_more<Real>(position(ends[0]), here, position(ends[1]), cosine)) {
        return Verdict::on_interface;
    }
    if (complex.is_locked(vertex)) {
        return Verdict::locked;
    }
    Real near = (position(ends[0]) - here).norm();
    Real far = (position(ends[1]) - here).norm();
    if (near > far) {
        std::swap(near, far);
        std::swap(ends[0], ends[1]);
    }
    if (far - near <= equal_lengths<Real> * (near + far)) {
        return Verdict::no_gain;
    }
    // The vertex moves towards the farther neighbour, so the curve is interpolated between the two.
    std::array<Point<Real>, 4> points{position(ends[0]), here, position(ends[1]), here};
    std::array<Real, 4> knots{-near, 0, far, 0};
    std::size_t size = 3;
    const std::uint32_t last = beyond(complex, submesh.region, vertex.id, ends[1], cosine);
    if (last != no_id && last != ends[0]) {
        points[3] = position(last);
        knots[3] = far + (points[3] - points[2]).norm();
        size = 4;
    }
    const std::span<const Point<Real>> curve(points.data(), size);
    const std::span<const Real> at(knots.data(), size);
    const Real knot = equalising_knot(curve, at) * static_cast<Real>(options.step);
    return move_if_better<Real>(submesh, vertex, on_curve(curve, at, knot));
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Verdict detail::laplacian_smoothing(const Submesh<Real>&, Vertex);                    \
    template Verdict detail::interface_smoothing(const Submesh<Real>&, Vertex,                     \
                                                 const InterfaceSmoothingOptions&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
