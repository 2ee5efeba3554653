// SPDX-License-Identifier: MIT
#include "topology/films/films.h"

#include "topology/films/facing.h"
#include "topology/films/film_region.h"

#include <algorithm>
#include <array>
#include <limits>

namespace dsc {

namespace {

/// In a tip, a thin place becomes thinner than this fraction of its thickness towards the point.
constexpr double tip_share = 0.7;
/// A piece whose mean thickness is less than this many contact distances is the rest of a film that
/// has opened beside it.
constexpr double rest_of_film = 1.25;
/// The sheets of a notch lie on each other if they are not farther apart than this fraction of
/// their length.
constexpr double closed_notch = 0.05;

template <class Real>
class Films {
public:
    explicit Films(TopologyWork<Real>& work) : work_(work), complex_(work.complex) {}

    void run(std::span<const Chord<Real>> chords) {
        for (const std::vector<Corner>& place : thin_places(complex_, chords)) {
            visit(place);
        }
    }

private:
    // Opens a thin place; films that opened before may have closed a part of it.
    void visit(const std::vector<Corner>& place) {
        chords_.clear();
        seams_.clear();
        const Chord<Real>* film = nullptr;
        bool is_beside_end = false;
        for (const Corner sheet : place) {
            if (is_sheet(complex_, sheet)) {
                const Chord<Real> chord = find_chord(work_, sheet);
                if (chord.ray.opposite != no_id) {
                    chords_.push_back(chord);
                }
            }
        }
        Real tip = std::numeric_limits<Real>::max();
        for (const Chord<Real>& chord : chords_) {
            const Connection connection = connection_of(work_, chord);
            if (!connection.is_near) {
                if (opens(chord) && (film == nullptr || is_thinner(chord, *film))) {
                    film = &chord;
                    is_beside_end = connection.is_beside_end;
                }
            } else if (!connection.is_seam && !(connection.is_far && is_closing_notch(chord))) {
                tip = std::min(tip, chord.ray.thickness);
            } else if (work_.options.follows_seams && is_thin_at_both(chord) &&
                       goes_on(chord, connection) &&
                       (connection.is_seam || may_open(work_, question_at(complex_, chord)))) {
                seams_.push_back(chord);
            }
        }
        const auto is_tip = [&] {
            return is_beside_end && tip < static_cast<Real>(tip_share) * film->ray.thickness;
        };
        if (film != nullptr && !is_tip()) {
            open(*film);
        } else if (!seams_.empty()) {
            widen();
        }
    }

    static bool is_thinner(const Chord<Real>& one, const Chord<Real>& other) {
        return one.ray.thickness < other.ray.thickness;
    }

    // Whether the film is thin at the opposite sheet, too. Ahead of a seam the sheets part, and an
    // edge that is longer than the film is thick leads far into it, unless both lie on each other.
    bool is_thin_at_both(const Chord<Real>& chord) const {
        return is_wide(contact_at(work_, chord.sheet), work_.edge_length) || has_closed(chord) ||
               find_chord(work_, chord.ray.opposite).ray.opposite != no_id;
    }

    bool opens(const Chord<Real>& chord) const {
        const Corner opposite = chord.ray.opposite;
        return work_.options.opening == Opening::squeezed
                   ? !are_ends_of_seam(work_, chord.sheet, opposite) &&
                         is_squeezed(work_, chord.sheet, opposite)
                   : !has_end_on_seam(chord.sheet) && !has_end_on_seam(opposite);
    }

    // Whether the sheets lie on each other. At the domain boundary vertices land instead.
    bool has_closed(const Chord<Real>& chord) const {
        const auto is_inside = [&](Corner sheet) {
            return !is_on_boundary(complex_, Vertex{complex_.vertex(next(sheet))}) &&
                   !is_on_boundary(complex_, Vertex{complex_.vertex(prev(sheet))});
        };
        return chord.ray.thickness <
                   static_cast<Real>(closed_notch) * direction(complex_, chord.sheet).norm() &&
               is_inside(chord.sheet) && is_inside(chord.ray.opposite);
    }

    // Whether the chord crosses a notch that closes: its two sheets share a vertex, and their other
    // ends block each other, or both lie on each other and block any of their vertices. Two sheets
    // with edges between them may be blocked by something else, as the overhanging foot of a drop
    // is by the domain boundary.
    bool is_closing_notch(const Chord<Real>& chord) const {
        const auto blocks = [&](Corner end) {
            return (complex_.vertices[complex_.vertex(end)].flags & vertex_contact) != 0;
        };
        const Corner one = chord.sheet;
        const Corner other = chord.ray.opposite;
        const auto closes = [&](Corner first, Corner second) {
            return complex_.vertex(prev(first)) == complex_.vertex(next(second)) &&
                   (has_closed(chord)
                        ? blocks(prev(first)) || blocks(next(first)) || blocks(prev(second))
                        : blocks(next(first)) && blocks(prev(second)));
        };
        return closes(one, other) || closes(other, one);
    }

    // The neck that an opened film leaves is as thin as the film was: it would close again at once,
    // so it only counts as a film if the flow squeezes it.
    bool has_end_on_seam(Corner sheet) const {
        return is_on_seam(work_, complex_.vertex(next(sheet))) ||
               is_on_seam(work_, complex_.vertex(prev(sheet)));
    }

    // Whether the seam extends over this chord: a small piece surrounded by a seam is no part of
    // the film, unless the flow squeezes it.
    bool goes_on(const Chord<Real>& chord, const Connection& connection) const {
        return work_.options.opening == Opening::squeezed
                   ? is_squeezed(work_, chord.sheet, chord.ray.opposite)
                   : connection.is_far;
    }

    void open(const Chord<Real>& film) {
        const Contact question = question_at(complex_, film);
        if (!may_open(work_, question)) {
            return;
        }
        FilmRegion<Real> region =
            region_of(work_.options.follows_seams ? chords_ : std::vector{film});
        give_all(region, event_at(work_, kind_of(film, region), question, question.sides));
    }

    void widen() {
        FilmRegion<Real> region = region_of(seams_);
        const Contact at = question_at(complex_, *std::ranges::min_element(seams_, is_thinner));
        give_all(region, event_at(work_, EventKind::widen, at, at.sides));
    }

    // The rest of a film may reach to other fronts, which take their parts of it. The event is made
    // before, because edges are split, and with them the corners of half-edges change.
    void give_all(FilmRegion<Real>& region, Event event) {
        region.divide([&](Triangle t, Phase to) {
            return contact_of(work_, event.lost, to) > 0 &&
                   may_open(work_, question_at(complex_, t, {to, to}));
        });
        std::vector<Event> others;
        for (const Phase taker : region.takers()) {
            if (std::ranges::find(event.taken, taker) == event.taken.end()) {
                others.push_back(event);
                others.back().kind = EventKind::widen;
                others.back().taken = {taker, taker};
                others.back().area = region.area_of(taker);
            }
        }
        event.area = region.give_all();
        for (const Event& other : others) {
            event.area -= other.area;
        }
        work_.events.push_back(event);
        work_.events.insert(work_.events.end(), others.begin(), others.end());
    }

    FilmRegion<Real> region_of(const std::vector<Chord<Real>>& chords) {
        Real contact = 0;
        for (const Chord<Real>& chord : chords) {
            contact = std::max(contact, contact_at(work_, chord.sheet));
        }
        FilmRegion<Real> region(work_, complex_.phase_at(chords.front().sheet), contact);
        for (const Chord<Real>& chord : chords) {
            region.add_ray(chord.sheet);
        }
        region.fill([](Triangle, Phase) { return false; });
        region.smooth();
        region.fill_notches();
        return region;
    }

    // If both sheets are on one outline of the film, the film splits into two pieces; if they are
    // on two outlines, these become one. It does not split if the region contains all of one of the
    // pieces, or if that piece is the rest of a film that has opened before.
    EventKind kind_of(const Chord<Real>& film, const FilmRegion<Real>& region) const {
        Side ahead;
        Side behind;
        Side* side = &ahead;
        const Point<Real> origin = film.ray.middle;
        for (Corner c = along_outline(complex_, film.sheet); c != film.sheet;
             c = along_outline(complex_, c)) {
            if (c == film.ray.opposite) {
                side = &behind;
                continue;
            }
            const std::uint32_t v = complex_.vertex(next(c));
            const Point<Real> from = complex_.position(Vertex{v}) - origin;
            const Point<Real> way = direction(complex_, c);
            side->doubled += cross<Real>(from, way);
            side->perimeter += way.norm();
            side->on_seam = side->on_seam || (work_.options.follows_seams && is_on_seam(work_, v));
            side->is_left = side->is_left || !region.contains(Triangle{triangle_of(c)});
        }
        const bool is_same = side == &behind;
        if (is_same) {
            for (const Side& piece : {ahead, behind}) {
                if (!piece.is_left && !piece.on_seam) {
                    return complex_.phase_at(film.sheet) == exterior_phase ? EventKind::fill
                                                                           : EventKind::remove;
                }
                if (!piece.is_left || is_rest_of_film(piece, film.sheet)) {
                    return EventKind::widen;
                }
            }
        }
        const Phase one = complex_.phase_at(complex_.twin(film.sheet));
        if (one != complex_.phase_at(complex_.twin(film.ray.opposite))) {
            return EventKind::meet;
        }
        return is_same ? EventKind::split : EventKind::merge;
    }

    // The outline of the film between the two ends of the chord.
    struct Side {
        Real doubled = 0; ///< area; negative if the film is outside
        Real perimeter = 0;
        bool on_seam = false;
        bool is_left = false; ///< the region does not contain all of it
    };

    // The mean thickness of a long piece is its area over half its outline.
    bool is_rest_of_film(const Side& piece, Corner sheet) const {
        return piece.on_seam && piece.doubled > 0 &&
               piece.doubled <
                   static_cast<Real>(rest_of_film) * contact_at(work_, sheet) * piece.perimeter;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    std::vector<Chord<Real>> chords_; ///< of the thin place that is visited
    std::vector<Chord<Real>> seams_;  ///< of these: beside a seam
};

} // namespace

template <class Real>
void open_films(TopologyWork<Real>& work, std::span<const Chord<Real>> chords) {
    if (!chords.empty()) {
        Films<Real>(work).run(chords);
    }
}

template void open_films(TopologyWork<double>&, std::span<const Chord<double>>);
template void open_films(TopologyWork<float>&, std::span<const Chord<float>>);

} // namespace dsc
