// SPDX-License-Identifier: MIT
#include "topology/films/chords.h"

#include "topology/films/facing.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace dsc {

namespace {

/// Lengths along the outline, in contact lengths, or in edge lengths where those are longer. Two
/// sheets that meet within this length are the end of a filament rather than its two sides.
constexpr double filament_end = 6;
/// Up to this length, a sheet is beside the end of a filament.
constexpr double beside_end = 1.25 * filament_end;
/// Up to this length, two sheets belong to the end of a seam, which crosses the film.
constexpr double end_of_seam = 3;

/// A relative slack of squared lengths, larger than their rounding errors.
constexpr double length_slack = 1e-3;

// Whether the ray of the half-edge is longer than the root of `squared` when it leaves its first
// triangle, as nearly all rays are. Without roots and divisions.
template <class Real>
bool leaves_late(const Complex<Real>& complex, Corner sheet, Real squared) {
    const Point<Real> along = direction(complex, sheet);
    const Point<Real> way(-along.y(), along.x());
    const Point<Real> to_apex = -direction(complex, prev(sheet)) - along / Real(2);
    const bool is_first = cross<Real>(way, to_apex) > 0;
    const Point<Real> edge = direction(complex, is_first ? next(sheet) : prev(sheet));
    // From the middle of the half-edge to the start of that edge.
    const Point<Real> start = is_first ? Point<Real>(along / Real(2)) : to_apex;
    const Real doubled = cross<Real>(start, edge);
    const Real share = cross<Real>(way, edge);
    return doubled * doubled * along.squaredNorm() > squared * share * share;
}

template <class Real>
struct Way {
    bool arrives = false;
    bool on_seam = false;
    bool on_boundary = false;
    Real length = 0; ///< between the two half-edges
};

// The way along the outline from one half-edge to another, if it is not longer than `longest`.
template <class Real>
Way<Real> way_along(const TopologyWork<Real>& work, Corner one, Corner other, Real longest) {
    const Complex<Real>& complex = work.complex;
    Way<Real> way;
    Corner c = one;
    while (way.length < longest) {
        c = along_outline(complex, c);
        way.on_seam = way.on_seam || is_on_seam(work, complex.vertex(next(c)));
        if (c == other) {
            way.arrives = true;
            return way;
        }
        if (c == one) {
            return way;
        }
        way.on_boundary = way.on_boundary || is_border(complex.twin(c));
        way.length += direction(complex, c).norm();
    }
    return way;
}

// Disjoint sets of indices that can be joined (union-find).
class Places {
public:
    explicit Places(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t first_of(std::size_t i) {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        const auto [low, high] = std::minmax({first_of(i), first_of(j)});
        parent_[high] = low;
    }

private:
    std::vector<std::size_t> parent_;
};

} // namespace

template <class Real>
Chord<Real> find_chord(const TopologyWork<Real>& work, Corner sheet) {
    const Complex<Real>& complex = work.complex;
    const Real contact = contact_at(work, sheet);
    if (!(contact > 0)) {
        return {sheet, {}};
    }
    const FilmRay<Real> ray = cross_film(complex, sheet, contact, [](Triangle, Real, Real) {});
    const Corner end = ray.opposite != no_id ? ray.opposite : ray.boundary;
    const bool is_chord =
        end != no_id && faces(complex, sheet, end) &&
        (ray.opposite == no_id ||
         (ray.thickness < contact_at(work, end) &&
          (is_wide(contact, work.edge_length) || !meet_in_points(complex.phase_at(sheet)) ||
           phase_beyond(complex, sheet) == phase_beyond(complex, end))));
    return {sheet, is_chord ? ray : FilmRay<Real>{}};
}

template <class Real>
Contact question_at(const Complex<Real>& complex, const Chord<Real>& chord) {
    const FilmRay<Real>& ray = chord.ray;
    const Corner end = ray.opposite != no_id ? ray.opposite : ray.boundary;
    return {.film = complex.phase_at(chord.sheet),
            .sides = {phase_beyond(complex, chord.sheet), phase_beyond(complex, end)},
            .x = static_cast<double>(ray.middle.x()),
            .y = static_cast<double>(ray.middle.y()),
            .thickness = static_cast<double>(ray.thickness)};
}

template <class Real>
Chords<Real> find_chords(const TopologyWork<Real>& work) {
    const Complex<Real>& complex = work.complex;
    std::atomic<Phase> front = border_phase; // the first that some thread finds
    std::atomic<bool> has_fronts = false;
    const auto note_front = [&](Phase phase) {
        Phase known = front.load(std::memory_order_relaxed);
        if (known == border_phase) {
            front.compare_exchange_strong(known, phase, std::memory_order_relaxed);
        }
        if (known != border_phase && known != phase) {
            has_fronts.store(true, std::memory_order_relaxed);
        }
    };
    std::vector<Chord<Real>> chords;
    const Real longest = largest_contact(work.options, work.edge_length);
    const Real squared = static_cast<Real>(1 + length_slack) * longest * longest;
    const auto look = [&](std::uint32_t v, std::vector<Chord<Real>>& found) {
        if (!complex.is_alive(Vertex{v})) {
            return;
        }
        (void)find_corner(complex, Vertex{v}, [&](Corner at) {
            const Corner sheet = prev(at); // the half-edge that starts at the vertex
            if (!is_sheet(complex, sheet) || is_border(complex.twin(sheet))) {
                return false;
            }
            if (meet_in_points(complex.phase_at(sheet)) &&
                !has_fronts.load(std::memory_order_relaxed)) {
                note_front(phase_beyond(complex, sheet));
            }
            if (!leaves_late(complex, sheet, squared)) {
                if (const Chord<Real> chord = find_chord(work, sheet); chord.exists()) {
                    found.push_back(chord);
                }
            }
            return false; // all of them, in any order
        });
    };
    find_at(work.in_shares, work.interface, chords, look);
    std::ranges::sort(chords, {}, [](const Chord<Real>& chord) {
        return std::tuple(chord.ray.middle.x(), chord.ray.middle.y(), chord.sheet);
    });
    return {std::move(chords), has_fronts};
}

template <class Real>
std::vector<std::vector<Corner>> thin_places(const Complex<Real>& complex,
                                             std::span<const Chord<Real>> all) {
    std::vector<Chord<Real>> chords;
    std::ranges::copy_if(all, std::back_inserter(chords),
                         [](const Chord<Real>& chord) { return chord.ray.opposite != no_id; });
    std::unordered_map<Corner, std::size_t> index;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        index.emplace(chords[i].sheet, i);
    }
    Places places(chords.size());
    for (std::size_t i = 0; i < chords.size(); ++i) {
        for (const Corner c : {along_outline(complex, chords[i].sheet), chords[i].ray.opposite}) {
            if (const auto at = index.find(c); at != index.end()) {
                places.join(i, at->second);
            }
        }
    }
    std::vector<std::vector<Corner>> list;
    std::vector<std::size_t> at(chords.size());
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const std::size_t first = places.first_of(i); // not after i
        if (first == i) {
            at[i] = list.size();
            list.emplace_back();
        }
        list[at[first]].push_back(chords[i].sheet);
    }
    return list;
}

template <class Real>
Connection connection_of(const TopologyWork<Real>& work, const Chord<Real>& chord) {
    const Real contact = contact_at(work, chord.sheet);
    const Real unit = std::max(contact, work.edge_length);
    const Real longest =
        std::max(static_cast<Real>(beside_end) * contact, static_cast<Real>(filament_end) * unit);
    Connection connection;
    for (const bool is_ahead : {true, false}) {
        const Corner one = is_ahead ? chord.sheet : chord.ray.opposite;
        const Corner other = is_ahead ? chord.ray.opposite : chord.sheet;
        const Way<Real> way = way_along(work, one, other, longest);
        const double lengths = way.arrives ? static_cast<double>(way.length / unit)
                                           : std::numeric_limits<double>::infinity();
        // Two sheets that end on the domain boundary side by side are the two sides of a film, and
        // no end of a filament.
        (lengths < filament_end && !way.on_boundary ? connection.is_near : connection.is_far) =
            true;
        connection.is_beside_end = connection.is_beside_end || way.arrives;
        // A sheet that ends on the domain boundary is no end of a seam, even if a film has opened
        // there.
        connection.is_seam =
            connection.is_seam || (lengths < end_of_seam && way.on_seam && !way.on_boundary);
    }
    connection.is_beside_end = connection.is_beside_end && !connection.is_near;
    return connection;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Chord<Real> find_chord(const TopologyWork<Real>&, Corner);                            \
    template Contact question_at(const Complex<Real>&, const Chord<Real>&);                        \
    template Chords<Real> find_chords(const TopologyWork<Real>&);                                  \
    template std::vector<std::vector<Corner>> thin_places(const Complex<Real>&,                    \
                                                          std::span<const Chord<Real>>);           \
    template Connection connection_of(const TopologyWork<Real>&, const Chord<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
