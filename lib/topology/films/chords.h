// SPDX-License-Identifier: MIT
// Chords: rays across a film that are shorter than the contact distance. From the middle of each
// interface edge a ray goes perpendicularly into the phases on either side. The film is thin there
// if the ray meets another sheet, or the domain boundary, that faces the edge within the contact
// distance. Chords of neighbouring edges, and of edges opposite to each other, form a thin place.
//
// The rays miss no film that is longer than an edge. If two sheets bend away from each other with a
// radius smaller than the thickness of the film, as those of two small drops do, the film counts as
// squeezed slightly later.
#pragma once

#include "topology/films/film_ray.h"

#include <span>
#include <vector>

namespace dsc {

template <class Real>
struct Chord {
    Corner sheet; ///< the half-edge that the ray starts from, with the film on its left
    FilmRay<Real> ray;

    /// Whether there is a chord at all.
    [[nodiscard]] bool exists() const { return ray.opposite != no_id || ray.boundary != no_id; }
};

/// The chord of a half-edge on the interface, if there is one. O(contact / edge length).
template <class Real>
[[nodiscard]] Chord<Real> find_chord(const TopologyWork<Real>& work, Corner sheet);

/// The question to the application whether the film may open at a chord. O(1).
template <class Real>
[[nodiscard]] Contact question_at(const Complex<Real>& complex, const Chord<Real>& chord);

/// The chords of an interface.
template <class Real>
struct Chords {
    std::vector<Chord<Real>> list; ///< in an order that depends only on positions
    bool has_fronts = false;       ///< several phases displace one film: `meet_in_points`
};

/// Finds all chords. The threads of the step share the search. O(interface vertices * contact /
/// edge length); no allocation if there are none.
template <class Real>
[[nodiscard]] Chords<Real> find_chords(const TopologyWork<Real>& work);

/// The sheets of the chords between two sheets, grouped into thin places. O(chords).
template <class Real>
[[nodiscard]] std::vector<std::vector<Corner>> thin_places(const Complex<Real>& complex,
                                                           std::span<const Chord<Real>> chords);

/// How the two sheets of a chord are connected along the outline.
struct Connection {
    bool is_near = false;       ///< connected in one direction, within a few `end_length`
    bool is_far = false;        ///< not so in the other direction
    bool is_beside_end = false; ///< not near, but nearly so
    /// A seam lies between them, about as long as the contact distance.
    bool is_seam = false;
};
template <class Real>
[[nodiscard]] Connection connection_of(const TopologyWork<Real>& work, const Chord<Real>& chord);

} // namespace dsc
