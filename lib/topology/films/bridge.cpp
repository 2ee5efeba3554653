// SPDX-License-Identifier: MIT
#include "topology/films/bridge.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

/// Two edges fewer than this many edges apart along the outline are the end of a filament rather
/// than its two sides.
constexpr int end_of_filament = 6;
/// Cosine of the angle between the directions of two edges that face each other.
constexpr double facing = -0.3;
/// Two sheets approach each other if they come closer by this share of the way that they move.
/// In films that are only advected, rounding and the curvature of the flow bring them closer by
/// less than that.
constexpr double min_approach = 0.01;

template <class Real>
bool is_apart(const Complex<Real>& complex, Corner one, Corner other) {
    Corner from_one = one;
    Corner from_other = other;
    for (int i = 0; i < end_of_filament; ++i) {
        from_one = along_outline(complex, from_one);
        from_other = along_outline(complex, from_other);
        if (from_one == other || from_other == one) {
            return false;
        }
    }
    return true;
}

template <class Real>
Real quadrilateral(const std::array<Point<Real>, 4>& p) {
    const Point<Real> a = p[2] - p[0];
    const Point<Real> b = p[3] - p[1];
    return (a.x() * b.y() - a.y() * b.x()) / 2;
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
bool is_squeezed(const TopologyWork<Real>& work, std::span<const Candidate> candidates,
                 const std::array<Corner, 2>& sheets) {
    const Complex<Real>& complex = work.complex;
    std::array<Point<Real>, 4> now;
    std::array<Point<Real>, 4> then;
    for (std::size_t i = 0; i < 4; ++i) {
        const Corner sheet = sheets[i / 2];
        const std::uint32_t v = complex.vertex(i % 2 == 0 ? next(sheet) : prev(sheet));
        const auto& record = complex.vertices[v];
        if ((record.flags & vertex_contact) != 0) {
            return true; // the film blocks the interface
        }
        if (record.slot >= candidates.size() || candidates[record.slot].vertex != v) {
            return false; // new, or not thin before: tested again after the next sub-step
        }
        now[i] = {record.x, record.y};
        then[i] = place_before(work, v);
    }
    return is_squeezed(then, now);
}

// In a sub-step the area between the two sheets decreases by `losing` in total; `closing` is the
// part due to their approach, apart from changes of their own length. In a flow that keeps areas
// `losing` is 0.
template <class Real>
bool is_squeezed(const std::array<Point<Real>, 4>& then, const std::array<Point<Real>, 4>& now) {
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

template <class Real>
Real contact_at(const TopologyWork<Real>& work, Corner sheet) {
    const Complex<Real>& complex = work.complex;
    const auto rule = rule_of(work.options, work.edge_length, complex.phase_at(sheet),
                              complex.phase_at(complex.twin(sheet)));
    if (rule.rule != Topology::change) {
        return 0;
    }
    return is_wide(rule.contact, work.edge_length)
               ? static_cast<Real>(default_contact) * work.edge_length
               : rule.contact;
}

template <class Real>
bool is_thin(const TopologyWork<Real>& work, Triangle t) {
    Real contact = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = corner_of(t.id, i);
        if (is_border(work.complex.twin(c))) {
            return false;
        }
        if (is_sheet(work.complex, c)) {
            contact = std::max(contact, contact_at(work, c));
        }
    }
    return contact > 0 && thickness(work.complex, t) < contact;
}

template <class Real>
int sheets_of(const Complex<Real>& complex, Triangle t, std::array<Corner, 3>& sheets) {
    int count = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = corner_of(t.id, i);
        if (is_sheet(complex, c)) {
            sheets[static_cast<std::size_t>(count++)] = c;
        }
    }
    return count;
}

template <class Real>
bool find_bridge(const TopologyWork<Real>& work, std::span<const Candidate> candidates, Triangle t,
                 Bridge<Real>& best) {
    const Complex<Real>& complex = work.complex;
    std::array<Corner, 3> sheets{};
    if (sheets_of(complex, t, sheets) != 1) {
        return false;
    }
    const Corner sheet = sheets[0];
    bool found = false;
    for (const Corner side : {next(sheet), prev(sheet)}) {
        // The triangle across this side shares the apex of t, and its third vertex is the next one
        // along the second sheet.
        const Corner across = complex.twin(side);
        const Triangle u{triangle_of(across)};
        if (is_outline(complex, side)) {
            continue;
        }
        const Corner opposite = side == next(sheet) ? prev(across) : next(across);
        std::array<Corner, 3> others{};
        if (sheets_of(complex, u, others) != 1 || others[0] != opposite ||
            (meet_in_points(complex.phase(t)) &&
             phase_beyond(complex, sheet) != phase_beyond(complex, opposite))) {
            continue;
        }
        // First the test that rejects most triangles: no film is squeezed in a flow that keeps
        // areas.
        if (work.options.opening == Opening::squeezed &&
            !is_squeezed(work, candidates, {sheet, opposite})) {
            continue;
        }
        if (!is_thin(work, u) || !faces(complex, sheet, opposite) ||
            are_ends_of_seam(work, sheet, opposite)) {
            continue;
        }
        const Real thick = std::max(thickness(complex, t), thickness(complex, u));
        if ((!found || thick < best.thickness) && is_apart(complex, sheet, opposite)) {
            best = {{sheet, opposite}, thick};
            found = true;
        }
    }
    return found;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Real contact_at(const TopologyWork<Real>&, Corner);                                   \
    template bool faces(const Complex<Real>&, Corner, Corner);                                     \
    template bool are_ends_of_seam(const TopologyWork<Real>&, Corner, Corner);                     \
    template bool is_squeezed(const TopologyWork<Real>&, std::span<const Candidate>,               \
                              const std::array<Corner, 2>&);                                       \
    template bool is_squeezed(const std::array<Point<Real>, 4>&,                                   \
                              const std::array<Point<Real>, 4>&);                                  \
    template bool is_thin(const TopologyWork<Real>&, Triangle);                                    \
    template int sheets_of(const Complex<Real>&, Triangle, std::array<Corner, 3>&);                \
    template bool find_bridge(const TopologyWork<Real>&, std::span<const Candidate>, Triangle,     \
                              Bridge<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
