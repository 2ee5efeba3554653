// SPDX-License-Identifier: MIT
#include "topology/films/film_region.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/phases.h"
#include "topology/films/film_ray.h"
#include "topology/fronts/arrival.h"
#include "topology/fronts/division.h"
#include "topology/fronts/front_point.h"
#include "topology/junctions/merging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

namespace dsc {

namespace {

constexpr int smoothing_rounds = 4;
/// A vertex is not moved if the height of a triangle over its longest edge (at most 0.87) would
/// fall below this, unless that is better than before.
constexpr double straightened_height = 0.2;
/// A pocket shares more of its outline than this with the region about it. The phase beyond a neck
/// shares less.
constexpr double pocket_share = 1.0 / 3;
/// Longest edges in a film, in edge lengths: those of uniform sizes, by `PhaseThresholds::longest`.
constexpr double longest_in_film = 1.6;

// The longest edge of the triangles on the ray that is not on the interface; no_id if it is short
// enough.
template <class Real>
Corner longest_on_ray(const TopologyWork<Real>& work, Corner sheet, Real contact) {
    Corner found = no_id;
    Real longest = static_cast<Real>(longest_in_film) * work.edge_length;
    (void)cross_film(work.complex, sheet, contact, [&](Triangle t, Real, Real) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            const Real length = direction(work.complex, c).norm();
            if (length > longest && !is_sheet(work.complex, c)) {
                longest = length;
                found = c;
            }
        }
    });
    return found;
}

} // namespace

template <class Real>
bool refine_film(TopologyWork<Real>& work, const std::array<Vertex, 2>& sheet, Real contact) {
    constexpr int max_splits = 16;
    Complex<Real>& complex = work.complex;
    for (int splits = 0; splits < max_splits; ++splits) {
        const Corner edge =
            longest_on_ray(work, complex.find_half_edge(sheet[0], sheet[1]), contact);
        if (edge == no_id) {
            return splits > 0;
        }
        const Point<Real> from = complex.position(Vertex{complex.vertex(next(edge))});
        const Point<Real> to = complex.position(Vertex{complex.vertex(prev(edge))});
        const Point<Real> middle = (from + to) / Real(2);
        if (edge_split(Submesh(complex), edge, middle).verdict != Verdict::legal) {
            return splits > 0;
        }
    }
    return true;
}

template <class Real>
void FilmRegion<Real>::offer(Triangle t, Phase to, Real distance) {
    const auto [at, is_new] = entries_.try_emplace(t.id, Entry{to, distance});
    if (is_new) {
        order_.push_back(t);
    } else if (distance < at->second.distance ||
               (distance == at->second.distance && to < at->second.to)) {
        at->second = {to, distance};
    }
}

template <class Real>
void FilmRegion<Real>::add_ray(Corner sheet) {
    struct Crossed {
        Triangle t;
        Real middle;
    };
    const Complex<Real>& complex = work_.complex;
    std::vector<Crossed> crossed;
    const FilmRay<Real> ray =
        cross_film(complex, sheet, contact_, [&](Triangle t, Real from, Real to) {
            crossed.push_back({t, (from + to) / 2});
        });
    if (ray.opposite == no_id && ray.boundary == no_id) {
        return;
    }
    const Phase one = complex.phase_at(complex.twin(sheet));
    const Phase other = ray.boundary == no_id ? complex.phase_at(complex.twin(ray.opposite)) : one;
    for (const auto& [t, middle] : crossed) {
        offer(t, one, middle);
        offer(t, other, ray.thickness - middle);
    }
}

template <class Real>
void FilmRegion<Real>::fill(const std::function<bool(Triangle, Phase)>& may_take) {
    const Complex<Real>& complex = work_.complex;
    // Fronts of several phases may be beside the film.
    const auto take = [&](Triangle t, Phase to) {
        Real longest = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Corner side = corner_of(t.id, k);
            const Phase beyond = phase_beyond(complex, side);
            const Real length = direction(complex, side).squaredNorm();
            if (beyond != film_ && beyond != border_phase && length > longest &&
                may_take(t, beyond)) {
                longest = length;
                to = beyond;
            }
        }
        offer(t, to, std::numeric_limits<Real>::infinity());
    };
    for (std::size_t i = 0; i < order_.size(); ++i) { // it grows
        const Phase to = entries_.at(order_[i].id).to;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Triangle t{triangle_of(complex.twin(corner_of(order_[i].id, k)))};
            if (!is_rest(t)) {
                continue;
            }
            int closed = 0;
            for (std::uint32_t side = 0; side < 3; ++side) {
                closed +=
                    contains(Triangle{triangle_of(complex.twin(corner_of(t.id, side)))}) ? 1 : 0;
            }
            if (closed > 1) {
                take(t, to);
            } else if (is_small_piece(t)) {
                for (const Triangle small : piece_) {
                    take(small, to);
                }
            }
        }
    }
}

// A thin triangle between the region and a sheet is the point of a notch.
template <class Real>
void FilmRegion<Real>::fill_notches() {
    const Complex<Real>& complex = work_.complex;
    for (const Triangle inside : std::vector(order_)) {
        const Phase to = entries_.at(inside.id).to;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Triangle t{triangle_of(complex.twin(corner_of(inside.id, k)))};
            if (!is_rest(t) || thickness(complex, t) >= within_triangles(work_, contact_)) {
                continue;
            }
            int closed = 0;
            for (std::uint32_t side = 0; side < 3; ++side) {
                const Triangle beside{triangle_of(complex.twin(corner_of(t.id, side)))};
                closed += beside.id != border_triangle && phase_later(beside) == to ? 1 : 0;
            }
            if (closed > 1) {
                offer(t, to, std::numeric_limits<Real>::infinity());
            }
        }
    }
}

// Whether the triangle belongs to the film, but not to the region.
template <class Real>
bool FilmRegion<Real>::is_rest(Triangle t) const {
    return t.id != border_triangle && work_.complex.phase(t) == film_ && !contains(t);
}

// Whether the piece that the region leaves here is too small to stay: below the smallest area, or a
// pocket between rays that is thinner than the contact distance. Then `piece_` holds it.
template <class Real>
bool FilmRegion<Real>::is_small_piece(Triangle start) {
    const Complex<Real>& complex = work_.complex;
    piece_.assign(1, start);
    Real doubled = 0;
    Real perimeter = 0;
    Real shared = 0; // with the region
    for (std::size_t i = 0; i < piece_.size(); ++i) {
        doubled += doubled_area(complex, piece_[i]);
        if (piece_.size() > max_share_of_piece) {
            return false;
        }
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Corner side = corner_of(piece_[i].id, k);
            const Triangle t{triangle_of(complex.twin(side))};
            if (!is_rest(t)) {
                const Real length = direction(complex, side).norm();
                perimeter += length;
                shared += contains(t) ? length : Real(0);
            } else if (std::ranges::find(piece_, t) == piece_.end()) {
                piece_.push_back(t);
            }
        }
    }
    // The diameter of a disc; twice the thickness of a strip.
    const Real width = 2 * doubled / perimeter;
    return doubled / 2 < min_area(work_) ||
           (width < contact_ && shared > static_cast<Real>(pocket_share) * perimeter);
}

template <class Real>
Phase FilmRegion<Real>::phase_later(Triangle t) const {
    const auto at = entries_.find(t.id);
    return at != entries_.end() ? at->second.to : work_.complex.phase(t);
}

template <class Real>
std::vector<Vertex> FilmRegion<Real>::vertices() const {
    std::vector<Vertex> list;
    std::unordered_set<std::uint32_t> listed;
    for (const Triangle t : order_) {
        for (const Vertex v : work_.complex.vertices_of(t)) {
            if (listed.insert(v.id).second) {
                list.push_back(v);
            }
        }
    }
    return list;
}

template <class Real>
void FilmRegion<Real>::smooth() {
    const std::vector<Vertex> list = vertices();
    for (int round = 0; round < smoothing_rounds; ++round) {
        std::ranges::for_each(list, [&](Vertex v) { straighten(v); });
    }
}

// Moves the vertex to the middle between its two neighbours on the future interface.
template <class Real>
void FilmRegion<Real>::straighten(Vertex v) {
    Complex<Real>& complex = work_.complex;
    int neighbours = 0;
    bool is_inside = !complex.is_locked(v);
    Point<Real> sum(0, 0);
    for_each_corner(complex, v, [&](Corner c) {
        const Corner before = complex.twin(prev(c));
        is_inside = is_inside && !is_border(before) && complex.phase_at(c) == film_;
        if (is_inside &&
            phase_later(Triangle{triangle_of(before)}) != phase_later(Triangle{triangle_of(c)})) {
            ++neighbours;
            sum += complex.position(Vertex{complex.vertex(next(c))});
        }
    });
    if (!is_inside || neighbours != 2) {
        return;
    }
    const Point<Real> place = sum / Real(2);
    const Real height = worst_height(complex, v, place);
    if (height > 0 && (height >= static_cast<Real>(straightened_height) ||
                       height > worst_height(complex, v, complex.position(v)))) {
        rewire::move(complex, complex.journal, v.id, place.x(), place.y(), MoveReason::smoothing);
    }
}

template <class Real>
bool FilmRegion<Real>::divide(const std::function<bool(Triangle, Phase)>& may_take) {
    if (!is_displaced(work_, film_)) {
        return false;
    }
    std::vector<Phase> takers = this->takers();
    for (const Triangle t : order_) {
        for (std::uint32_t k = 0; k < 3; ++k) { // a front beside the film, without a ray
            const Corner side = corner_of(t.id, k);
            const Phase beyond = phase_beyond(work_.complex, side);
            if (is_sheet(work_.complex, side) &&
                std::ranges::find(takers, beyond) == takers.end() && may_take(t, beyond)) {
                takers.push_back(beyond);
            }
        }
    }
    std::ranges::sort(takers);
    if (takers.size() < 2) {
        return false;
    }
    const std::vector<Share> shares = divide_by_arrival<Real>(work_, order_, takers);
    const bool is_split = shares.size() > order_.size();
    entries_.clear();
    order_.clear();
    for (const Share& share : shares) {
        offer(share.triangle, share.to, Real(0));
    }
    return is_split;
}

template <class Real>
std::vector<Phase> FilmRegion<Real>::takers() const {
    std::vector<Phase> takers;
    for (const Triangle t : order_) {
        takers.push_back(entries_.at(t.id).to);
    }
    std::ranges::sort(takers);
    takers.erase(std::unique(takers.begin(), takers.end()), takers.end());
    return takers;
}

template <class Real>
double FilmRegion<Real>::area_of(Phase taker) const {
    double area = 0;
    for (const Triangle t : order_) {
        if (entries_.at(t.id).to == taker) {
            area += static_cast<double>(doubled_area(work_.complex, t)) / 2;
        }
    }
    return area;
}

template <class Real>
double FilmRegion<Real>::give_all() {
    const std::vector<Waiting> waiting = find_waiting();
    double area = 0;
    for (const Triangle t : order_) {
        area += static_cast<double>(doubled_area(work_.complex, t)) / 2;
        give(work_, t, entries_.at(t.id).to);
    }
    for (const Vertex v : vertices()) {
        work_.notes[v].what |= noted_seam; // the seam may extend from here
        if (!is_interface(work_.complex, v)) {
            work_.ahead[v] = {};
        }
    }
    for (const Waiting& one : waiting) {
        if (is_interface(work_.complex, one.vertex)) {
            put_ahead(work_, one.vertex.id, one.shares, one.speed);
        }
    }
    return area;
}

// The vertices that only the change may put on the interface: fronts reach them later. Nothing
// waits at a wide contact distance: with it the application asks for a contact before fronts
// arrive.
template <class Real>
auto FilmRegion<Real>::find_waiting() const -> std::vector<Waiting> {
    std::vector<Waiting> waiting;
    if (!is_displaced(work_, film_) || is_wide(contact_, work_.edge_length)) {
        return waiting;
    }
    const Arrival<Real> fronts(work_, order_);
    const Real speed = fronts.mean_speed();
    for (const Triangle t : order_) {
        for (const Vertex v : work_.complex.vertices_of(t)) {
            const bool comes_later = speed > 0 && !is_interface(work_.complex, v);
            const Real way = comes_later
                                 ? fronts.way_of(entries_.at(t.id).to, work_.complex.position(v))
                                 : std::numeric_limits<Real>::infinity();
            if (std::isfinite(way)) {
                waiting.push_back({v, way / speed, speed});
            }
        }
    }
    return waiting;
}

template bool refine_film(TopologyWork<double>&, const std::array<Vertex, 2>&, double);
template bool refine_film(TopologyWork<float>&, const std::array<Vertex, 2>&, float);
template class FilmRegion<double>;
template class FilmRegion<float>;

} // namespace dsc
