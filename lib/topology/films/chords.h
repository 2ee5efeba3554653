// SPDX-License-Identifier: MIT
// Chords are rays across a film that are shorter than the contact distance; neighbouring chords
// form a thin place. They serve for contact distances of several edge lengths; see wide_films.h.
#pragma once

#include "topology/candidates.h"
#include "topology/films/film_ray.h"

#include <span>
#include <vector>

namespace dsc {

template <class Real>
struct Chord {
    Corner sheet; ///< the half-edge that the ray starts from, with the film on its left
    FilmRay<Real> ray;
};

/// The wide contact distance at a half-edge on the interface; 0 if the half-edge must stay, or if
/// single triangles span that distance.
template <class Real>
[[nodiscard]] Real wide_contact_at(const TopologyWork<Real>& work, Corner sheet);

/// The chord of a half-edge; without an opposite if there is none. O(contact / edge length).
template <class Real>
[[nodiscard]] Chord<Real> find_chord(const TopologyWork<Real>& work, Corner sheet);

/// The half-edges at the candidates from which chords start, grouped into thin places: chords of
/// successive half-edges, and of half-edges opposite to each other, belong to one place. The order
/// depends only on positions. O(candidates * contact / edge length).
template <class Real>
[[nodiscard]] std::vector<std::vector<Corner>>
find_thin_places(const TopologyWork<Real>& work, std::span<const Candidate> candidates);

/// How the two sheets of a chord are connected along the outline.
struct Connection {
    bool is_near = false;       ///< connected in one direction, within a few contact distances
    bool is_far = false;        ///< not so in the other direction
    bool is_beside_end = false; ///< not near, but nearly so
    /// A seam lies between them, about as long as the contact distance.
    bool is_seam = false;
};
template <class Real>
[[nodiscard]] Connection connection_of(const TopologyWork<Real>& work, const Chord<Real>& chord);

} // namespace dsc
