// SPDX-License-Identifier: MIT
#include "topology/films/chords.h"

#include "topology/films/bridge.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace dsc {

namespace {

/// Two sheets that meet along the outline within this many contact distances are the end of a
/// filament rather than its two sides.
constexpr double filament_end = 6;
/// Up to this many contact distances, a sheet is beside the end of a filament.
constexpr double beside_end = 1.25 * filament_end;
/// Up to this many contact distances, two sheets belong to the end of a seam, which crosses the
/// film.
constexpr double end_of_seam = 3;

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

// The sheets of all chords, each once, in the order of their positions.
template <class Real>
std::vector<std::array<Corner, 2>> all_chords(const TopologyWork<Real>& work,
                                              std::span<const Candidate> candidates) {
    const Complex<Real>& complex = work.complex;
    std::vector<std::tuple<Real, Real, std::array<Corner, 2>>> found;
    const auto look = [&](const Candidate& candidate, auto& chords) {
        if (!complex.is_alive(Vertex{candidate.vertex})) {
            return;
        }
        (void)find_corner(complex, Vertex{candidate.vertex}, [&](Corner at) {
            const Corner sheet = prev(at); // the half-edge that starts at the vertex
            const Chord<Real> chord =
                is_sheet(complex, sheet) ? find_chord(work, sheet) : Chord<Real>{};
            if (chord.ray.opposite != no_id) {
                chords.emplace_back(chord.ray.middle.x(), chord.ray.middle.y(),
                                    std::array{sheet, chord.ray.opposite});
            }
            return false; // all of them, in any order
        });
    };
    find_at(work.in_shares, candidates, found, look);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<std::array<Corner, 2>> list;
    for (const auto& one : found) {
        list.push_back(std::get<2>(one));
    }
    return list;
}

} // namespace

template <class Real>
Real wide_contact_at(const TopologyWork<Real>& work, Corner sheet) {
    const Complex<Real>& complex = work.complex;
    if (is_border(complex.twin(sheet))) {
        return 0; // the domain boundary is no sheet
    }
    const auto rule = rule_of(work.options, work.edge_length, complex.phase_at(sheet),
                              complex.phase_at(complex.twin(sheet)));
    return rule.rule == Topology::change && is_wide(rule.contact, work.edge_length) ? rule.contact
                                                                                    : Real(0);
}

template <class Real>
Chord<Real> find_chord(const TopologyWork<Real>& work, Corner sheet) {
    const Real contact = wide_contact_at(work, sheet);
    if (!(contact > 0)) {
        return {sheet, {}};
    }
    const FilmRay<Real> ray = cross_film(work.complex, sheet, contact, [](Triangle, Real, Real) {});
    const bool is_chord = ray.opposite != no_id && faces(work.complex, sheet, ray.opposite) &&
                          ray.thickness < wide_contact_at(work, ray.opposite);
    return {sheet, is_chord ? ray : FilmRay<Real>{}};
}

template <class Real>
std::vector<std::vector<Corner>> find_thin_places(const TopologyWork<Real>& work,
                                                  std::span<const Candidate> candidates) {
    const auto chords = all_chords(work, candidates);
    std::unordered_map<Corner, std::size_t> index;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        index.emplace(chords[i][0], i);
    }
    Places places(chords.size());
    for (std::size_t i = 0; i < chords.size(); ++i) {
        for (const Corner c : {along_outline(work.complex, chords[i][0]), chords[i][1]}) {
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
        list[at[first]].push_back(chords[i][0]);
    }
    return list;
}

template <class Real>
Connection connection_of(const TopologyWork<Real>& work, const Chord<Real>& chord) {
    const Real contact = wide_contact_at(work, chord.sheet);
    Connection connection;
    for (const bool is_ahead : {true, false}) {
        const Corner one = is_ahead ? chord.sheet : chord.ray.opposite;
        const Corner other = is_ahead ? chord.ray.opposite : chord.sheet;
        const Way<Real> way = way_along(work, one, other, static_cast<Real>(beside_end) * contact);
        const double distances = way.arrives ? static_cast<double>(way.length / contact)
                                             : std::numeric_limits<double>::infinity();
        (distances < filament_end ? connection.is_near : connection.is_far) = true;
        connection.is_beside_end = connection.is_beside_end || way.arrives;
        // A sheet that ends on the domain boundary is no end of a seam, even if a film has opened
        // there.
        connection.is_seam =
            connection.is_seam || (distances < end_of_seam && way.on_seam && !way.on_boundary);
    }
    connection.is_beside_end = connection.is_beside_end && !connection.is_near;
    return connection;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Real wide_contact_at(const TopologyWork<Real>&, Corner);                              \
    template Chord<Real> find_chord(const TopologyWork<Real>&, Corner);                            \
    template std::vector<std::vector<Corner>> find_thin_places(const TopologyWork<Real>&,          \
                                                               std::span<const Candidate>);        \
    template Connection connection_of(const TopologyWork<Real>&, const Chord<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
