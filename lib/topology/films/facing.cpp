// SPDX-License-Identifier: MIT
#include "topology/films/facing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc {

namespace {

/// Cosine of the angle between the directions of two edges that face each other.
constexpr double facing = -0.3;
/// Two sheets approach each other if they come closer by this share of the way that they move.
/// In films that are only advected, rounding and the curvature of the flow bring them closer by
/// less than that.
constexpr double min_approach = 0.01;

template <class Real>
Real quadrilateral(const std::array<Point<Real>, 4>& p) {
    const Point<Real> a = p[2] - p[0];
    const Point<Real> b = p[3] - p[1];
    return (a.x() * b.y() - a.y() * b.x()) / 2;
}

// Between two sheets that go from the first point to the second, and from the third to the fourth;
// `then`: before the sub-step, in which the area between the two sheets decreases by `losing` in
// total; `closing` is the part due to their approach, apart from changes of their own length. In a
// flow that keeps areas `losing` is 0.
template <class Real>
bool loses_area(const std::array<Point<Real>, 4>& then, const std::array<Point<Real>, 4>& now) {
    Real farthest_squared = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        farthest_squared = std::max(farthest_squared, (now[i] - then[i]).squaredNorm());
    }
    const Real area_now = quadrilateral(now);
    const Real area_then = quadrilateral(then);
    const Real losing = area_then - area_now;
    // The later condition is 2 losing > closing > min_approach * farthest * length, where the mean
    // length is at least half of the longer one. This quick test already rejects nearly all films
    // of a filament in a flow that keeps areas. Areas are not squared, because float cannot
    // represent the squares of areas of a fine mesh in a small unit.
    const Real farthest = std::sqrt(farthest_squared);
    const Real longer =
        std::sqrt(std::max((now[1] - now[0]).squaredNorm(), (now[3] - now[2]).squaredNorm()));
    constexpr Real least = static_cast<Real>(min_approach / 4 * 0.99); // 0.99: more than rounding
    if (!(losing > least * farthest * longer)) {
        return false;
    }
    const Real length_now = ((now[1] - now[0]).norm() + (now[3] - now[2]).norm()) / 2;
    const Real length_then = ((then[1] - then[0]).norm() + (then[3] - then[2]).norm()) / 2;
    const Real closing = area_then - area_now * length_then / length_now;
    return closing > static_cast<Real>(min_approach) * farthest * length_now &&
           2 * losing > closing;
}

} // namespace

template <class Real>
bool faces(const Complex<Real>& complex, Corner one, Corner other) {
    const Point<Real> a = direction(complex, one);
    const Point<Real> b = direction(complex, other);
    return a.dot(b) < static_cast<Real>(facing) * a.norm() * b.norm();
}

template <class Real>
bool are_ends_of_seam(const TopologyWork<Real>& work, Corner one, Corner other) {
    for (const Corner sheet : {one, other}) {
        for (const Corner end : {next(sheet), prev(sheet)}) {
            const std::uint32_t v = work.complex.vertex(end);
            if (!is_on_seam(work, v) || (work.complex.vertices[v].flags & vertex_contact) != 0) {
                return false;
            }
        }
    }
    return true;
}

template <class Real>
bool is_squeezed(const TopologyWork<Real>& work, Corner one, Corner other) {
    const Complex<Real>& complex = work.complex;
    const bool is_mirrored = is_border(complex.twin(other));
    std::array<Point<Real>, 4> now;
    std::array<Point<Real>, 4> then;
    for (std::size_t i = 0; i < (is_mirrored ? 2 : 4); ++i) {
        const Corner sheet = i < 2 ? one : other;
        const std::uint32_t v = complex.vertex(i % 2 == 0 ? next(sheet) : prev(sheet));
        const auto& record = complex.vertices[v];
        if ((record.flags & vertex_contact) != 0) {
            return true; // the film blocks the interface
        }
        if (work.notes[Vertex{v}].round != work.round) {
            return false; // new: tested again after the next sub-step
        }
        now[i] = {record.x, record.y};
        then[i] = place_before(work, v);
    }
    if (is_mirrored) {
        const Point<Real> foot = complex.position(Vertex{complex.vertex(next(other))});
        const Point<Real> along = direction(complex, other).normalized();
        for (std::size_t i = 0; i < 2; ++i) {
            for (auto* const points : {&now, &then}) {
                const Point<Real> from = (*points)[i] - foot;
                (*points)[i] = {-along.dot(from), -cross<Real>(along, from)};
                (*points)[3 - i] = {(*points)[i].x(), 0};
            }
        }
    }
    return loses_area(then, now);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template bool faces(const Complex<Real>&, Corner, Corner);                                     \
    template bool are_ends_of_seam(const TopologyWork<Real>&, Corner, Corner);                     \
    template bool is_squeezed(const TopologyWork<Real>&, Corner, Corner);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
