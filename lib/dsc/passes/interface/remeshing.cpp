// SPDX-License-Identifier: MIT
#include "dsc/passes/algorithm.h"

#include "dsc/base/verdict.h"
#include "dsc/geometry/side.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/boundary.h"
#include "dsc/passes/edits.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/passes/interface/limits.h"
#include "dsc/passes/interface/times_on_curve.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"
#include "dsc/sizes/rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

namespace {

template <class Real>
class Remeshing {
public:
    explicit Remeshing(Work<Real>& work)
        : work_(work), complex_(work.complex), thresholds_(work.options.interface), limits_(work),
          times_(work.complex) {}

    void run() {
        auto& kept = work_.interface_next;
        kept.clear();
        work_.stars.clear();
        for (const std::uint32_t v : work_.interface) {
            visit(v);
        }
        std::swap(work_.interface, kept);
    }

private:
    void visit(std::uint32_t v) {
        if (!complex_.is_alive(Vertex{v})) {
            return;
        }
        Star<Real>& star = work_.star;
        const bool gathered = gather(complex_, work_.submesh.region, v, star);
        if (!gathered) {
            work_.interface_next.push_back(v);
            return;
        }
        const IncidentEdges incident = interface_edges_of(star);
        if (!star.owned) {
            // Triangles that straddle two submeshes do not change now, so that the star shows
            // whether an edit is needed; only a gap depends on what lies beyond the link.
            if (limits_.gap > 0 || should_collapse(star, incident) ||
                long_edge(star, incident) != no_id || wants_boundary_remeshing(star)) {
                work_.deferred.remeshing(v);
            } else if (incident.count > 0) {
                keep(star, incident);
            }
            work_.interface_next.push_back(v);
        } else if (incident.count == 0) {
            if (star.one_phase && star.closed && work_.options.advects(star.phase[0])) {
                work_.interface_next.push_back(v);
            }
        } else if (!(should_collapse(star, incident) && try_collapse(star, incident)) &&
                   !(wants_boundary_remeshing(star) && keep_boundary(v, star)) &&
                   !refine(v, star, incident)) {
            keep(star, incident);
            show(star, incident);
        }
    }

    void keep(const Star<Real>& star, const IncidentEdges& incident) {
        if (star.closed && star.size <= CachedStar::capacity &&
            complex_.vertices[star.vertex].stamp != work_.epoch) {
            work_.stars.push_back(cache_star(complex_, star, incident));
        }
    }

    void show(const Star<Real>& star, const IncidentEdges& incident) {
        for (const Pass<Real>& pass : work_.remeshing) {
            if (pass.watch) {
                pass.watch(work_, star, incident);
            }
        }
    }

    // --- the interface along the domain boundary ----------------------------------------------
    bool wants_boundary_remeshing(const Star<Real>& star) const {
        return !star.closed &&
               (should_collapse_on_boundary(complex_, star, limits_.on_boundary(star)) ||
                (star.phase[0] != exterior_phase &&
                 should_split_boundary(star, limits_.on_boundary(star))));
    }

    // A short boundary edge that blocks the end of a curve, or a vertex that slides into a corner
    // of the domain, is collapsed even if the merged edge is so long that it is split again. A
    // short edge behind an end that slides away blocks nothing: there the merged edge would grow
    // with each sub-step, so it may only be as long as a long edge and a short one together.
    bool may_collapse_on_boundary(const Star<Real>& star, const BoundaryLimits<Real>& boundary) {
        if (!should_collapse_on_boundary(complex_, star, boundary)) {
            return false;
        }
        const Real merged = merged_on_boundary(star);
        if (merged < boundary.longest) {
            return true;
        }
        if (std::sqrt(merged) > std::sqrt(boundary.longest) + std::sqrt(boundary.blocking)) {
            return false;
        }
        const bool is_first =
            boundary_edge(star, true).squared < boundary_edge(star, false).squared;
        if (!see_end(star, is_first ? 0 : star.size)) {
            return false;
        }
        const Star<Real>& end = work_.other_star;
        return !end.one_phase || complex_.is_boundary_feature(Vertex{end.vertex}) ||
               side_at<Real>(link_point(end, 0), {end.x0, end.y0}, link_point(end, end.size),
                             false) == Side::feature;
    }

    // Gathers the star at the other end of an incident edge into `other_star`. False if that fails,
    // or if another submesh owns part of it; the centre is then deferred.
    bool see_end(const Star<Real>& star, std::uint32_t incident_edge) {
        Star<Real>& end = work_.other_star;
        const bool gathered = gather(complex_, work_.submesh.region, star.link[incident_edge], end);
        if (!end.owned) {
            work_.deferred.remeshing(star.vertex);
            return false;
        }
        return gathered;
    }

    // Returns true if the star is stale after an edit; the vertices to be kept are then in the
    // list.
    bool keep_boundary(std::uint32_t v, const Star<Real>& star) {
        BoundaryLimits<Real> boundary = limits_.on_boundary(star);
        if (may_collapse_on_boundary(star, boundary)) {
            // Of several vertices close to each other, as a phase leaves them that vanishes in a
            // corner of the domain, the first one leaves triangles about as poor as they were.
            const Real worst = std::sqrt(worst_quality_squared(star, star.x0, star.y0));
            if (worst < boundary.min_quality) {
                boundary.min_quality = worst / 2;
            }
            if (collapse_on_boundary(work_, star, boundary)) {
                return true;
            }
        }
        if (star.phase[0] == exterior_phase || !should_split_boundary(star, boundary)) {
            return false;
        }
        const SplitResult result = split_boundary(work_, star);
        if (is_deferred(result.verdict)) {
            work_.deferred.remeshing(v);
        }
        if (result.verdict != Verdict::legal) {
            return false;
        }
        work_.interface_next.push_back(v);
        work_.interface_next.push_back(result.vertex.id);
        return true;
    }

    // --- coarsening ---------------------------------------------------------------------------
    bool should_collapse(const Star<Real>& star, const IncidentEdges& incident) {
        if (thresholds_.coarsening == Coarsening::never || incident.count != 2 || !star.closed ||
            complex_.is_feature(Vertex{star.vertex})) {
            return false;
        }
        const Point<Real> p(star.x0, star.y0);
        const Point<Real> a = link_point(star, incident.first);
        const Point<Real> b = link_point(star, incident.second);
        const Real nearest = std::min(squared_distance(p, a), squared_distance(p, b));
        const Real here = limits_.stretch(p);
        if (nearest >= here * limits_.shortest) {
            return false;
        }
        if (const Real merged = squared_distance(a, b);
            merged >= limits_.allowed(limits_.by_shape(complex_, star, incident), a, b) &&
            (merged >= here * limits_.bypass || !is_ahead_of_end(star, incident))) {
            return false;
        }
        if (nearest < here * limits_.degenerate &&
            !turns_less<Real>(a, p, b, std::numbers::sqrt2_v<Real> / 2)) {
            return true;
        }
        return turns_less<Real>(a, p, b, Real(0)) &&
               (thresholds_.coarsening != Coarsening::deviation ||
                squared_deviation(star, incident) < here * limits_.deviation);
    }

    // Whether the nearer neighbour is an end of the curve: a junction, or on the domain boundary.
    // If such an end moves along the curve, the centre blocks it and is collapsed, even if the
    // merged edge is so long that it is split again.
    bool is_ahead_of_end(const Star<Real>& star, const IncidentEdges& incident) {
        const Point<Real> p(star.x0, star.y0);
        const bool is_first = squared_distance(p, link_point(star, incident.first)) <
                              squared_distance(p, link_point(star, incident.second));
        if (!see_end(star, is_first ? incident.first : incident.second)) {
            return false;
        }
        const Star<Real>& end = work_.other_star;
        return !end.closed || interface_edges_of(end).count != 2;
    }

    // Squared distance of the centre from the curve without it; 0 if that curve reaches into
    // another submesh.
    Real squared_deviation(const Star<Real>& star, const IncidentEdges& incident) {
        const Point<Real> p(star.x0, star.y0);
        CurveNeighbours<Real> curve;
        curve.p1 = link_point(star, incident.first);
        curve.p2 = link_point(star, incident.second);
        const Point<Real> chord = curve.p2 - curve.p1;
        if (thresholds_.reading == Reading::chords) {
            const Point<Real> offset = p - curve.p1;
            const Real area = cross<Real>(chord, offset);
            return area * area / chord.squaredNorm();
        }
        // The cubic without the centre, at the centre's share of the chord length.
        const Real before = (p - curve.p1).norm();
        const Real share = before / (before + (curve.p2 - p).norm());
        if (!see_past(star, incident.first, curve.p0, curve.has_first) ||
            !see_past(star, incident.second, curve.p3, curve.has_last)) {
            return 0;
        }
        const Point<Real> off = p - curve_point(curve, share);
        const Real across = cross<Real>(chord, off);
        return across * across / chord.squaredNorm();
    }

    // The vertex of the curve beyond the end of an incident edge. False if another submesh owns
    // part of the star of that end.
    bool see_past(const Star<Real>& star, std::uint32_t incident_edge, Point<Real>& next,
                  bool& has_next) {
        Star<Real>& beyond = work_.other_star;
        if (!gather(complex_, work_.submesh.region, star.link[incident_edge], beyond)) {
            return beyond.owned;
        }
        CurveNeighbours<Real> on;
        on.p1 = {star.x0, star.y0};
        on.p2 = link_point(star, incident_edge);
        see_from_beyond(complex_, beyond, star.vertex, on);
        next = on.p3;
        has_next = on.has_last;
        return true;
    }

    bool try_collapse(Star<Real>& star, const IncidentEdges& incident) {
        const Point<Real> p(star.x0, star.y0);
        const Real to_a = (link_point(star, incident.first) - p).squaredNorm();
        const Real to_b = (link_point(star, incident.second) - p).squaredNorm();
        const std::uint32_t nearer = to_a < to_b ? incident.first : incident.second;
        for (const std::uint32_t i : {nearer, incident.other(nearer)}) {
            if (collapse_centre(work_, star, prev(star.corner[i]), rewire::Vanishing::next) ==
                Verdict::legal) {
                return true;
            }
        }
        return false;
    }

    // --- refinement ---------------------------------------------------------------------------
    // The interface edge to be split; no_id if there is none. An edge longer than the general limit
    // is split only from the end at which the larger phase is on its left, so that each edge is
    // found once. An edge too long for the shape at the centre is split from the centre.
    std::uint32_t long_edge(const Star<Real>& star, const IncidentEdges& incident) const {
        const Point<Real> p(star.x0, star.y0);
        const Real local = limits_.by_shape(complex_, star, incident);
        std::uint32_t found = no_id;
        Real longest = 0;
        const auto look_at = [&](std::uint32_t i) {
            const Phase before = star.phase_before(i);
            const Phase after = star.phase_after(i);
            if (before == after || before == border_phase || after == border_phase) {
                return;
            }
            const Real squared = squared_distance(p, link_point(star, i));
            const bool is_found_here = after > before || local < limits_.longest;
            if (is_found_here && squared > limits_.allowed(local, p, link_point(star, i)) &&
                squared > longest) {
                found = i;
                longest = squared;
            }
        };
        if (incident.count == 2) { // as nearly always
            look_at(incident.first);
            look_at(incident.second);
            return found;
        }
        for (std::uint32_t i = 0; i < star.link_size(); ++i) {
            look_at(i);
        }
        return found;
    }

    // Splits at most one edge, because the star is stale afterwards; the other edges of a junction
    // wait for the next step. Returns whether it split one.
    bool refine(std::uint32_t v, Star<Real>& star, const IncidentEdges& incident) {
        newest_ = no_id;
        if (const std::uint32_t i = long_edge(star, incident);
            i != no_id && !split(v, star, incident, i)) {
            work_.deferred.remeshing(v);
        }
        work_.interface_next.push_back(v);
        if (newest_ != no_id) {
            work_.interface_next.push_back(newest_);
        }
        return newest_ != no_id;
    }

    bool split(std::uint32_t v, const Star<Real>& star, const IncidentEdges& incident,
               std::uint32_t i) {
        CurveNeighbours<Real> curve;
        see_from_centre(complex_, star, incident, i, curve);
        Star<Real>& beyond = work_.other_star;
        const bool gathered = gather(complex_, work_.submesh.region, star.link[i], beyond);
        if (!beyond.owned) {
            return false;
        }
        if (gathered) {
            see_from_beyond(complex_, beyond, v, curve);
        }
        times_.read(star, incident, i, beyond, curve);
        const auto& options = work_.options;
        Point<Real> point =
            options.insertion_function
                ? options.insertion_function(curve)
                : between_sheets(star, i, curve, insertion_point(options.insertion, curve));
        if (!owns_point(point)) {
            point = midpoint<Real>(curve.p1, curve.p2);
            if (!owns_point(point)) {
                return false;
            }
        }
        const Corner corner = prev(star.corner[i]);
        SplitResult result = dsc::split(work_, corner, point, Wake::all);
        if (result.verdict == Verdict::inverts) {
            point = midpoint<Real>(curve.p1, curve.p2);
            result = dsc::split(work_, corner, point, Wake::all);
        }
        if (result.verdict == Verdict::out_of_ids) {
            return false;
        }
        if (result.verdict == Verdict::legal) {
            newest_ = result.vertex.id;
            times_.note(result.vertex, curve, point);
        }
        return true;
    }

    // In a row of sheets, those that bend away from their neighbour could follow the curve, and
    // those behind them could not: films would swell. So between two sheets that are less than half
    // an edge apart, new vertices stay on their edges.
    Point<Real> between_sheets(const Star<Real>& star, std::uint32_t i,
                               const CurveNeighbours<Real>& curve, const Point<Real>& point) const {
        const Point<Real> chord = curve.p2 - curve.p1;
        Real distances = 0; // from the chord, times its length
        for (const std::uint32_t k :
             {i == 0 ? star.link_size() - 1 : i - 1, i + 1 == star.link_size() ? 0 : i + 1}) {
            if (!is_interface(complex_, Vertex{star.link[k]})) {
                return point;
            }
            distances += std::abs(cross<Real>(chord, link_point(star, k) - curve.p1));
        }
        return distances < chord.squaredNorm() / 2 ? midpoint<Real>(curve.p1, curve.p2) : point;
    }

    // A new vertex must lie in the submesh that makes it, because the next colour looks for it
    // there.
    bool owns_point(const Point<Real>& point) const {
        return owns_place(work_.submesh.region, point);
    }

    Work<Real>& work_;
    Complex<Real>& complex_;
    const InterfaceThresholds& thresholds_;
    InterfaceLimits<Real> limits_;
    std::uint32_t newest_ = no_id;
    TimesOnCurve<Real> times_;
};

} // namespace

template <class Real>
void remesh_interface(Work<Real>& work) {
    Remeshing<Real>(work).run();
}

template void remesh_interface(Work<double>&);
template void remesh_interface(Work<float>&);

} // namespace dsc
