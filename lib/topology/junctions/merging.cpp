// SPDX-License-Identifier: MIT
#include "topology/junctions/merging.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/quality/measures.h"

#include <cmath>

namespace dsc {

namespace {

/// Squared quality below which a triangle counts as flat.
constexpr double poor_squared = 0.0025;
/// Longest edge that a removal leaves on the boundary, in edge lengths. Until remeshing comes to a
/// longer one, flat triangles on it are split at their other edges, again and again.
constexpr double longest_on_boundary = 2;
/// The largest number of vertices removed to make room.
constexpr int max_removed = 6;

// The squared quality of a triangle after the vertex at this corner is replaced by another; 1 if
// that is a vertex of the triangle already.
template <class Real>
Real quality_with(const Complex<Real>& complex, Corner c, Vertex other) {
    const std::uint32_t a = complex.vertex(next(c));
    const std::uint32_t b = complex.vertex(prev(c));
    if (a == other.id || b == other.id) {
        return 1;
    }
    const auto at = [&](std::uint32_t id) { return complex.position(Vertex{id}); };
    const Real its = quality<Real>(at(other.id), at(a), at(b));
    return its > 0 ? its * its : its;
}

template <class Real>
class Merging {
public:
    Merging(TopologyWork<Real>& work, Vertex v, Vertex w)
        : work_(work), complex_(work.complex), submesh_(work.complex), v_(v), w_(w) {}

    Vertex run(bool either) {
        for (int removed = 0; removed <= max_removed; ++removed) {
            const Real into_w = quality_after(v_, w_);
            const Real into_v = either ? quality_after(w_, v_) : Real(-1);
            const bool is_last = removed == max_removed;
            const Real best = std::max(into_w, into_v);
            if (best >= static_cast<Real>(poor_squared) || is_last || !make_room(either, best)) {
                if (!(best > 0)) {
                    return {};
                }
                const Vertex gone = into_w >= into_v ? v_ : w_;
                const Vertex kept = gone == v_ ? w_ : v_;
                note_sweep(work_, gone, kept, complex_.position(kept));
                const Corner edge = edge_between();
                rewire::collapse(complex_, *submesh_.log, edge, end_of(edge, gone), *submesh_.pool);
                return kept;
            }
        }
        return {};
    }

private:
    // The two vertices opposite to the edge, one for each of its half-edges.
    Corner edge_between() const {
        const Corner c = find_corner(complex_, v_, [&](Corner at) {
            return complex_.vertex(next(at)) == w_.id || complex_.vertex(prev(at)) == w_.id;
        });
        return complex_.vertex(next(c)) == w_.id ? prev(c) : next(c);
    }
    rewire::Vanishing end_of(Corner edge, Vertex v) const {
        return complex_.vertex(next(edge)) == v.id ? rewire::Vanishing::next
                                                   : rewire::Vanishing::prev;
    }

    // The worst squared quality of the triangles of `gone` after its collapse into `kept`; 0 or
    // less if the collapse is not legal.
    Real quality_after(Vertex gone, Vertex kept) const {
        const Corner edge = edge_between();
        if (edge_collapse_guard(complex_, submesh_.region, edge, end_of(edge, gone),
                                JunctionRule::may_merge, BoundaryRule::smooth) != Verdict::legal) {
            return 0;
        }
        Real worst = 1;
        for_each_corner(complex_, gone, [&](Corner c) {
            worst = std::min(worst, quality_with(complex_, c, kept));
        });
        return worst;
    }

    // Removes a vertex inside a phase from the link: an end of the edge opposite to the worst
    // triangle, or a neighbour of both ends. Accepts poor triangles if the edge cannot be collapsed
    // otherwise.
    bool make_room(bool either, Real quality_so_far) {
        const Real min_quality = quality_so_far > 0 ? static_cast<Real>(poor_squared) : Real(0);
        for (const bool is_first : {true, false}) {
            if (!is_first && !either) {
                continue;
            }
            const Vertex gone = is_first ? v_ : w_;
            const Vertex kept = is_first ? w_ : v_;
            Real worst = static_cast<Real>(poor_squared);
            Corner at_worst = no_id;
            for_each_corner(complex_, gone, [&](Corner c) {
                if (const Real its = quality_with(complex_, c, kept); its < worst) {
                    worst = its;
                    at_worst = c;
                }
            });
            if (at_worst != no_id) {
                const std::array ends{complex_.vertex(next(at_worst)),
                                      complex_.vertex(prev(at_worst))};
                if (remove_inside(work_, Vertex{ends[0]}, min_quality) ||
                    remove_inside(work_, Vertex{ends[1]}, min_quality)) {
                    return true;
                }
            }
        }
        return false;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    Vertex v_;
    Vertex w_;
};

} // namespace

template <class Real>
void note_sweep(TopologyWork<Real>& work, Vertex gone, Vertex kept, const Point<Real>& to) {
    const Complex<Real>& complex = work.complex;
    const Point<Real> from = complex.position(gone);
    const Point<Real> way = to - from;
    for_each_corner(complex, gone, [&](Corner c) {
        const Corner edge = prev(c); // leaves the vertex, with the triangle on its left
        const Vertex end{complex.vertex(next(c))};
        if (end == kept || !is_sheet(complex, edge)) {
            return;
        }
        const Point<Real> along = complex.position(end) - from;
        const auto area = static_cast<double>(cross<Real>(along, way)) / 2;
        work.swept += std::abs(area);
        if (work.options.gives_back_area && area != 0) {
            const Phase left = complex.phase_at(c);
            const Phase right = complex.phase_at(complex.twin(edge));
            const Point<Real> place = from + (way + along) / Real(3);
            work.transfers.push_back({area > 0 ? left : right, area > 0 ? right : left,
                                      std::abs(area), place.template cast<double>(),
                                      Triangle{triangle_of(c)}});
        }
    });
}

template <class Real>
Vertex merge_ends(TopologyWork<Real>& work, Vertex v, Vertex w, bool either) {
    return Merging<Real>(work, v, w).run(either);
}

template <class Real>
bool remove_inside(TopologyWork<Real>& work, Vertex vertex, Real min_quality) {
    Complex<Real>& complex = work.complex;
    Star<Real> star;
    if (!gather(complex, Region{}, vertex.id, star) || !star.one_phase || !star.closed) {
        return false;
    }
    Real best = min_quality;
    std::uint32_t heir = no_id;
    for (std::uint32_t i = 0; i < star.size; ++i) {
        const Real after = star.size > 3 ? worst_quality_squared_after_collapse(star, i) : 1;
        if (after > best && star_collapse_guard(complex, star, i) == Verdict::legal) {
            best = after;
            heir = i;
        }
    }
    if (heir == no_id) {
        return false;
    }
    rewire::collapse(complex, complex.journal, prev(star.corner[heir]), rewire::Vanishing::next,
                     complex.ids);
    return true;
}

template <class Real>
bool remove_on_boundary(TopologyWork<Real>& work, Vertex vertex, Real min_quality) {
    Complex<Real>& complex = work.complex;
    const Corner first =
        find_corner(complex, vertex, [&](Corner c) { return is_border(complex.twin(prev(c))); });
    const Corner last =
        find_corner(complex, vertex, [&](Corner c) { return is_border(complex.twin(next(c))); });
    if (first == no_id || last == no_id ||
        (complex.vertices[vertex.id].flags & vertex_locked) != 0 ||
        find_corner(complex, vertex, [&](Corner c) {
            return complex.phase_at(c) != complex.phase_at(first);
        }) != no_id) {
        return false;
    }
    const auto longest = static_cast<Real>(longest_on_boundary) * work.edge_length;
    const Point<Real> chord = complex.position(Vertex{complex.vertex(next(first))}) -
                              complex.position(Vertex{complex.vertex(prev(last))});
    if (chord.squaredNorm() > longest * longest) {
        return false;
    }
    const Submesh<Real> submesh(complex);
    const auto collapses = [&](Corner edge, rewire::Vanishing vanishing, std::uint32_t kept) {
        const auto is_poor = [&](Corner c) {
            const Real after = quality_with(complex, c, Vertex{kept});
            return !(after > min_quality);
        };
        return find_corner(complex, vertex, is_poor) == no_id &&
               edge_collapse(submesh, edge, vanishing, BoundaryRule::smooth) == Verdict::legal;
    };
    return collapses(prev(first), rewire::Vanishing::next, complex.vertex(next(first))) ||
           collapses(next(last), rewire::Vanishing::prev, complex.vertex(prev(last)));
}

template bool remove_on_boundary(TopologyWork<double>&, Vertex, double);
template bool remove_on_boundary(TopologyWork<float>&, Vertex, float);
template void note_sweep(TopologyWork<double>&, Vertex, Vertex, const Point<double>&);
template void note_sweep(TopologyWork<float>&, Vertex, Vertex, const Point<float>&);
template Vertex merge_ends(TopologyWork<double>&, Vertex, Vertex, bool);
template Vertex merge_ends(TopologyWork<float>&, Vertex, Vertex, bool);
template bool remove_inside(TopologyWork<double>&, Vertex, double);
template bool remove_inside(TopologyWork<float>&, Vertex, float);

} // namespace dsc
