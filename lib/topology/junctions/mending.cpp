// SPDX-License-Identifier: MIT
#include "topology/junctions/mending.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/quality/measures.h"
#include "topology/fronts/contraction.h"
#include "topology/junctions/merging.h"

#include <algorithm>
#include <array>

namespace dsc {

namespace {

constexpr double slender_star = 0.2; ///< height over longest edge
constexpr double poor_star = 0.02;   ///< squared quality that a removal may leave of a better one
constexpr int rounds_of_mending = 7;
/// In edge lengths: shorter sheets end in needles.
constexpr double short_sheet = 0.1;
/// The same on a seam at rest, to which remeshing does not come any more.
constexpr double short_seam = 0.2;
/// A short sheet goes even if the worst triangle becomes flatter by this factor: where a junction
/// has two short sheets, the first to go leaves the needle of the other.
constexpr double flatter = 0.7;
/// Height over longest edge of triangles that are mended between seams at rest.
constexpr double narrow = 0.1;

template <class Real>
class Mending {
public:
    explicit Mending(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(work.complex) {}

    bool run(Vertex v) {
        bool has_mended = false;
        for (int round = 0; round < rounds_of_mending && complex_.is_alive(v); ++round) {
            Corner worst = no_id;
            auto min_height = static_cast<Real>(slender_star);
            for_each_corner(complex_, v, [&](Corner c) {
                if (const Real one = height(c); one < min_height) {
                    min_height = one;
                    worst = c;
                }
            });
            if (worst == no_id || !mend(worst)) {
                break;
            }
            has_mended = true;
        }
        return has_mended;
    }

private:
    [[nodiscard]] Point<Real> at(Corner c) const {
        return complex_.position(Vertex{complex_.vertex(c)});
    }
    [[nodiscard]] Real height(Corner c) const {
        return height_over_longest<Real>(at(c), at(next(c)), at(prev(c)));
    }

    // The triangle at a corner of the star's vertex.
    bool mend(Corner c) {
        const std::array vertices{complex_.vertex(next(c)), complex_.vertex(prev(c)),
                                  complex_.vertex(c)};
        return flip_best(c) ||
               std::ranges::any_of(vertices, [&](std::uint32_t w) { return remove(w); }) ||
               std::ranges::any_of(vertices, [&](std::uint32_t w) { return smooth(w); });
    }

    bool flip_best(Corner worst) {
        Corner best = no_id;
        Real best_height = height(worst);
        for (const Corner c : {worst, next(worst), prev(worst)}) {
            const Corner o = complex_.twin(c);
            if (is_border(o) || is_sheet(complex_, c)) {
                continue;
            }
            const Real after = std::min(height_over_longest<Real>(at(c), at(next(c)), at(o)),
                                        height_over_longest<Real>(at(o), at(prev(c)), at(c)));
            if (after > best_height) {
                best_height = after;
                best = c;
            }
        }
        return best != no_id && edge_flip(submesh_, best) == Verdict::legal;
    }

    // Removes a vertex within a phase, also on the domain boundary.
    bool remove(std::uint32_t w) {
        auto now = static_cast<Real>(poor_star);
        for_each_corner(complex_, Vertex{w}, [&](Corner c) {
            now = std::min(
                now, std::max(quality_squared<Real>(at(c), at(next(c)), at(prev(c))), Real(0)));
        });
        return remove_inside(work_, Vertex{w}, now) || remove_on_boundary(work_, Vertex{w}, now);
    }

    // Moves a vertex inside a phase towards the mean of its link.
    bool smooth(std::uint32_t w) {
        if (complex_.is_locked(Vertex{w}) || !gather(complex_, Region{}, w, star_) ||
            !star_.one_phase || !star_.closed) {
            return false;
        }
        const Point<Real> from(star_.x0, star_.y0);
        Point<Real> mean = Point<Real>::Zero();
        for (std::uint32_t i = 0; i < star_.size; ++i) {
            mean += Point<Real>(star_.x[i], star_.y[i]) / static_cast<Real>(star_.size);
        }
        Real best = worst_quality_squared(star_, from.x(), from.y());
        Point<Real> to = from;
        for (const Real share : {Real(1), Real(0.5), Real(0.25)}) {
            const Point<Real> place = from + share * (mean - from);
            const Real after = worst_quality_squared(star_, place.x(), place.y());
            if (after > best && all_positive(star_, place.x(), place.y())) {
                best = after;
                to = place;
            }
        }
        if (to == from) {
            return false;
        }
        rewire::move(complex_, complex_.journal, w, to.x(), to.y(), MoveReason::smoothing);
        return true;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    Star<Real> star_;
};

// The ends of the sheets at a vertex, or the first two of them.
struct SheetEnds {
    std::array<std::uint32_t, 2> end{no_id, no_id};
    int number = 0;
    [[nodiscard]] std::uint32_t other(std::uint32_t v) const {
        return end[0] == v ? end[1] : end[0];
    }
};

template <class Real>
SheetEnds sheet_ends(const Complex<Real>& complex, std::uint32_t v) {
    SheetEnds ends;
    for_each_corner(complex, Vertex{v}, [&](Corner c) {
        if (is_sheet(complex, prev(c))) {
            if (ends.number < 2) {
                ends.end[static_cast<std::size_t>(ends.number)] = complex.vertex(next(c));
            }
            ++ends.number;
        }
    });
    return ends;
}

// A vertex on one curve that is free to move or vanish: it has arrived.
template <class Real>
bool is_plain(const Complex<Real>& complex, std::uint32_t v, const SheetEnds& ends) {
    return ends.number == 2 && !complex.is_locked(Vertex{v}) &&
           (complex.vertices[v].flags & (vertex_contact | vertex_on_way)) == 0 &&
           !is_on_boundary(complex, Vertex{v});
}

// Collapses the end of a short sheet into its start, the vertex at corner `c`. The next vertex of
// the curve moves across it by as much as keeps the areas of both phases.
template <class Real>
bool collapse_short_sheet(TopologyWork<Real>& work, Corner c) {
    Complex<Real>& complex = work.complex;
    const std::uint32_t kept = complex.vertex(c);
    const std::uint32_t gone = complex.vertex(next(c));
    const SheetEnds ends = sheet_ends(complex, gone);
    const bool ends_there = sheet_ends(complex, kept).number != 2;
    if (!is_plain(complex, gone, ends) || (complex.is_feature(Vertex{gone}) && !ends_there)) {
        return false;
    }
    const std::uint32_t moved = ends.other(kept);
    const SheetEnds beyond = sheet_ends(complex, moved);
    if (!is_plain(complex, moved, beyond) || complex.is_feature(Vertex{moved}) ||
        beyond.other(gone) == kept ||
        edge_collapse_guard(complex, Region{}, prev(c), rewire::Vanishing::prev) !=
            Verdict::legal) {
        return false;
    }
    const auto at = [&](std::uint32_t v) { return complex.position(Vertex{v}); };
    const Point<Real> chord = at(beyond.other(gone)) - at(kept);
    const Real doubled = cross<Real>(at(gone) - at(kept), at(moved) - at(kept));
    const Point<Real> to =
        at(moved) + doubled / chord.squaredNorm() * Point<Real>(chord.y(), -chord.x());
    Real before = 1;
    Real after = 1;
    bool is_positive = true;
    for (const std::uint32_t v : {gone, moved}) {
        for_each_corner(complex, Vertex{v}, [&](Corner k) {
            std::array<Point<Real>, 3> corners;
            bool vanishes = false;
            bool has_gone = false;
            const std::array ids{v, complex.vertex(next(k)), complex.vertex(prev(k))};
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = ids[i] == gone ? at(kept) : ids[i] == moved ? to : at(ids[i]);
                vanishes = vanishes || ids[i] == kept;
                has_gone = has_gone || ids[i] == gone;
            }
            before =
                std::min(before, height_over_longest<Real>(at(ids[0]), at(ids[1]), at(ids[2])));
            if (!(vanishes && has_gone)) {
                after =
                    std::min(after, height_over_longest<Real>(corners[0], corners[1], corners[2]));
                is_positive =
                    is_positive && orientation<Real>(corners[0], corners[1], corners[2]) > 0;
            }
        });
    }
    if (!(after >= static_cast<Real>(flatter) * before) || !is_positive) {
        return false;
    }
    rewire::collapse(complex, complex.journal, prev(c), rewire::Vanishing::prev, complex.ids);
    rewire::move(complex, complex.journal, moved, to.x(), to.y(), MoveReason::smoothing);
    return true;
}

template <class Real>
bool is_narrow(const Complex<Real>& complex, Corner c) {
    const auto at = [&](Corner k) { return complex.position(Vertex{complex.vertex(k)}); };
    return height_over_longest<Real>(at(c), at(next(c)), at(prev(c))) < static_cast<Real>(narrow);
}

// Whether the phase at a corner of a junction ends there in a single triangle, between two sheets
// at rest that its short third edge joins, and the triangle or the one beyond that edge is narrow.
template <class Real>
bool is_narrow_tip(const TopologyWork<Real>& work, Corner c) {
    const Complex<Real>& complex = work.complex;
    const Corner across = complex.twin(c);
    const Real shortest = static_cast<Real>(short_sheet) * work.edge_length;
    return is_sheet(complex, next(c)) && is_sheet(complex, prev(c)) && !is_border(across) &&
           !is_sheet(complex, c) &&
           !(is_sheet(complex, next(across)) && is_sheet(complex, prev(across))) &&
           direction(complex, c).squaredNorm() < shortest * shortest &&
           (is_narrow(complex, c) || is_narrow(complex, across)) &&
           std::ranges::all_of(std::array{next(c), prev(c)}, [&](Corner end) {
               const std::uint32_t v = complex.vertex(end);
               return rests(work, v) && !complex.is_feature(Vertex{v}) &&
                      is_plain(complex, v, sheet_ends(complex, v));
           });
}

// The junction is then where the short edge was.
template <class Real>
bool shorten_tip(TopologyWork<Real>& work, Corner c) {
    const Complex<Real>& complex = work.complex;
    const std::uint32_t one = complex.vertex(next(c));
    const std::uint32_t other = complex.vertex(prev(c));
    const double before = work.swept;
    const Point<Real> middle =
        midpoint<Real>(complex.position(Vertex{one}), complex.position(Vertex{other}));
    const bool is_shorter = contract(work, one, other, middle) != no_id;
    work.swept = before; // no event has this area
    return is_shorter;
}

} // namespace

template <class Real>
bool mend_star(TopologyWork<Real>& work, Vertex v) {
    return Mending<Real>(work).run(v);
}

template <class Real>
void collapse_short_sheets(TopologyWork<Real>& work, Vertex v) {
    const Complex<Real>& complex = work.complex;
    const auto is_at_rest = [&](Corner end) { return rests(work, complex.vertex(end)); };
    const auto is_short = [&](Corner sheet) {
        const bool is_seam = complex.phase_at(sheet) != exterior_phase &&
                             phase_beyond(complex, sheet) != exterior_phase &&
                             (is_at_rest(next(sheet)) || is_at_rest(prev(sheet)));
        const Real shortest =
            static_cast<Real>(is_seam ? short_seam : short_sheet) * work.edge_length;
        return direction(complex, sheet).squaredNorm() < shortest * shortest;
    };
    const auto collapses = [&](Corner c) {
        return is_sheet(complex, prev(c)) && is_short(prev(c)) && collapse_short_sheet(work, c);
    };
    while (complex.is_alive(v) && find_corner(complex, v, collapses) != no_id) {
    }
}

template <class Real>
bool has_narrow_seam(const TopologyWork<Real>& work, Vertex v) {
    const Complex<Real>& complex = work.complex;
    return complex.is_alive(v) && rests(work, v.id) && is_junction(complex, v) &&
           find_corner(complex, v,
                       [&](Corner c) { return complex.phase_at(c) == exterior_phase; }) == no_id &&
           find_corner(complex, v, [&](Corner c) {
               return is_narrow(complex, c) || is_narrow_tip(work, c);
           }) != no_id;
}

template <class Real>
void mend_seams(TopologyWork<Real>& work, Vertex v) {
    if (!has_narrow_seam(work, v)) {
        return;
    }
    const Complex<Real>& complex = work.complex;
    const Corner tip = find_corner(complex, v, [&](Corner c) { return is_narrow_tip(work, c); });
    if (!(tip != no_id && shorten_tip(work, tip)) &&
        find_corner(complex, v, [&](Corner c) { return is_narrow(complex, c); }) != no_id) {
        (void)mend_star(work, v);
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template bool mend_star(TopologyWork<Real>&, Vertex);                                          \
    template bool has_narrow_seam(const TopologyWork<Real>&, Vertex);                              \
    template void mend_seams(TopologyWork<Real>&, Vertex);                                         \
    template void collapse_short_sheets(TopologyWork<Real>&, Vertex);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
