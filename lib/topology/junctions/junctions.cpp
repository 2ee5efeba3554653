// SPDX-License-Identifier: MIT
#include "topology/junctions/junctions.h"

#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_collapse.h"
#include "topology/fronts/front_curve.h"
#include "topology/junctions/junction_split.h"
#include "topology/junctions/mending.h"
#include "topology/junctions/merging.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace dsc {

namespace {

/// Two junctions closer than this times the edge length may exchange their neighbours.
constexpr double t1_length = 0.15;
/// Bounds the rounds if splits never end; two or three rounds are normally enough.
constexpr int max_rounds = 8;
/// Slender triangles lie in clusters: what is mended lets the stars around it be mended, too.
constexpr int rounds_around = 3;

// Sorts the vertices that are alive by position, which does not depend on the division of the mesh,
// and removes duplicates.
template <class Real>
std::vector<Vertex> in_order(const Complex<Real>& complex, std::span<const Vertex> vertices) {
    std::vector<std::tuple<Real, Real, std::uint32_t>> found;
    for (const Vertex v : vertices) {
        if (!complex.is_alive(v)) {
            continue;
        }
        found.emplace_back(complex.position(v).x(), complex.position(v).y(), v.id);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<Vertex> list;
    for (const auto& one : found) {
        list.push_back(Vertex{std::get<2>(one)});
    }
    return list;
}

// The vertices that are alive and those around them, in order.
template <class Real>
std::vector<Vertex> with_links(const Complex<Real>& complex, std::span<const Vertex> vertices) {
    std::vector<Vertex> all = in_order<Real>(complex, vertices); // each once, however often touched
    const std::size_t size = all.size();
    for (std::size_t i = 0; i < size; ++i) {
        for_each_corner(complex, all[i], [&](Corner c) {
            all.push_back(Vertex{complex.vertex(next(c))});
            all.push_back(Vertex{complex.vertex(prev(c))});
        });
    }
    return in_order<Real>(complex, all);
}

template <class Real>
class Junctions {
public:
    explicit Junctions(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(work.complex),
          shortest_(static_cast<Real>(t1_length) * work.edge_length) {}

    void run(std::span<const Candidate> candidates) {
        std::vector<Vertex> list;
        // A sharp turn between two edges can become a junction only if something has changed there.
        const bool is_changed = !work_.touched.empty();
        for (const auto& candidate : candidates) {
            if ((is_changed ? candidate.is_sharp : candidate.is_junction) &&
                complex_.is_alive(Vertex{candidate.vertex}) &&
                may_split(complex_, Vertex{candidate.vertex}, shortest_)) {
                list.push_back(Vertex{candidate.vertex});
            }
        }
        for (const Vertex v : in_order(complex_, list)) {
            if (complex_.is_alive(v)) {
                visit(v);
            }
        }
        list.clear();
        for (const auto& candidate : candidates) {
            if (candidate.is_junction && has_narrow_seam(work_, Vertex{candidate.vertex})) {
                list.push_back(Vertex{candidate.vertex});
            }
        }
        for (const Vertex v : in_order<Real>(complex_, list)) {
            mend_seams(work_, v);
        }
    }

private:
    void visit(Vertex v) {
        find_sectors(complex_, v, here_);
        if (here_.size() > here_.stable() || (here_.is_at_corner && here_.size() == 2)) {
            split_junction(work_, v);
        } else if (here_.is_on_boundary && here_.size() == 2) {
            flip_on_boundary(v);
        } else if (!here_.is_on_boundary && here_.size() == 3) {
            perform_t1(v);
        }
    }

    bool is_short(Vertex v, Vertex w) const {
        return (complex_.position(w) - complex_.position(v)).norm() < shortest_;
    }

    bool merge(Vertex v, Vertex w, bool either) {
        const Vertex left = merge_ends_of_here(v, w, either);
        if (!left.is_valid()) {
            return false;
        }
        split_junction(work_, left);
        return true;
    }

    // If the merge fails, vertices may still have been removed to make room; the sectors at v are
    // then found again, in the same order.
    Vertex merge_ends_of_here(Vertex v, Vertex w, bool either) {
        const std::uint32_t size = complex_.triangle_count();
        const Vertex left = merge_ends(work_, v, w, either);
        if (!left.is_valid() && complex_.triangle_count() != size) {
            find_sectors_again(complex_, v, here_);
        }
        return left;
    }

    [[nodiscard]] bool may(Phase one, Phase other) const { return may_change(work_, one, other); }

    // --- inside the domain --------------------------------------------------------------------

    // Two junctions at rest have not come closer: where fronts have met, they would exchange their
    // neighbours to and fro.
    [[nodiscard]] bool rest(Vertex v, Vertex w) const {
        return rests(work_, v.id) && rests(work_, w.id);
    }
    void perform_t1(Vertex v) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner at = here_[i].first; // the ray leads to the next corner of the domain
            const Vertex w{complex_.vertex(next(at))};
            if (!is_short(v, w)) {
                continue;
            }
            find_sectors(complex_, w, there_);
            const bool wants = there_.is_on_boundary
                                   ? there_.size() == 2 && wants_to_boundary(i)
                                   : there_.size() == 3 && !rest(v, w) && wants_t1(i);
            if (wants && merge(v, w, !there_.is_on_boundary)) {
                return;
            }
        }
    }

    // The four sectors at the edge from v to w: sector i lies to its left, sector i - 1 to its
    // right, the third one beyond v. The fourth, beyond w, is the sector of w that is neither left
    // nor right; seen from w the two swap sides.
    bool wants_t1(std::size_t i) const {
        const Sector<Real>& left = here_[i];
        const Sector<Real>& right = here_.before(i);
        const Sector<Real>& near = here_.after(i);
        const auto at = std::ranges::find(there_.list, right.phase, &Sector<Real>::phase);
        if (at == there_.list.end()) {
            return false;
        }
        const auto k = static_cast<std::size_t>(at - there_.list.begin());
        const Sector<Real>& far = there_.after(k);
        if (there_.before(k).phase != left.phase || !may(left.phase, near.phase) ||
            !may(right.phase, near.phase) || !may(left.phase, far.phase) ||
            !may(right.phase, far.phase)) {
            return false;
        }
        // Rays at v: between the sectors left and near, and between near and right. Rays at w:
        // between right and far, and between far and left.
        const double left_angle = angle_between(there_.before(k).ray, near.ray);
        const double right_angle = angle_between(right.ray, far.ray);
        const double as_it_is =
            gain(left, near, right, near.angle) + gain(right, far, left, far.angle);
        const double after_t1 =
            gain(far, left, near, left_angle) + gain(near, right, far, right_angle);
        return after_t1 < as_it_is - energy_tie;
    }

    [[nodiscard]] double gain(const Sector<Real>& before, const Sector<Real>& sector,
                              const Sector<Real>& after, double angle) const {
        return energy_inwards(work_, before.phase, sector.phase, after.phase, angle);
    }

    // --- at the domain boundary --------------------------------------------------------------

    // The edge of ray i leads to the domain boundary and to the sectors on its two sides; the third
    // sector must reach the domain boundary between these two.
    bool wants_to_boundary(std::size_t i) const {
        const Sector<Real>& first = here_[i];
        const Sector<Real>& last = here_.before(i);
        const Sector<Real>& beyond = here_.after(i);
        if (there_[0].phase != first.phase || there_[1].phase != last.phase ||
            !may(first.phase, beyond.phase) || !may(last.phase, beyond.phase)) {
            return false;
        }
        const double as_it_is = gain(first, beyond, last, beyond.angle);
        const double after_t1 = along(first, beyond, angle_between(there_[0].ray, beyond.ray)) +
                                along(last, beyond, angle_between(last.ray, there_.end));
        return after_t1 < as_it_is - energy_tie;
    }

    [[nodiscard]] double along(const Sector<Real>& sector, const Sector<Real>& neighbour,
                               double angle) const {
        return energy_along_boundary(work_, sector.phase, neighbour.phase, angle);
    }

    // Tries both directions along the domain boundary: to another end of a curve, or to a corner. A
    // vertex of neither kind blocks the way and is removed.
    void flip_on_boundary(Vertex v) {
        for (const bool is_first : {true, false}) {
            const Corner at = is_first ? here_[0].first : last_of(complex_, here_[1]);
            const Vertex w{complex_.vertex(is_first ? next(at) : prev(at))};
            const Corner edge = is_first ? prev(at) : next(at);
            if (!is_short(v, w)) {
                continue;
            }
            find_sectors(complex_, w, there_);
            if (there_.size() == 1 && !there_.is_at_corner) {
                const auto end = is_first ? rewire::Vanishing::prev : rewire::Vanishing::next;
                (void)edge_collapse(submesh_, edge, end, BoundaryRule::smooth);
                find_sectors(complex_, v, here_);
                continue;
            }
            if (there_.is_at_corner) {
                const Phase between = here_[is_first ? 0 : 1].phase;
                if (const Vertex corner = merge_ends_of_here(v, w, false); corner.is_valid()) {
                    pass_corner(work_, corner, between);
                    return;
                }
            } else if (there_.size() == 2 &&
                       (is_first ? wants_off_boundary(there_, here_)
                                 : wants_off_boundary(here_, there_)) &&
                       merge(v, w, true)) {
                return;
            }
        }
    }

    // `one` is the first end on the domain boundary, counter-clockwise. Its second sector is the
    // first sector of `other`, and would leave the domain boundary.
    bool wants_off_boundary(const Sectors<Real>& one, const Sectors<Real>& other) const {
        const Sector<Real>& before = one[0];
        const Sector<Real>& between = other[0];
        const Sector<Real>& after = other[1];
        if (one[1].phase != between.phase || !may(before.phase, between.phase) ||
            !may(between.phase, after.phase)) {
            return false;
        }
        const double as_it_is =
            along(before, between, before.angle) + along(after, between, after.angle);
        const double after_t1 = gain(before, between, after, angle_between(one[1].ray, after.ray));
        return after_t1 < as_it_is - energy_tie;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    Real shortest_;
    Sectors<Real> here_;
    Sectors<Real> there_;
};

} // namespace

template <class Real>
void change_junctions(TopologyWork<Real>& work, std::span<const Candidate> candidates) {
    Junctions<Real>(work).run(candidates);
}

// Whether a triangle at the vertex is flatter than those that remeshing leaves.
template <class Real>
bool is_flat_at(const Complex<Real>& complex, Vertex v) {
    return find_corner(complex, v, [&](Corner c) {
               const auto at = [&](Corner k) {
                   return complex.position(Vertex{complex.vertex(k)});
               };
               return height_over_longest<Real>(at(c), at(next(c)), at(prev(c))) < Real(0.02);
           }) != no_id;
}

// A split changes other vertices, which may then have to be split as well.
template <class Real>
void split_touched(TopologyWork<Real>& work, std::span<const Candidate> candidates,
                   std::size_t first_mended) {
    std::vector<Vertex> mended(work.touched.begin() + static_cast<std::ptrdiff_t>(first_mended),
                               work.touched.end());
    for (int round = 0; round < max_rounds && !work.touched.empty(); ++round) {
        for (const Vertex v : in_order<Real>(work.complex, std::exchange(work.touched, {}))) {
            split_junction(work, v);
        }
        mended.insert(mended.end(), work.touched.begin(), work.touched.end());
    }
    mended = with_links<Real>(work.complex, with_links<Real>(work.complex, mended));
    for (int round = 0; round < rounds_around && !mended.empty(); ++round) {
        for (const Vertex v : mended) { // some may have been removed from other stars by then
            collapse_short_sheets(work, v);
            mend_seams(work, v);
        }
        std::erase_if(mended, [&](Vertex v) { return !mend_star(work, v); });
        mended = with_links<Real>(work.complex, mended);
    }
    for (const Candidate& candidate : candidates) {
        const Vertex v{candidate.vertex};
        if (candidate.is_junction && work.complex.is_alive(v) && is_flat_at(work.complex, v)) {
            mend_star(work, v);
        }
    }
}

template void change_junctions(TopologyWork<double>&, std::span<const Candidate>);
template void change_junctions(TopologyWork<float>&, std::span<const Candidate>);
template void split_touched(TopologyWork<double>&, std::span<const Candidate>, std::size_t);
template void split_touched(TopologyWork<float>&, std::span<const Candidate>, std::size_t);

} // namespace dsc
