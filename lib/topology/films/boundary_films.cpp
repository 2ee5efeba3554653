// SPDX-License-Identifier: MIT
#include "topology/films/boundary_films.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_split.h"
#include "topology/films/facing.h"
#include "topology/films/film_region.h"
#include "topology/junctions/sectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>

namespace dsc {

namespace {

/// Chords closer to the end of the curve than this many contact distances and an edge, along the
/// curve, belong to the wedge there and are no film.
constexpr double length_of_wedge = 1.5;
/// Chords closer to the end than this many contact distances belong to the film that has opened
/// there.
constexpr double same_film = 12;
/// A foot counts as near an end of a boundary edge up to this share of the edge.
constexpr double near_foot = 0.25;

template <class Real>
class BoundaryFilms {
public:
    BoundaryFilms(TopologyWork<Real>& work, std::vector<Chord<Real>> chords)
        : work_(work), complex_(work.complex), chords_(std::move(chords)) {}

    void run() {
        index_chords();
        while (visit_runs()) { // the chords are found anew where the mesh was refined
            chords_ = find_chords(work_).list;
            index_chords();
        }
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    void index_chords() {
        std::erase_if(chords_,
                      [](const Chord<Real>& chord) { return chord.ray.boundary == no_id; });
        index_.clear();
        for (std::size_t i = 0; i < chords_.size(); ++i) {
            index_.emplace(chords_[i].sheet, i);
        }
    }

    // Visits runs of chords until the mesh is refined; returns whether it was.
    bool visit_runs() {
        std::vector<std::uint8_t> is_first(chords_.size(), 1); // no other chord precedes it
        for (const auto& chord : chords_) {
            const auto following = index_.find(along_outline(complex_, chord.sheet));
            if (following != index_.end()) {
                is_first[following->second] = 0;
            }
        }
        is_refined_ = false;
        for (const bool starts : {true, false}) { // remaining chords lie on closed curves
            for (std::size_t i = 0; i < chords_.size() && !is_refined_; ++i) {
                if ((is_first[i] != 0) == starts && index_.contains(chords_[i].sheet)) {
                    visit_run(i);
                }
            }
        }
        return is_refined_;
    }

    // Opens the film of a run of successive chords, unless the curve ends on the domain boundary
    // nearby: they are then the wedge there, of which only what is pressed opens.
    void visit_run(std::size_t first) {
        std::vector<Chord<Real>> run;
        for (auto at = index_.find(chords_[first].sheet); at != index_.end();) {
            const Chord<Real>& chord = chords_[at->second];
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
        const Real contact = contact_at(work_, run.front().sheet);
        const Real nearest = contact > 0
                                 ? std::min(way_to_end(run.back().sheet, contact),
                                            way_to_end(complex_.twin(run.front().sheet), contact))
                                 : Real(0);
        const Real near = static_cast<Real>(length_of_wedge) * contact + work_.edge_length;
        // The chord is pressed if both its vertices are stuck in several sub-steps, or if one is
        // blocked now at a place where no vertex lands.
        const auto is_pressed = [&](const Chord<Real>& chord) {
            const Corner c = chord.sheet;
            return is_stuck(c) || ((is_blocked(work_, complex_.vertex(next(c))) ||
                                    is_blocked(work_, complex_.vertex(prev(c)))) &&
                                   !is_to_land(c, near) && !is_to_land(complex_.twin(c), near));
        };
        if (nearest < near) {
            std::erase_if(run, [&](const Chord<Real>& chord) { return !is_pressed(chord); });
        }
        if (!(contact > 0) || run.empty()) {
            return;
        }
        open(run, std::isfinite(nearest) ? EventKind::widen : EventKind::meet);
    }

    // Whether a chord may still open: a film that opened before it may have taken its edge, or the
    // film.
    [[nodiscard]] bool opens(Chord<Real>& chord) const {
        if (!is_sheet(complex_, chord.sheet) || is_border(complex_.twin(chord.sheet))) {
            return false;
        }
        chord = find_chord(work_, chord.sheet);
        return chord.ray.boundary != no_id && (work_.options.opening != Opening::squeezed ||
                                               is_squeezed(work_, chord.sheet, chord.ray.boundary));
    }

    // Whether both ends of the sheet have been blocked repeatedly.
    [[nodiscard]] bool is_stuck(Corner sheet) const {
        const auto is_end_stuck = [&](Corner c) {
            return (complex_.vertices[complex_.vertex(c)].flags & vertex_contact) == vertex_contact;
        };
        return is_end_stuck(next(sheet)) && is_end_stuck(prev(sheet));
    }

    // The length along the curve from the end of the half-edge to the curve's end on the domain
    // boundary, if that is near enough to matter; 0 if the half-edge itself ends there, or is no
    // longer on the interface.
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

    // Whether the half-edge leads to a nearby end of the curve on the domain boundary, past
    // vertices that the boundary blocks: these land one after the other, from that end.
    [[nodiscard]] bool is_to_land(Corner sheet, Real near) const {
        Real length = 0;
        Corner c = sheet;
        do {
            c = along_outline(complex_, c);
            if (is_border(complex_.twin(c))) {
                return true;
            }
            length += direction(complex_, c).norm();
        } while (length < near && is_blocked(work_, complex_.vertex(next(c))));
        return false;
    }

    // A sheet, named by its two ends, because splits change the corners of half-edges.
    using Sheet = std::array<Vertex, 2>;
    [[nodiscard]] Corner half_edge(const Sheet& sheet) const {
        return complex_.find_half_edge(sheet[0], sheet[1]);
    }

    // Refines the film, which is divided by whole triangles: they must not be coarse, and below a
    // junction each of the two phases must reach the domain boundary.
    void prepare(const std::vector<Sheet>& sheets, Real contact) {
        for (const Sheet& sheet : sheets) {
            is_refined_ = refine_film<Real>(work_, sheet, contact) || is_refined_;
        }
        for (const Sheet& one : sheets) {
            for (const Sheet& other : sheets) {
                if (one[1] == other[0] && phase_beyond(complex_, half_edge(one)) !=
                                              phase_beyond(complex_, half_edge(other))) {
                    is_refined_ = split_below(one, other) || is_refined_;
                }
            }
        }
    }

    // Splits the boundary edge at the foot of the vertex between the two sheets, unless a boundary
    // vertex is near it.
    bool split_below(const Sheet& one, const Sheet& other) {
        for (const Sheet& sheet : {one, other}) {
            const Corner boundary = find_chord(work_, half_edge(sheet)).ray.boundary;
            if (boundary == no_id) {
                continue;
            }
            const Point<Real> from = at(complex_.vertex(next(boundary)));
            const Point<Real> along = direction(complex_, boundary);
            const Real share = (at(one[1].id) - from).dot(along) / along.squaredNorm();
            const Point<Real> foot = from + share * along;
            if (std::min(share, 1 - share) > static_cast<Real>(near_foot)) {
                return edge_split(Submesh(complex_), boundary, foot).verdict == Verdict::legal;
            }
        }
        return false;
    }

    // Opens the film along a run of chords. Its outline continues across junctions, and the phases
    // beyond divide the film; each part is a separate event, with its own question to the
    // application.
    void open(std::vector<Chord<Real>> run, EventKind kind) {
        std::erase_if(run, [this](Chord<Real>& chord) { return !opens(chord); });
        if (run.empty()) {
            return;
        }
        const Phase film = complex_.phase_at(run.front().sheet);
        Real contact = 0;
        for (const Chord<Real>& chord : run) {
            contact = std::max(contact, contact_at(work_, chord.sheet));
        }
        std::vector<Event> events;
        std::vector<Phase> refused;
        std::vector<Sheet> sheets;
        for (std::span<Chord<Real>> rest = run; !rest.empty();) {
            const Phase taker = phase_beyond(complex_, rest.front().sheet);
            const auto others =
                std::stable_partition(rest.begin(), rest.end(), [&](const auto& chord) {
                    return phase_beyond(complex_, chord.sheet) == taker;
                });
            const std::span part(rest.begin(), others);
            rest = {others, rest.end()};
            const auto& thinnest = *std::ranges::min_element(
                part, {}, [](const Chord<Real>& chord) { return chord.ray.thickness; });
            const Contact question = question_at(complex_, thinnest);
            if (!may_open(work_, question)) {
                refused.push_back(taker);
                continue;
            }
            for (const Chord<Real>& chord : part) {
                sheets.push_back({Vertex{complex_.vertex(next(chord.sheet))},
                                  Vertex{complex_.vertex(prev(chord.sheet))}});
            }
            events.push_back(event_at(work_, kind, question, {taker, taker}));
        }
        prepare(sheets, contact);
        FilmRegion<Real> region(work_, film, contact);
        for (const Sheet& sheet : sheets) {
            region.add_ray(half_edge(sheet));
        }
        const auto asked = [&](Triangle t, Phase to) {
            return may_take(t, to, kind, events, refused);
        };
        region.fill(asked);
        region.smooth();
        region.fill_notches();
        is_refined_ = region.divide(asked) || is_refined_;
        for (Event& event : events) {
            event.area = region.area_of(event.taken[0]);
            if (event.area > 0) { // another front may have been there first
                work_.events.push_back(event);
            }
        }
        region.give_all();
    }

    // Whether a phase may take a triangle of the film that has no ray: it has an event, or gets one
    // now, because part of the film lies between its sheets and the boundary, too.
    bool may_take(Triangle t, Phase to, EventKind kind, std::vector<Event>& events,
                  std::vector<Phase>& refused) const {
        if (std::ranges::any_of(events, [&](const Event& one) { return one.taken[0] == to; })) {
            return true;
        }
        if (std::ranges::find(refused, to) != refused.end()) {
            return false;
        }
        const Contact question = question_at(complex_, t, {to, border_phase});
        if (may_change(work_, question.film, to) && may_open(work_, question)) {
            events.push_back(event_at(work_, kind, question, {to, to}));
            return true;
        }
        refused.push_back(to);
        return false;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    std::vector<Chord<Real>> chords_;               ///< to the domain boundary
    std::unordered_map<Corner, std::size_t> index_; ///< the chords still to be visited
    bool is_refined_ = false;
};

} // namespace

template <class Real>
void open_boundary_films(TopologyWork<Real>& work, std::vector<Chord<Real>> chords) {
    if (!chords.empty()) {
        BoundaryFilms<Real>(work, std::move(chords)).run();
    }
}

template void open_boundary_films(TopologyWork<double>&, std::vector<Chord<double>>);
template void open_boundary_films(TopologyWork<float>&, std::vector<Chord<float>>);

} // namespace dsc
