// SPDX-License-Identifier: MIT
#include "topology/junctions/opening.h"

#include "dsc/base/verdict.h"
#include "dsc/geometry/points.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "topology/fronts/front_curve.h"

#include <limits>

namespace dsc {

namespace {

template <class Real>
class SectorOpening {
public:
    SectorOpening(Complex<Real>& complex, Vertex v, const Sector<Real>& sector)
        : complex_(complex), submesh_(complex), v_(v), phase_(sector.phase),
          place_(complex.position(v)) {
        Corner c = sector.first;
        link_.push_back(complex.vertex(next(c)));
        for (std::size_t i = 0; i < sector.count; ++i) {
            link_.push_back(complex.vertex(prev(c)));
            c = corner_ccw(complex, c);
        }
    }

    Corner inside(const Sector<Real>& sector, Real length) {
        if (link_.size() == 2 && !split_far_edge(sector.first)) {
            return no_id;
        }
        const std::size_t i = middle_edge(sector);
        if (i == 0) {
            return no_id;
        }
        const Point<Real> way = way_to(i).normalized();
        const Point<Real> point = place_ + way * std::min(length, room(way) / 2);
        if (edge_split(submesh_, prev(corner_to(link_[i])), point).verdict != Verdict::legal) {
            return no_id;
        }
        for (std::size_t j = i - 1; j > 0; --j) {
            if (!flip_incident_edge(j)) {
                return no_id;
            }
        }
        for (std::size_t j = i + 1; j + 1 < link_.size(); ++j) {
            if (!flip_incident_edge(j)) {
                return no_id;
            }
        }
        return corner_to(link_.front());
    }

    Corner on_boundary(bool is_first, Real length) {
        const std::size_t last = link_.size() - 1;
        const Point<Real> way = way_to(is_first ? 0 : last);
        const Real way_length = way.norm();
        const Real share = std::min(length, room(Point<Real>(way / way_length)) / 2) / way_length;
        const Corner edge = is_first ? prev(corner_to(link_[0])) : next(corner_to(link_[last - 1]));
        std::uint32_t made = no_id;
        for (const Real factor : {share, std::min(share, Real(0.5)), std::min(share, Real(0.25))}) {
            const SplitResult result =
                edge_split(submesh_, edge, Point<Real>(place_ + factor * way));
            if (result.verdict == Verdict::legal) {
                made = result.vertex.id;
                break;
            }
        }
        if (made == no_id) {
            return no_id;
        }
        for (std::size_t step = 1; step < last; ++step) {
            if (!flip_incident_edge(is_first ? step : last - step)) {
                return no_id;
            }
        }
        return corner_to(is_first ? made : link_[0]);
    }

private:
    Point<Real> way_to(std::size_t i) const { return complex_.position(Vertex{link_[i]}) - place_; }

    // The corner at v of the triangle that begins with the incident edge to `end`.
    Corner corner_to(std::uint32_t end) const {
        return find_corner(complex_, v_, [&](Corner c) {
            return complex_.vertex(next(c)) == end && complex_.phase_at(c) == phase_;
        });
    }

    bool split_far_edge(Corner c) {
        const Point<Real> a = complex_.position(Vertex{link_[0]});
        const Point<Real> b = complex_.position(Vertex{link_[1]});
        const Point<Real> middle = (a + b) / Real(2);
        const SplitResult result = edge_split(submesh_, c, middle);
        if (result.verdict != Verdict::legal) {
            return false;
        }
        link_.insert(link_.begin() + 1, result.vertex.id);
        return true;
    }

    // The incident edge nearest to the middle of the sector, less than 180 degrees from both its
    // ends; 0 if there is none.
    std::size_t middle_edge(const Sector<Real>& sector) const {
        const Point<Real> middle = middle_of(sector);
        std::size_t best = 0;
        Real nearest = -2;
        for (std::size_t i = 1; i + 1 < link_.size(); ++i) {
            const Point<Real> way = way_to(i);
            const Real cosine = middle.dot(way) / way.norm();
            if (cosine > nearest && cross<Real>(way_to(0), way) > 0 &&
                cross<Real>(way, way_to(link_.size() - 1)) > 0) {
                nearest = cosine;
                best = i;
            }
        }
        return best;
    }

    // The largest distance in this unit direction at which all edges of the link are still on the
    // left.
    Real room(const Point<Real>& way) const {
        Real smallest = std::numeric_limits<Real>::max();
        for (std::size_t i = 0; i + 1 < link_.size(); ++i) {
            const Point<Real> from = way_to(i);
            const Point<Real> edge = way_to(i + 1) - from;
            const Real rate = cross<Real>(way, edge);
            if (rate > 0) {
                smallest = std::min(smallest, cross<Real>(from, edge) / rate);
            }
        }
        return smallest;
    }

    // The other end of the edge becomes the new vertex.
    bool flip_incident_edge(std::size_t i) {
        const Corner c = corner_to(link_[i]);
        return c != no_id && edge_flip(submesh_, prev(c)) == Verdict::legal;
    }

    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    Vertex v_;
    Phase phase_;
    Point<Real> place_;
    std::vector<std::uint32_t> link_; ///< of the sector, counter-clockwise
};

} // namespace

template <class Real>
Corner open_inside(Complex<Real>& complex, Vertex v, const Sector<Real>& sector, Real length) {
    return SectorOpening<Real>(complex, v, sector).inside(sector, length);
}

template <class Real>
Corner open_on_boundary(Complex<Real>& complex, Vertex v, const Sector<Real>& sector, bool is_first,
                        Real length) {
    return SectorOpening<Real>(complex, v, sector).on_boundary(is_first, length);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Corner open_inside(Complex<Real>&, Vertex, const Sector<Real>&, Real);                \
    template Corner open_on_boundary(Complex<Real>&, Vertex, const Sector<Real>&, bool, Real);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
