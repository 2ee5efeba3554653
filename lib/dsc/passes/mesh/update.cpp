// SPDX-License-Identifier: MIT
#include "dsc/passes/algorithm.h"

#include "dsc/base/verdict.h"
#include "dsc/motion/movement.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/boundary.h"
#include "dsc/passes/mesh/flips.h"
#include "dsc/passes/mesh/poor_stars.h"
#include "dsc/passes/mesh/size_update.h"
#include "dsc/passes/mesh/star.h"
#include "dsc/passes/waiting.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace dsc {

namespace {

/// Rounds at one vertex: flips and splits change its star, so it is gathered again.
constexpr int max_turns = 6;
/// Squared share of the shortest edge: boundary edges below it block vertices that move along the
/// domain boundary. Each pass halves the edge ahead, so that the exact share does not matter.
constexpr auto blocking_squared = 0.01F;

template <class Real>
class MeshUpdate {
public:
    explicit MeshUpdate(Work<Real>& work)
        : work_(work), complex_(work.complex), star_(work.star), sizes_(work),
          grading_squared_(
              static_cast<Real>(work.options.interface.grading * work.options.interface.grading)),
          needle_(grading_squared_ > 0 ? squared_quality_of_needle(grading_squared_) : Real(0)),
          limits_are_fixed_(sizes_.is_uniform() && work.options.per_phase.empty()),
          limits_(limits(exterior_phase, work.options.edge_length)) {}

    // Updates the star of a vertex. A vertex that has been removed has none. Its id may be in use
    // again elsewhere, so its position is checked before anything else.
    void visit(std::uint32_t v) {
        Real length = 0; // the target, updated once per visit
        for (int turn = 0; turn < max_turns; ++turn) {
            if (!gather_star(v)) {
                list_unexamined(work_, v);
                return;
            }
            if (waiting_.applies() && waits(work_, waiting_, star_)) {
                list_unexamined(work_, v);
                deferred(work_, v);
                return;
            }
            ++work_.log.counts.examined;
            const StarReport<Real> report = examine(star_, margins_);
            if (report.delaunay < 0 && flips_.flip_incident_edges(star_, margins_)) {
                continue;
            }
            if (!limits_are_fixed_) {
                length = length > 0 ? length : sizes_.follow(star_);
                limits_ = limits(star_.phase[0], length);
            }
            const Limits& limit = limits_;
            const bool may_move = star_.one_phase && star_.closed && !complex_.is_locked(Vertex{v});
            if (may_move) {
                const bool poor = report.quality < limit.collapse;
                // A moving vertex must keep its id: `moving_vertices` refers to it.
                const bool has_arrived = (complex_.vertices[v].flags & vertex_on_way) == 0;
                if (has_arrived &&
                    (poor || report.shortest < limit.shortest || report.longest < limit.crowded) &&
                    collapse(report, limit)) {
                    return;
                }
                if (report.quality < limit.smooth && smooth(v, report.quality)) {
                    (void)examine(star_, margins_);
                    flips_.flip_edges_of_triangles(star_, margins_);
                    return;
                }
            }
            if (!star_.closed) {
                const BoundaryRemeshing done = keep_boundary(v, report, length);
                if (done == BoundaryRemeshing::gone) {
                    list_unexamined(work_, star_.link[0]);
                    list_unexamined(work_, star_.link[star_.size]);
                    return;
                }
                if (done == BoundaryRemeshing::split) {
                    continue;
                }
            }
            // Around an interface vertex phases differ, and so may their limits.
            const bool mixed = !star_.one_phase && !work_.options.per_phase.empty();
            if ((mixed || report.longest > limit.longest) && split_longest(length, limit, mixed)) {
                continue;
            }
            if (!star_.one_phase && report.quality < needle_ && split_beside_short()) {
                continue;
            }
            list_if_poor(work_, v, report.quality);
            return;
        }
        list_unexamined(work_, v);
        is_unfinished_ = true;
    }

    // Visits the active set, to which vertices created on the way are appended: splits halve
    // lengths, so this terminates. Where much has to change, the next pass continues: with stars
    // beyond the bound of this one, and with those whose edges are still far too long, or have
    // become so by flips.
    void run() {
        std::vector<std::uint32_t>& active = work_.active;
        const std::size_t bound = 8 * active.size() + 64;
        std::size_t visited = 0;
        while (visited < active.size() && visited < bound) {
            visit(active[visited++]);
        }
        if (is_unfinished_ || visited < active.size()) {
            constexpr Real far = 2; // squared: edges above the limit times this are far too long
            const auto is_done = [&](std::uint32_t v) {
                return !gather_star(v) || examine(star_, margins_).longest <=
                                              far * limits(star_.phase[0], sizes_.at(v)).longest;
            };
            for (const std::uint32_t v : std::span(active).subspan(visited)) {
                list_unexamined(work_, v);
                work_.resized.push_back(v);
            }
            std::remove_copy_if(active.begin(),
                                active.begin() + static_cast<std::ptrdiff_t>(visited),
                                std::back_inserter(work_.resized), is_done);
        }
        active.clear();
    }

private:
    using Limits = StarLimits<Real>;
    Limits limits(Phase phase, Real length) const {
        return star_limits(work_.options, phase, length);
    }

    bool gather_star(std::uint32_t v) {
        const bool gathered = gather(complex_, work_.submesh.region, v, star_);
        if (!star_.owned) {
            work_.deferred.star(v);
        }
        return gathered && star_.owned;
    }

    // --- coarsening ---------------------------------------------------------------------------
    /// Collapses the centre into the link vertex that leaves the best triangles.
    bool collapse(const StarReport<Real>& report, const Limits& limit) {
        if (star_.size < 4) {
            // Degree three: the link is the triangle that will remain.
            return star_.size == 3 && finish_collapse(0);
        }
        // Removing a short edge may lower the quality, down to the threshold of a collapse.
        const bool is_short = report.shortest < limit.shortest || report.longest < limit.crowded;
        Real best = is_short ? std::min(report.quality, limit.collapse) : report.quality;
        std::uint32_t best_edge = no_id;
        for (std::uint32_t i = 0; i < star_.size; ++i) {
            const Real after = worst_quality_squared_after_collapse(star_, i);
            if (after > best && longest_after_collapse(star_, i) <= longest_about(i, limit) &&
                keeps_grading(complex_, star_, grading_squared_, i)) {
                best = after;
                best_edge = i;
            }
        }
        return best_edge != no_id && finish_collapse(best_edge);
    }

    /// The largest squared length that edges of link vertex i may have after a collapse.
    Real longest_about(std::uint32_t i, const Limits& limit) const {
        const Real target = sizes_.at(star_.link[i]);
        return Real(1.44) *
               (sizes_.is_uniform() ? limit.longest : limits(star_.phase[0], target).longest);
    }

    bool finish_collapse(std::uint32_t i) {
        const std::uint32_t target = star_.link[i];
        if (collapse_star(work_, star_, i) != Verdict::legal) {
            return false;
        }
        list_unexamined(work_, target);
        sizes_.look_again(star_);
        // Restore the Delaunay condition around the vertex that took over the star.
        Star<Real>& other = work_.other_star;
        if (gather(complex_, work_.submesh.region, target, other) && other.owned &&
            examine(other, margins_).delaunay < 0) {
            flips_.flip_around(other);
        }
        return true;
    }

    // --- sides of the exterior phase ----------------------------------------------------------
    enum class BoundaryRemeshing : std::uint8_t { none, gone, split };

    BoundaryRemeshing keep_boundary(std::uint32_t v, const StarReport<Real>& report, Real length) {
        const bool is_exterior_first = star_.phase[0] == exterior_phase;
        // With uniform sizes, an edge need not be tested from its other end.
        const bool is_exterior_last =
            !sizes_.is_uniform() && star_.phase[star_.size - 1] == exterior_phase;
        if (!is_exterior_first && !is_exterior_last) {
            return BoundaryRemeshing::none;
        }
        const Limits& limit = is_exterior_first ? limits_ : limits(exterior_phase, length);
        const bool is_poor = report.quality < limit.collapse;
        const BoundaryLimits<Real> boundary{
            limit.longest, limit.shortest,
            std::sqrt(std::clamp(report.quality, Real(0), limit.collapse)),
            blocking_squared * limit.shortest};
        if (should_collapse_on_boundary(complex_, star_, boundary, is_poor) &&
            collapse_on_boundary(work_, star_, boundary)) {
            sizes_.look_again(star_);
            return BoundaryRemeshing::gone;
        }
        for (const bool is_first : {true, false}) {
            if (!(is_first ? is_exterior_first : is_exterior_last) ||
                !should_split_boundary(star_, boundary, is_first)) {
                continue;
            }
            const SplitResult result = split_boundary(work_, star_, is_first);
            if (is_deferred(result.verdict)) {
                work_.deferred.star(v);
            }
            if (result.verdict == Verdict::legal) {
                list_unexamined(work_, result.vertex.id);
                return BoundaryRemeshing::split;
            }
        }
        return BoundaryRemeshing::none;
    }

    // --- smoothing ----------------------------------------------------------------------------
    /// Laplacian smoothing (thesis, equation 6), by the full or half the way, whichever is better,
    /// if it raises the worst quality.
    bool smooth(std::uint32_t v, Real before) {
        Real sum_x = 0;
        Real sum_y = 0;
        for (std::uint32_t i = 0; i < star_.size; ++i) {
            sum_x += star_.x[i] - star_.x0;
            sum_y += star_.y[i] - star_.y0;
        }
        const Real share = Real(1) / static_cast<Real>(star_.size);
        Real best = before;
        Real best_x = 0;
        Real best_y = 0;
        const auto look_at = [&](Real px, Real py) {
            const Real after = worst_quality_squared(star_, px, py);
            if (after > best) {
                best = after;
                best_x = px;
                best_y = py;
            }
        };
        for (const Real step : {Real(1), Real(0.5)}) {
            look_at(star_.x0 + step * share * sum_x, star_.y0 + step * share * sum_y);
        }
        if (!(best > before) || !all_positive(star_, best_x, best_y)) {
            return false;
        }
        if (!owns_place<Real>(work_.submesh.region, {best_x, best_y})) {
            work_.deferred.star(v);
            return false;
        }
        rewire::move(complex_, work_.log, v, best_x, best_y, MoveReason::smoothing);
        star_.x0 = best_x;
        star_.y0 = best_y;
        list_if_poor(work_, v, best);
        return true;
    }

    // --- refinement ---------------------------------------------------------------------------
    bool split_longest(Real length, const Limits& limit, bool mixed) {
        Real longest = 0;
        std::uint32_t incident_edge = no_id;
        for (std::uint32_t i = star_.closed ? 0 : 1; i < star_.size; ++i) {
            const Real squared = star_.squared_edge(i);
            const Real allowed = mixed ? limits(star_.phase[i], length).longest : limit.longest;
            if (squared > allowed && squared > longest && !star_.is_constrained(i)) {
                longest = squared;
                incident_edge = i;
            }
        }
        return incident_edge != no_id && split_incident_edge(incident_edge);
    }

    bool split_beside_short() {
        const NeedleEdge found = needle_edge(star_, grading_squared_);
        if (found.incident_edge == no_id) {
            return false;
        }
        // While an end of the short edge waits for another submesh to move a vertex, the edge is
        // short only temporarily: a vertex made now would be removed in the next pass or colour,
        // and made again.
        if (!work_.submesh.region.is_whole() &&
            (is_waiting(complex_, star_.vertex) || is_waiting(complex_, star_.link[found.base]))) {
            work_.deferred.star(star_.vertex);
            return false;
        }
        // A thin film consists of needles from sheet to sheet: a vertex inside would have no room,
        // and would be removed again.
        Star<Real>& beyond = work_.other_star;
        return gather(complex_, work_.submesh.region, star_.link[found.incident_edge], beyond) &&
               beyond.one_phase && split_incident_edge(found.incident_edge);
    }

    bool split_incident_edge(std::uint32_t incident_edge) {
        const Point<Real> middle =
            midpoint<Real>({star_.x0, star_.y0}, {star_.x[incident_edge], star_.y[incident_edge]});
        if (!owns_place(work_.submesh.region, middle)) {
            work_.deferred.star(star_.vertex);
            return false;
        }
        const SplitResult result =
            dsc::split(work_, prev(star_.corner[incident_edge]), middle, Wake::far_end);
        if (result.verdict == Verdict::out_of_ids) {
            work_.deferred.star(star_.vertex);
        }
        if (result.verdict == Verdict::legal) {
            list_unexamined(work_, result.vertex.id);
        }
        return result.verdict == Verdict::legal;
    }

    Work<Real>& work_;
    Complex<Real>& complex_;
    Star<Real>& star_;
    SizeUpdate<Real> sizes_;
    Real grading_squared_;
    // Squared quality of a needle with a base of 1 and legs of the grading; 0: none are split.
    Real needle_;
    // Uniform sizes and no per-phase thresholds: the limits are the same for every star.
    bool limits_are_fixed_;
    Limits limits_;                     // limits of the star that is being visited
    IncidentEdgeMargins<Real> margins_; // of the star that was examined last, by incident edge
    WaitingRule waiting_ = waiting_rule(work_);
    DelaunayFlips<Real> flips_{work_, waiting_};
    bool is_unfinished_ = false; // a visit has used all its rounds
};

} // namespace

template <class Real>
void update_mesh(Work<Real>& work) {
    MeshUpdate<Real> update(work);
    activate_resized(work);
    update.run();
}

template void update_mesh(Work<double>&);
template void update_mesh(Work<float>&);

} // namespace dsc
