// SPDX-License-Identifier: MIT
// The sectors about a vertex of the interface, and how the energy changes as the vertex moves into
// one of them. The domain boundary has no energy: it acts as a mirror, and a curve meets it at 90
// degrees.
#pragma once

#include "topology/region.h"

#include <vector>

namespace dsc {

/// The triangles of one phase about a vertex, between two interface edges or an interface edge and
/// the domain boundary.
template <class Real>
struct Sector {
    Phase phase;       ///< of its triangles
    Corner first;      ///< at the vertex, in the sector's first triangle
    std::size_t count; ///< of its triangles, counter-clockwise
    Point<Real> ray;   ///< unit direction of the sector's first edge
    double angle = 0;  ///< radians
};

/// All sectors about a vertex, counter-clockwise; at the domain boundary from one side of it to the
/// other.
template <class Real>
struct Sectors {
    std::vector<Sector<Real>> list; ///< counter-clockwise
    bool is_on_boundary = false;    ///< the vertex lies on the domain boundary
    bool is_at_corner = false;      ///< the vertex is a feature of the domain boundary
    Point<Real> end; ///< on the domain boundary: unit direction of the edge after the last sector

    /// The number of sectors. O(1), as those below.
    [[nodiscard]] std::size_t size() const { return list.size(); }
    /// The sector k.
    [[nodiscard]] const Sector<Real>& operator[](std::size_t k) const { return list[k]; }
    /// The sector before, or the last one before the first.
    [[nodiscard]] const Sector<Real>& before(std::size_t k) const {
        return list[(k + size() - 1) % size()];
    }
    /// The sector after, or the first one after the last.
    [[nodiscard]] const Sector<Real>& after(std::size_t k) const { return list[(k + 1) % size()]; }
    /// Whether the sector k is the first or last one at the domain boundary.
    [[nodiscard]] bool is_beside_boundary(std::size_t k) const {
        return is_on_boundary && (k == 0 || k + 1 == size());
    }
    /// The largest stable number of sectors; vertices with more are split. Three curves may meet
    /// inside the domain, and one may end on its boundary.
    [[nodiscard]] std::size_t stable() const { return is_on_boundary ? 2 : 3; }
};

/// Finds the sectors about a living vertex. Empty inside a phase, away from the domain boundary.
/// O(degree).
template <class Real>
void find_sectors(const Complex<Real>& complex, Vertex v, Sectors<Real>& sectors);

/// The same after edits of their triangles: the list begins with the same sector as before.
template <class Real>
void find_sectors_again(const Complex<Real>& complex, Vertex v, Sectors<Real>& sectors);

/// Whether the vertex may have to change: it has more sectors than are stable, or a curve that may
/// end in a corner, or an edge shorter than `shortest` along the interface, or along the domain
/// boundary from the end of a curve. Cheaper than finding the sectors, and false for most vertices.
/// O(degree).
template <class Real>
[[nodiscard]] bool may_split(const Complex<Real>& complex, Vertex v, Real shortest);

/// The angle counter-clockwise from one direction to another: above 0, up to 2 pi.
template <class Real>
[[nodiscard]] double angle_between(const Point<Real>& from, const Point<Real>& to);

/// Whether the topology between two phases may change; true if they are the same.
template <class Real>
[[nodiscard]] bool may_change(const TopologyWork<Real>& work, Phase one, Phase other);

/// The energy of an interface between two phases, per length; 0 if they are the same. Throws
/// InputError if the application's value is negative or not finite.
template <class Real>
[[nodiscard]] double energy_between(const TopologyWork<Real>& work, Phase one, Phase other);

/// The change of energy per length that a junction moves into a sector, along its middle, away from
/// the neighbours `before` and `after`, which then touch.
template <class Real>
[[nodiscard]] double energy_inwards(const TopologyWork<Real>& work, Phase before, Phase sector,
                                    Phase after, double angle);

/// The same for the end of a curve that moves along the domain boundary, into the sector beside it.
template <class Real>
[[nodiscard]] double energy_along_boundary(const TopologyWork<Real>& work, Phase sector,
                                           Phase neighbour, double angle);

/// Differences of energy below this are a tie.
inline constexpr double energy_tie = 1e-9;

} // namespace dsc
