// SPDX-License-Identifier: MIT
// The triangles of a film between two sheets, as they are about to change hands: those that rays
// cross, and what would be left between them.
#pragma once

#include "topology/region.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace dsc {

/// Splits the edges of a film that the ray of the half-edge between two vertices comes past, where
/// they are longer than those of uniform sizes: a film is divided by whole triangles. Returns
/// whether there were any. O(contact / length of the edges).
template <class Real>
bool refine_film(TopologyWork<Real>& work, const std::array<Vertex, 2>& sheet, Real contact);

template <class Real>
class FilmRegion {
public:
    /// Rays are followed as far as `contact`, which is wider than pockets between them.
    FilmRegion(TopologyWork<Real>& work, Phase film, Real contact)
        : work_(work), film_(film), contact_(contact) {}

    /// The triangles on the ray of the half-edge, each for the phase beyond the nearest sheet; the
    /// domain boundary is none.
    /// O(contact / length of the edges).
    void add_ray(Corner sheet);
    /// Takes what would be left as notches, pockets, and pieces below the least area. O(number of
    /// triangles), a few dozen times.
    void fill();
    /// Straightens where the region will end: its vertices there are inside the film, so that no
    /// phase changes by that. O(number of triangles), a few times.
    void smooth();
    /// The area that the phase is about to take. O(number of triangles).
    [[nodiscard]] double area_of(Phase taker) const;
    /// Gives all triangles away and returns their area. Their vertices lie on a seam from now on.
    double give_all();

    [[nodiscard]] bool contains(Triangle t) const { return entries_.contains(t.id); }

private:
    struct Entry {
        Phase to;
        Real distance; ///< to the nearest sheet, along a ray
    };

    void offer(Triangle t, Phase to, Real distance);
    [[nodiscard]] bool is_rest(Triangle t) const;
    [[nodiscard]] bool is_small_piece(Triangle start);
    /// The phase of a triangle after the change.
    [[nodiscard]] Phase phase_later(Triangle t) const;
    void straighten(Vertex v);
    [[nodiscard]] Real worst_share(Vertex v, const Point<Real>& place) const;
    [[nodiscard]] bool is_all_positive(Vertex v, const Point<Real>& place) const;

    TopologyWork<Real>& work_;
    Phase film_;
    Real contact_;
    std::unordered_map<std::uint32_t, Entry> entries_; ///< by triangle
    std::vector<Triangle> order_;                      ///< the same triangles, as they came
    std::vector<Triangle> piece_;
};

} // namespace dsc
