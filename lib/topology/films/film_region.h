// SPDX-License-Identifier: MIT
// The region of a film between two sheets that is about to change its phase: the triangles that
// rays cross, and what would remain between them.
#pragma once

#include "topology/region.h"

#include <array>
#include <functional>
#include <unordered_map>
#include <vector>

namespace dsc {

/// Splits long edges of the triangles that the ray of the half-edge between two vertices crosses,
/// because a film is divided by whole triangles; edges are long if they are longer than those of
/// uniform sizes. Returns whether there were any. O(contact / length of the edges).
template <class Real>
bool refine_film(TopologyWork<Real>& work, const std::array<Vertex, 2>& sheet, Real contact);

template <class Real>
class FilmRegion {
public:
    /// Rays are followed up to the distance `contact`; pockets between them are thinner than that.
    FilmRegion(TopologyWork<Real>& work, Phase film, Real contact)
        : work_(work), film_(film), contact_(contact) {}

    /// Adds the triangles on the ray of the half-edge, each for the phase beyond the nearest sheet;
    /// the domain boundary does not count as a sheet. O(contact / length of the edges).
    void add_ray(Corner sheet);
    /// Adds what would remain as notches, pockets, and pieces below the smallest area: each
    /// triangle for the phase beyond its own sheet, if that may take it, or else for its
    /// neighbour's. O(number of triangles), a few dozen times.
    void fill(const std::function<bool(Triangle, Phase)>& may_take);
    /// Adds the thin triangles that would remain as sharp notches beside the region. O(number of
    /// triangles).
    void fill_notches();
    /// Straightens the ends of the region. The vertices there are inside the film, so no phase's
    /// area changes. O(number of triangles), a few times.
    void smooth();
    /// The phases that take parts of the region, ascending. O(number of triangles).
    [[nodiscard]] std::vector<Phase> takers() const;
    /// Divides the region anew if several phases take parts of it (division.h): also those whose
    /// fronts are beside it without a ray, if they may take a triangle there. Returns whether edges
    /// were split: then corners of half-edges have changed.
    bool divide(const std::function<bool(Triangle, Phase)>& may_take);
    /// The area that the phase will take. O(number of triangles).
    [[nodiscard]] double area_of(Phase taker) const;
    /// Gives all triangles to their new phases and returns their area. Their vertices are then
    /// marked as lying on a seam; where the interface is ahead of its fronts now, it waits for
    /// them.
    double give_all();

    [[nodiscard]] bool contains(Triangle t) const { return entries_.contains(t.id); }

private:
    struct Entry {
        Phase to;
        Real distance; ///< from the nearest sheet, along a ray
    };

    struct Waiting {
        Vertex vertex;
        Real shares; ///< of a sub-step, for a front that goes so far in a whole one
        Real speed;
    };

    [[nodiscard]] std::vector<Vertex> vertices() const;
    [[nodiscard]] std::vector<Waiting> find_waiting() const;
    void offer(Triangle t, Phase to, Real distance);
    [[nodiscard]] bool is_rest(Triangle t) const;
    [[nodiscard]] bool is_small_piece(Triangle start);
    /// The phase of a triangle after the change.
    [[nodiscard]] Phase phase_later(Triangle t) const;
    void straighten(Vertex v);

    TopologyWork<Real>& work_;
    Phase film_;
    Real contact_;
    std::unordered_map<std::uint32_t, Entry> entries_; ///< by triangle
    std::vector<Triangle> order_;                      ///< the same triangles, as they came
    std::vector<Triangle> piece_;
};

} // namespace dsc
