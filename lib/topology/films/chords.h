// SPDX-License-Identifier: MIT
// Chords: rays across a film that are shorter than the contact distance, and the thin places that
// they make up. For contact distances of several edge lengths; see wide_films.h.
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

/// The wide contact distance at a half-edge on the interface; 0 if it has to stay, or if single
/// triangles span that distance.
template <class Real>
[[nodiscard]] Real wide_contact_at(const TopologyWork<Real>& work, Corner sheet);

/// The chord of a half-edge; without an opposite if there is none. O(contact / edge length).
template <class Real>
[[nodiscard]] Chord<Real> find_chord(const TopologyWork<Real>& work, Corner sheet);

/// The half-edges from which chords start at the candidates, by places: chords of successive
/// half-edges, and of those that see each other, belong to one place. In an order that depends only
/// on where they lie. O(candidates * contact / edge length).
template <class Real>
[[nodiscard]] std::vector<std::vector<Corner>>
find_thin_places(const TopologyWork<Real>& work, std::span<const Candidate> candidates);

/// How the two sheets of a chord are connected along the outline.
struct Connection {
    bool is_near = false;       ///< in one direction, within a few contact distances
    bool is_far = false;        ///< not in the other direction
    bool is_beside_end = false; ///< not near, but nearly so
    /// A seam lies between them, about as long as the contact distance.
    bool is_seam = false;
};
template <class Real>
[[nodiscard]] Connection connection_of(const TopologyWork<Real>& work, const Chord<Real>& chord);

} // namespace dsc
