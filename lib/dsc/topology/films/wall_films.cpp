// SPDX-License-Identifier: MIT
#include "dsc/topology/films/wall_films.h"

#include "dsc/complex/submesh.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_split.h"
#include "dsc/topology/films/bridge.h"
#include "dsc/topology/films/film_ray.h"
#include "dsc/topology/films/film_region.h"
#include "dsc/topology/junctions/merging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace dsc {

namespace {

/// Up to this many contact distances, and an edge, along a curve a film is the wedge at its end.
constexpr double beside_end = 1.5;
/// Up to this many, it is a part of the film that has opened there.
constexpr double same_film = 12;
/// A vertex lands on the wall from below this height, in edge lengths.
constexpr double landing_height = 0.15;
/// It lands on a vertex of the wall that is nearer than this share of the edge there.
constexpr double landing_share = 0.25;

/// An interface edge near the wall, with the film on its left.
template <class Real>
struct WallChord {
    Corner sheet;
    FilmRay<Real> ray;
    bool is_first = true; ///< none of the chords leads to it along the outline
};

template <class Real>
class WallFilms {
public:
    WallFilms(TopologyWork<Real>& work, std::span<const Suspect<Real>> suspects)
        : work_(work), complex_(work.complex), suspects_(suspects) {}

    void run() {
        for (std::size_t i = 0; i < suspects_.size(); ++i) {
            complex_.vertices[suspects_[i].vertex].slot = static_cast<std::uint32_t>(i);
        }
        find_chords();
        for (const bool starts : {true, false}) { // those left over go round
            for (std::size_t i = 0; i < chords_.size(); ++i) {
                if (chords_[i].is_first == starts && index_.contains(chords_[i].sheet)) {
                    visit_run(i);
                }
            }
        }
        land();
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    [[nodiscard]] bool is_on_wall(std::uint32_t v) const {
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   return is_border(complex_.twin(next(c))) || is_border(complex_.twin(prev(c)));
               }) != no_id;
    }

    // --- films ----------------------------------------------------------------------------------
    // In the order of their places. Nearly always there are none, and nothing is allocated.
    void find_chords() {
        for (const auto& suspect : suspects_) {
            if (!complex_.is_alive(Vertex{suspect.vertex})) {
                continue;
            }
            for_each_corner(complex_, Vertex{suspect.vertex}, [&](Corner c) {
                const Corner leaves = prev(c); // the half-edge that starts at the vertex
                const Corner across = complex_.twin(leaves);
                if (is_border(across) || !is_sheet(complex_, leaves)) {
                    return;
                }
                add_chord(leaves);
                if (!is_suspect(complex_.vertex(next(c)))) { // else it adds its own
                    add_chord(across);
                }
            });
        }
        std::ranges::sort(chords_, {}, [this](const WallChord<Real>& chord) {
            const Point<Real> place = centroid(complex_, Triangle{triangle_of(chord.sheet)});
            return std::tuple(place.x(), place.y(), chord.sheet);
        });
        for (std::size_t i = 0; i < chords_.size(); ++i) {
            index_.emplace(chords_[i].sheet, i);
        }
        for (const auto& chord : chords_) {
            const auto following = index_.find(along_outline(complex_, chord.sheet));
            if (following != index_.end()) {
                chords_[following->second].is_first = false;
            }
        }
    }

    void add_chord(Corner sheet) {
        if (const FilmRay<Real> ray = ray_of(sheet); ray.wall != no_id) {
            chords_.push_back({sheet, ray});
        }
    }

    [[nodiscard]] bool is_suspect(std::uint32_t v) const {
        const std::uint32_t slot = complex_.vertices[v].slot;
        return slot < suspects_.size() && suspects_[slot].vertex == v;
    }

    // To the wall, if that is within the contact distance.
    [[nodiscard]] FilmRay<Real> ray_of(Corner sheet) const {
        const Real contact = contact_of(sheet);
        if (!(contact > 0)) {
            return {};
        }
        const FilmRay<Real> ray = cross_film(complex_, sheet, contact, [](Triangle, Real, Real) {});
        return ray.wall != no_id && faces(complex_, sheet, ray.wall) ? ray : FilmRay<Real>{};
    }

    [[nodiscard]] Real contact_of(Corner sheet) const {
        const auto rule = rule_of(work_.options, work_.edge_length, complex_.phase_at(sheet),
                                  complex_.phase_at(complex_.twin(sheet)));
        return rule.rule == Topology::change ? rule.contact : Real(0);
    }

    // Successive chords. If the curve ends on the wall nearby, they are the wedge there.
    void visit_run(std::size_t first) {
        std::vector<WallChord<Real>> run;
        for (auto at = index_.find(chords_[first].sheet); at != index_.end();) {
            const WallChord<Real>& chord = chords_[at->second];
            index_.erase(at);
            if (!is_sheet(complex_, chord.sheet)) {
                break; // another film has opened here
            }
            run.push_back(chord);
            at = index_.find(along_outline(complex_, chord.sheet));
        }
        if (run.empty()) {
            return;
        }
        const Real contact = contact_of(run.front().sheet);
        const Real nearest = contact > 0
                                 ? std::min(way_to_end(run.back().sheet, contact),
                                            way_to_end(complex_.twin(run.front().sheet), contact))
                                 : Real(0);
        const Real near = static_cast<Real>(beside_end) * contact + work_.edge_length;
        // Held up for good, or at once where that is far from the ends: no vertex lands there.
        const auto is_pressed = [&](const WallChord<Real>& chord) {
            const Corner c = chord.sheet;
            return is_stuck(c) ||
                   (is_held_up(complex_.vertex(next(c))) && is_held_up(complex_.vertex(prev(c))) &&
                    std::min(way_to_end(c, contact), way_to_end(complex_.twin(c), contact)) >=
                        near);
        };
        if (!(contact > 0) || (nearest < near && std::ranges::none_of(run, is_pressed))) {
            return;
        }
        const EventKind kind = std::isfinite(nearest) ? EventKind::widen : EventKind::meet;
        // The outline of the film goes on across junctions: each phase beyond it is asked for, and
        // told of, by itself.
        for (auto from = run.begin(); from != run.end();) {
            const auto to = std::find_if(from, run.end(), [&](const auto& chord) {
                return taker_at(chord.sheet) != taker_at(from->sheet);
            });
            open_part({from, to}, kind);
            from = to;
        }
    }

    [[nodiscard]] Phase taker_at(Corner sheet) const {
        return complex_.phase_at(complex_.twin(sheet));
    }

    // Successive chords with one phase beyond them.
    void open_part(std::vector<WallChord<Real>> part, EventKind kind) {
        // What opened before it may have taken some of the edges, or the film.
        std::erase_if(part, [&](WallChord<Real>& chord) {
            if (!is_sheet(complex_, chord.sheet) || is_border(complex_.twin(chord.sheet))) {
                return true;
            }
            chord.ray = ray_of(chord.sheet);
            return chord.ray.wall == no_id ||
                   (work_.options.opening == Opening::squeezed && !is_squeezed_to_wall(chord));
        });
        if (!part.empty()) {
            open(part, kind);
        }
    }

    // Held up for good, at both ends.
    [[nodiscard]] bool is_stuck(Corner sheet) const {
        const auto is_end_stuck = [&](Corner c) {
            return (complex_.vertices[complex_.vertex(c)].flags & vertex_contact) == vertex_contact;
        };
        return is_end_stuck(next(sheet)) && is_end_stuck(prev(sheet));
    }

    // From the end of the half-edge along the curve to where that ends on the wall, if that is near
    // enough to matter; 0 where it ends itself, or is of the interface no longer.
    [[nodiscard]] Real way_to_end(Corner sheet, Real contact) const {
        if (!is_sheet(complex_, sheet)) {
            return 0;
        }
        Real length = 0;
        Corner c = along_outline(complex_, sheet);
        while (!is_border(complex_.twin(c))) {
            length += direction(complex_, c).norm();
            if (length > static_cast<Real>(same_film) * contact) {
                return std::numeric_limits<Real>::infinity();
            }
            c = along_outline(complex_, c);
        }
        return length;
    }

    // As between two sheets, of which the second one is the image of the first on the wall.
    [[nodiscard]] bool is_squeezed_to_wall(const WallChord<Real>& chord) const {
        const Point<Real> foot = at(complex_.vertex(next(chord.ray.wall)));
        const Point<Real> along = direction(complex_, chord.ray.wall).normalized();
        std::array<Point<Real>, 4> now;
        std::array<Point<Real>, 4> then;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t v = complex_.vertex(i == 0 ? next(chord.sheet) : prev(chord.sheet));
            const auto& record = complex_.vertices[v];
            if ((record.flags & vertex_contact) != 0) {
                return true; // the wall holds it up, if only for the first time
            }
            if (record.slot >= suspects_.size() || suspects_[record.slot].vertex != v) {
                return false;
            }
            const auto of_wall = [&](const Point<Real>& p) {
                const Point<Real> from = p - foot;
                return Point<Real>(-along.dot(from), -cross<Real>(along, from));
            };
            now[i] = of_wall({record.x, record.y});
            then[i] = of_wall({suspects_[record.slot].x, suspects_[record.slot].y});
            now[3 - i] = {now[i].x(), 0};
            then[3 - i] = {then[i].x(), 0};
        }
        return is_squeezed(then, now);
    }

    [[nodiscard]] bool may_open(const Contact& contact) const {
        return !work_.options.may_change || work_.options.may_change(contact);
    }

    void open(const std::vector<WallChord<Real>>& run, EventKind kind) {
        const auto& thinnest = *std::ranges::min_element(
            run, {}, [](const WallChord<Real>& chord) { return chord.ray.thickness; });
        const Phase film = complex_.phase_at(thinnest.sheet);
        const Phase taker = taker_at(thinnest.sheet);
        const auto x = static_cast<double>(thinnest.ray.middle.x());
        const auto y = static_cast<double>(thinnest.ray.middle.y());
        if (!may_open({.film = film,
                       .sides = {taker, border_phase},
                       .x = x,
                       .y = y,
                       .thickness = static_cast<double>(thinnest.ray.thickness)})) {
            return;
        }
        FilmRegion<Real> region(work_, film, contact_of(thinnest.sheet));
        for (const WallChord<Real>& chord : run) {
            region.add_ray(chord.sheet);
        }
        region.fill();
        region.smooth();
        work_.events.push_back({.kind = kind,
                                .time = work_.time,
                                .x = x,
                                .y = y,
                                .lost = film,
                                .taken = {taker, taker},
                                .area = region.give_all()});
    }

    // --- ends of curves -------------------------------------------------------------------------
    void land() {
        std::vector<std::tuple<Real, Real, std::uint32_t>> found;
        const auto take = [&](std::uint32_t v) {
            if (is_held_up(v)) {
                found.emplace_back(at(v).x(), at(v).y(), v);
            }
        };
        for (const auto& suspect : suspects_) {
            const Vertex v{suspect.vertex};
            take(v.id);
            if (complex_.is_alive(v) && is_on_wall(v.id)) { // perhaps the end of a curve
                for_each_corner(complex_, v, [&](Corner c) {
                    if (is_outline(complex_, prev(c))) {
                        take(complex_.vertex(next(c)));
                    }
                });
            }
        }
        std::ranges::sort(found);
        for (const auto& one : found) {
            std::uint32_t v = std::get<2>(one);
            while (v != no_id && is_held_up(v)) {
                v = land(v);
            }
        }
    }

    // The targets that were missed are known by id: none may be used again before they are tried.
    void retire(std::uint32_t v) {
        auto& free = submesh_.pool->vertices;
        if (const auto at = std::find(free.rbegin(), free.rend(), v); at != free.rend()) {
            work_.retired.push_back(v);
            free.erase(std::next(at).base());
        }
    }

    [[nodiscard]] bool is_held_up(std::uint32_t v) const {
        const std::uint32_t its = complex_.is_alive(Vertex{v}) ? complex_.vertices[v].flags : 0;
        return (its & vertex_contact) != 0 && (its & vertex_locked) == 0;
    }

    // Returns the next vertex of the curve, if this one has landed.
    std::uint32_t land(std::uint32_t v) {
        std::vector<std::tuple<Real, Real, Real, std::uint32_t>> neighbours;
        Corner curve = no_id;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            if (is_outline(complex_, prev(c))) {
                curve = prev(c);
                const std::uint32_t w = complex_.vertex(next(c));
                neighbours.emplace_back((at(w) - at(v)).squaredNorm(), at(w).x(), at(w).y(), w);
            }
        });
        if (neighbours.size() != 2 || is_on_wall(v) || !(contact_of(curve) > 0)) {
            return no_id;
        }
        std::ranges::sort(neighbours); // the nearer one first
        for (const std::size_t i : {0U, 1U}) {
            const std::uint32_t end = std::get<3>(neighbours[i]);
            if (is_on_wall(end) && land_beside(v, end)) {
                return std::get<3>(neighbours[1 - i]);
            }
        }
        return no_id;
    }

    // Of the edges of the wall at the end of a curve, the one above which the vertex is.
    struct Below {
        Corner edge = no_id; ///< the corner at the vertex
        std::uint32_t other = no_id;
        Real share = 0; ///< of the way along it
    };
    [[nodiscard]] Below find_below(std::uint32_t v, std::uint32_t end) const {
        Below found;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            const bool is_first = complex_.vertex(next(c)) == end;
            if (!is_border(complex_.twin(c)) || !(is_first || complex_.vertex(prev(c)) == end)) {
                return;
            }
            const std::uint32_t other = complex_.vertex(is_first ? prev(c) : next(c));
            const Point<Real> way = at(other) - at(end);
            const Point<Real> from = at(v) - at(end);
            const Real share = from.dot(way) / way.squaredNorm();
            if (found.edge == no_id || share > found.share) {
                found = {c, other, share};
            }
        });
        return found;
    }

    // Above the wall that leaves the end of a curve towards the vertex.
    [[nodiscard]] Real height_of(std::uint32_t v, std::uint32_t end) const {
        Real lowest = std::numeric_limits<Real>::infinity();
        const Point<Real> from = at(v) - at(end);
        for_each_corner(complex_, Vertex{end}, [&](Corner c) {
            for (const Corner side : {next(c), prev(c)}) {
                const std::uint32_t other = complex_.vertex(side == next(c) ? prev(c) : next(c));
                const Point<Real> way = at(other) - at(end);
                if (is_border(complex_.twin(side)) && from.dot(way) > 0) {
                    lowest = std::min(lowest, std::abs(cross<Real>(way, from)) / way.norm());
                }
            }
        });
        return lowest;
    }

    bool land_beside(std::uint32_t v, std::uint32_t end) {
        const Below below = find_below(v, end);
        const Real height = height_of(v, end);
        if (!(height < static_cast<Real>(landing_height) * work_.edge_length)) {
            return false;
        }
        Event event{.kind = EventKind::widen,
                    .time = work_.time,
                    .x = static_cast<double>(at(v).x()),
                    .y = static_cast<double>(at(v).y())};
        std::uint32_t target = end;
        if (below.edge != no_id && below.share > static_cast<Real>(landing_share)) {
            // Across the edge from the vertex to the end of the curve.
            const Corner side =
                complex_.vertex(next(below.edge)) == end ? prev(below.edge) : next(below.edge);
            const Phase taker = complex_.phase_at(complex_.twin(side));
            event.lost = complex_.phase_at(below.edge);
            event.taken = {taker, taker};
            if (!may_open({.film = event.lost,
                           .sides = {taker, border_phase},
                           .x = event.x,
                           .y = event.y,
                           .thickness = static_cast<double>(height)})) {
                return false;
            }
            target = foot_of(below, end);
            event.area = give_wedge(v, end, target, taker);
        }
        const bool has_landed = merge_ends(work_, Vertex{v}, Vertex{target}, false).is_valid();
        if (has_landed) {
            retire(v);
        }
        if (target != end) {
            event.area += std::exchange(work_.swept, 0);
            work_.events.push_back(event);
        }
        return has_landed;
    }

    // A vertex of the wall below the one that lands, or a new one there; only if it lies exactly
    // on the wall, as beside it the domain would have another corner.
    std::uint32_t foot_of(const Below& below, std::uint32_t end) {
        if (below.share < 1 - static_cast<Real>(landing_share)) {
            const Point<Real> foot = at(end) + below.share * (at(below.other) - at(end));
            if (orientation<Real>(at(end), foot, at(below.other)) == 0) {
                const SplitResult split = edge_split(complex_, submesh_, below.edge, foot);
                if (split.verdict == Verdict::legal) {
                    return split.vertex.id;
                }
            }
        }
        return below.other;
    }

    // The triangle between the curve and the wall, as far as `target`.
    double give_wedge(std::uint32_t v, std::uint32_t end, std::uint32_t target, Phase taker) {
        const Corner wedge = find_corner(complex_, Vertex{v}, [&](Corner c) {
            const std::uint32_t from = complex_.vertex(next(c));
            const std::uint32_t to = complex_.vertex(prev(c));
            return (from == end && to == target) || (to == end && from == target);
        });
        const Triangle t{triangle_of(wedge)};
        give(work_, t, taker);
        return static_cast<double>(doubled_area(complex_, t)) / 2;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh submesh_ = whole_submesh(complex_);
    std::span<const Suspect<Real>> suspects_;
    std::vector<WallChord<Real>> chords_;
    std::unordered_map<Corner, std::size_t> index_; ///< of the chords that are still to be visited
};

} // namespace

template <class Real>
void open_wall_films(TopologyWork<Real>& work, std::span<const Suspect<Real>> suspects) {
    WallFilms<Real>(work, suspects).run();
}

template void open_wall_films(TopologyWork<double>&, std::span<const Suspect<double>>);
template void open_wall_films(TopologyWork<float>&, std::span<const Suspect<float>>);

} // namespace dsc
