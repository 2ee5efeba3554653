// SPDX-License-Identifier: MIT
#include "dsc/passes/algorithm.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/edits.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/passes/wall.h"
#include "dsc/quality/measures.h"
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
        : work_(work), complex_(work.complex), thresholds_(work.options.interface),
          longest_squared_(square(thresholds_.longest)),
          shortest_squared_(square(thresholds_.shortest)),
          bypass_squared_(square(thresholds_.longest + thresholds_.shortest)),
          deviation_squared_(square(thresholds_.deviation)),
          degenerate_squared_(square(thresholds_.degenerate * thresholds_.deviation)),
          finest_squared_(square(2 * thresholds_.finest)),
          turn_squared_(
              static_cast<Real>(std::pow(thresholds_.turn_degrees * std::numbers::pi / 180, 2))),
          gap_squared_(static_cast<Real>(thresholds_.gap * thresholds_.gap)),
          sizes_(work.options.sizes, work.options.edge_length),
          follows_shape_(thresholds_.turn_degrees > 0 || thresholds_.gap > 0),
          // A wall edge ahead that is shorter than a sub-step blocks the motion. A poor triangle
          // for a while is better than one that cannot move.
          wall_{square(work.options.phases.longest), square(work.options.sub_step), Real(0.05),
                square(std::min(work.options.sub_step, work.options.phases.longest / 2))} {}

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
    Real square(double relative) const {
        const Real value = static_cast<Real>(relative) * work_.options.edge_length;
        return value * value;
    }

    // The square of the target of interface edges at a place, over that of the edge length.
    Real stretch(const Point<Real>& place) const {
        if (!work_.options.sizes.on_interface) {
            return 1;
        }
        const Real ratio = sizes_.on_interface(place, work_.time) / work_.options.edge_length;
        return ratio * ratio;
    }

    // How long an interface edge may be, squared; `local` is what the shape at one end allows.
    Real allowed(Real local, const Point<Real>& from, const Point<Real>& to) const {
        const Real here = longest_squared_ * stretch(midpoint<Real>(from, to));
        return local < longest_squared_ ? std::min(local, here) : here;
    }

    void visit(std::uint32_t v) {
        if (!complex_.is_alive(Vertex{v})) {
            return;
        }
        Ring<Real>& ring = work_.ring;
        const bool gathered = gather(complex_, work_.submesh.region, v, ring);
        if (!gathered) {
            work_.interface_next.push_back(v);
            return;
        }
        const IncidentEdges incident = interface_edges_of(ring);
        if (!ring.owned) {
            // Nobody rewrites the triangles that straddle two submeshes, or moves their vertices:
            // what there is to do can be seen from here, except beyond the link, as for a gap.
            if (gap_squared_ > 0 || should_collapse(ring, incident) ||
                long_edge(ring, incident) != no_id || wants_boundary_remeshing(ring)) {
                work_.deferred.remeshing(v);
            } else if (incident.count > 0) {
                keep(ring, incident);
            }
            work_.interface_next.push_back(v);
        } else if (incident.count == 0) {
            if (ring.one_phase && ring.closed && work_.options.carries(ring.phase[0])) {
                work_.interface_next.push_back(v);
            }
        } else if (!(should_collapse(ring, incident) && try_collapse(ring, incident)) &&
                   !(wants_boundary_remeshing(ring) && keep_wall(v, ring)) &&
                   !refine(v, ring, incident)) {
            keep(ring, incident);
            show(ring, incident);
        }
    }

    void keep(const Ring<Real>& ring, const IncidentEdges& incident) {
        if (ring.closed && ring.size <= KeptStar::capacity &&
            complex_.vertices[ring.vertex].stamp != work_.epoch) {
            work_.stars.push_back(keep_star(complex_, ring, incident));
        }
    }

    void show(const Ring<Real>& ring, const IncidentEdges& incident) {
        for (const Pass<Real>& pass : work_.remeshing) {
            if (pass.watch) {
                pass.watch(work_, ring, incident);
            }
        }
    }

    // --- the interface along the domain boundary ----------------------------------------------
    bool wants_boundary_remeshing(const Ring<Real>& ring) const {
        return !ring.closed &&
               (should_collapse_on_wall(ring, wall_at(ring)) ||
                (ring.phase[0] != exterior_phase && should_split_wall(ring, wall_at(ring))));
    }

    // The wall's edges are as fine as the interface where that is finer than the edge length.
    BoundaryLimits<Real> wall_at(const Ring<Real>& ring) const {
        const Real share = std::min(Real(1), stretch({ring.x0, ring.y0}));
        return {share * wall_.longest, share * wall_.shortest, wall_.least_quality,
                share * wall_.blocking};
    }

    // A short wall edge goes, even where the edge that is left is so long that it is split again,
    // if it is in the way of the end of a curve, or of a vertex that slides into a corner of the
    // domain.
    bool may_collapse_on_wall(const Ring<Real>& ring, const BoundaryLimits<Real>& wall) {
        if (!should_collapse_on_wall(ring, wall)) {
            return false;
        }
        if (merged_on_wall(ring) < wall.longest) {
            return true;
        }
        const bool is_first =
            boundary_edge(ring, true).squared < boundary_edge(ring, false).squared;
        if (!see_end(ring, is_first ? 0 : ring.size)) {
            return false;
        }
        const Ring<Real>& end = work_.other_ring;
        return !end.one_phase || orientation<Real>(link_point(end, 0), {end.x0, end.y0},
                                                   link_point(end, end.size)) != 0;
    }

    // The star at the other end of an incident edge, in `other_ring`. False if it cannot be seen
    // from here.
    bool see_end(const Ring<Real>& ring, std::uint32_t incident_edge) {
        Ring<Real>& end = work_.other_ring;
        const bool gathered = gather(complex_, work_.submesh.region, ring.link[incident_edge], end);
        if (!end.owned) {
            work_.deferred.remeshing(ring.vertex);
            return false;
        }
        return gathered;
    }

    // True if the ring is stale; the vertices to be kept in the list have then been put there.
    bool keep_wall(std::uint32_t v, const Ring<Real>& ring) {
        const BoundaryLimits<Real> wall = wall_at(ring);
        if (may_collapse_on_wall(ring, wall) && collapse_on_wall(work_, ring, wall)) {
            return true;
        }
        if (ring.phase[0] == exterior_phase || !should_split_wall(ring, wall)) {
            return false;
        }
        const SplitResult result = split_wall(work_, ring);
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
    bool should_collapse(const Ring<Real>& ring, const IncidentEdges& incident) {
        if (thresholds_.coarsening == Coarsening::never || incident.count != 2 || !ring.closed ||
            is_corner(ring.vertex)) {
            return false;
        }
        const Point<Real> p(ring.x0, ring.y0);
        const Point<Real> a = link_point(ring, incident.first);
        const Point<Real> b = link_point(ring, incident.second);
        const Real nearest = std::min(squared_distance(p, a), squared_distance(p, b));
        const Real here = stretch(p);
        if (nearest >= here * shortest_squared_) {
            return false;
        }
        if (const Real merged = squared_distance(a, b);
            merged >= allowed(longest_squared(ring, incident), a, b) &&
            (merged >= here * bypass_squared_ || !is_ahead_of_end(ring, incident))) {
            return false;
        }
        if (nearest < here * degenerate_squared_ &&
            !turns_less<Real>(a, p, b, std::numbers::sqrt2_v<Real> / 2)) {
            return true;
        }
        return turns_less<Real>(a, p, b, Real(0)) &&
               (thresholds_.coarsening != Coarsening::deviation ||
                squared_deviation(ring, incident) < here * deviation_squared_);
    }

    // Whether the nearer neighbour is an end of the curve: a junction, or on the domain boundary.
    // If such an end moves along the curve, the centre is in its way and has to go, even if the
    // merged edge is then so long that it is split again.
    bool is_ahead_of_end(const Ring<Real>& ring, const IncidentEdges& incident) {
        const Point<Real> p(ring.x0, ring.y0);
        const bool is_first = squared_distance(p, link_point(ring, incident.first)) <
                              squared_distance(p, link_point(ring, incident.second));
        if (!see_end(ring, is_first ? incident.first : incident.second)) {
            return false;
        }
        const Ring<Real>& end = work_.other_ring;
        return !end.closed || interface_edges_of(end).count != 2;
    }

    // Squared distance of the centre from the curve without it; 0 if only another submesh sees it.
    Real squared_deviation(const Ring<Real>& ring, const IncidentEdges& incident) {
        const Point<Real> p(ring.x0, ring.y0);
        CurveNeighbours<Real> curve;
        curve.p1 = link_point(ring, incident.first);
        curve.p2 = link_point(ring, incident.second);
        const Point<Real> chord = curve.p2 - curve.p1;
        if (thresholds_.reading == Reading::chords) {
            const Point<Real> offset = p - curve.p1;
            const Real area = cross<Real>(chord, offset);
            return area * area / chord.squaredNorm();
        }
        // The cubic over the gap, at the share of the chord length at which the centre was.
        const Real before = (p - curve.p1).norm();
        const Real share = before / (before + (curve.p2 - p).norm());
        if (!see_past(ring, incident.first, curve.p0, curve.has_first) ||
            !see_past(ring, incident.second, curve.p3, curve.has_last)) {
            return 0;
        }
        const Point<Real> off = p - curve_point(curve, share);
        const Real across = cross<Real>(chord, off);
        return across * across / chord.squaredNorm();
    }

    // The vertex that follows the one at the end of an incident edge, away from the centre. False
    // if only another submesh can see its star.
    bool see_past(const Ring<Real>& ring, std::uint32_t incident_edge, Point<Real>& next,
                  bool& has_next) {
        Ring<Real>& beyond = work_.other_ring;
        if (!gather(complex_, work_.submesh.region, ring.link[incident_edge], beyond)) {
            return beyond.owned;
        }
        CurveNeighbours<Real> on;
        on.p1 = {ring.x0, ring.y0};
        on.p2 = link_point(ring, incident_edge);
        see_from_beyond(complex_, beyond, ring.vertex, on);
        next = on.p3;
        has_next = on.has_last;
        return true;
    }

    bool try_collapse(Ring<Real>& ring, const IncidentEdges& incident) {
        const Point<Real> p(ring.x0, ring.y0);
        const Real to_a = (link_point(ring, incident.first) - p).squaredNorm();
        const Real to_b = (link_point(ring, incident.second) - p).squaredNorm();
        const std::uint32_t nearer = to_a < to_b ? incident.first : incident.second;
        for (const std::uint32_t i : {nearer, incident.other(nearer)}) {
            if (collapse_centre(work_, ring, prev(ring.corner[i]), rewire::Vanishing::next) ==
                Verdict::legal) {
                return true;
            }
        }
        return false;
    }

    // --- refinement ---------------------------------------------------------------------------
    // How long an interface edge at the centre may be, squared, as the shape there requires.
    Real longest_squared(const Ring<Real>& ring, const IncidentEdges& incident) const {
        if (!follows_shape_ || incident.count != 2) {
            return longest_squared_;
        }
        Real longest = longest_squared_;
        // The angle at which a curve meets the domain boundary is not a bend of the curve.
        if (turn_squared_ > 0 && ring.closed && !is_corner(ring.vertex)) {
            const Real bend = curvature<Real>(link_point(ring, incident.first), {ring.x0, ring.y0},
                                              link_point(ring, incident.second));
            longest = std::min(longest, turn_squared_ / (bend * bend));
        }
        if (gap_squared_ > 0) {
            longest = std::min(longest, gap_squared_ * squared_gap(complex_, ring, incident));
        }
        return std::max(longest, finest_squared_);
    }

    // The interface edge to be split; no_id if there is none. An edge longer than the general limit
    // is found only from the end that has the larger phase on its left, so that each edge is found
    // once. An edge too long for the shape at the centre is found from there.
    std::uint32_t long_edge(const Ring<Real>& ring, const IncidentEdges& incident) const {
        const Point<Real> p(ring.x0, ring.y0);
        const Real local = longest_squared(ring, incident);
        std::uint32_t found = no_id;
        Real longest = 0;
        const auto look_at = [&](std::uint32_t i) {
            const Phase before = ring.phase_before(i);
            const Phase after = ring.phase_after(i);
            if (before == after || before == border_phase || after == border_phase) {
                return;
            }
            const Real squared = squared_distance(p, link_point(ring, i));
            const bool is_found_here = after > before || local < longest_squared_;
            if (is_found_here && squared > allowed(local, p, link_point(ring, i)) &&
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
        for (std::uint32_t i = 0; i < ring.link_size(); ++i) {
            look_at(i);
        }
        return found;
    }

    // Splits at most one edge, because the ring is stale then; the other edges of a junction wait
    // for the next step. True if it has.
    bool refine(std::uint32_t v, Ring<Real>& ring, const IncidentEdges& incident) {
        newest_ = no_id;
        if (const std::uint32_t i = long_edge(ring, incident);
            i != no_id && !split(v, ring, incident, i)) {
            work_.deferred.remeshing(v);
        }
        work_.interface_next.push_back(v);
        if (newest_ != no_id) {
            work_.interface_next.push_back(newest_);
        }
        return newest_ != no_id;
    }

    bool split(std::uint32_t v, const Ring<Real>& ring, const IncidentEdges& incident,
               std::uint32_t i) {
        CurveNeighbours<Real> curve;
        see_from_centre(complex_, ring, incident, i, curve);
        Ring<Real>& beyond = work_.other_ring;
        const bool gathered = gather(complex_, work_.submesh.region, ring.link[i], beyond);
        if (!beyond.owned) {
            return false;
        }
        if (gathered) {
            see_from_beyond(complex_, beyond, v, curve);
        }
        const auto& options = work_.options;
        Point<Real> point = options.insertion_function ? options.insertion_function(curve)
                                                       : insertion_point(options.insertion, curve);
        if (!owns_point(point)) {
            point = midpoint<Real>(curve.p1, curve.p2);
            if (!owns_point(point)) {
                return false;
            }
        }
        const Corner corner = prev(ring.corner[i]);
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
        }
        return true;
    }

    // A new vertex must lie in the submesh that makes it: the next colour looks for it there.
    bool owns_point(const Point<Real>& point) const {
        return owns_place(work_.submesh.region, point);
    }

    bool is_corner(std::uint32_t v) const {
        return (complex_.vertices[v].flags & vertex_corner) != 0;
    }

    Work<Real>& work_;
    Complex<Real>& complex_;
    const InterfaceThresholds& thresholds_;
    Real longest_squared_;
    Real shortest_squared_;
    Real bypass_squared_; // of an edge that is merged to let an end of the curve pass
    Real deviation_squared_;
    Real degenerate_squared_;
    Real finest_squared_;
    Real turn_squared_;
    Real gap_squared_;
    SizeRule<Real> sizes_;
    bool follows_shape_;
    BoundaryLimits<Real> wall_;
    std::uint32_t newest_ = no_id;
};

} // namespace

template <class Real>
void remesh_interface(Work<Real>& work) {
    Remeshing<Real>(work).run();
}

template void remesh_interface(Work<double>&);
template void remesh_interface(Work<float>&);

} // namespace dsc
