// SPDX-License-Identifier: MIT
// The interface around a vertex: the faces of its star between tets of different phases. They
// determine its stratum, which is stored nowhere: a sheet between two phases, a junction curve
// where several sheets meet, or a point where curves meet.
#pragma once

#include "dsc3/complex/star.h"

#include <cstdint>
#include <vector>

namespace dsc3 {

/// A face (centre, x, y) of the interface, counter-clockwise as seen from the lower phase.
struct StarFace {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t tet; ///< on the side of the higher phase; `border_tet` on the domain boundary
};

/// An edge of the interface at the centre of a star.
struct StarEdge {
    std::uint32_t vertex;
    std::uint32_t faces; ///< number of faces of the interface at the edge
    std::uint32_t as_x;  ///< a face of which the vertex is x, or no_id
    std::uint32_t as_y;  ///< a face of which the vertex is y, or no_id

    bool is_domain_edge = false; ///< whether two sides of the domain meet at it

    /// Whether more than two phases meet at it, the interface ends on a side, or sheets touch.
    [[nodiscard]] bool is_on_curve() const { return faces != 2 || is_domain_edge; }
};

/// The faces of the interface at a vertex; on the domain boundary also those of the sides, as if
/// the outside were one more phase. The end of the interface on a side is then a curve.
struct InterfaceStar {
    std::uint32_t centre = no_id;
    std::vector<StarFace> faces;
    std::vector<std::uint32_t> domain_edges; ///< the other vertices of edges where two sides meet
    std::vector<StarEdge> edges;             ///< filled by `classify`

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(faces.size()); }
    /// Whether the interface has the edge from the centre to this vertex. O(size).
    [[nodiscard]] bool has_edge_to(std::uint32_t vertex) const;
    /// The entry of `edges` of a vertex; null if there is none. O(size).
    [[nodiscard]] const StarEdge* edge_to(std::uint32_t vertex) const;
};

/// The star of the centre of a star. O(degree).
void gather(const Complex& complex, const Star& star, InterfaceStar& interface_star);

/// The kind of manifold that the interface is at a vertex.
enum class Stratum : std::uint8_t {
    none,  ///< no interface
    sheet, ///< one closed disc of faces: between two phases
    curve, ///< sheets that meet along two edges, in both of which the same number of them meets
    point, ///< anything else: junction curves that meet or end, or sheets that touch
};

/// Whether the faces are one closed disc. O(size^2).
[[nodiscard]] bool is_sheet(const InterfaceStar& interface_star);

/// Fills `edges`, and derives the stratum from the star alone. O(size^2).
Stratum classify(InterfaceStar& interface_star);

/// The number of vertices of each stratum of the interface.
struct StrataCounts {
    std::uint32_t sheet = 0;
    std::uint32_t curve = 0;
    std::uint32_t point = 0;
};
/// Counts them. O(mesh).
[[nodiscard]] StrataCounts count_strata(const Complex& complex);

/// The unit normal of the interface at the centre of the star, towards the lower phase: that of the
/// sphere plus a saddle which fits the neighbours best. So it is exact on spheres, and of second
/// order elsewhere, whatever the directions of the neighbours. O(size).
[[nodiscard]] Point normal(const Complex& complex, const InterfaceStar& interface_star);

/// The normal of one sheet at a vertex.
struct SheetNormal {
    Point normal;           ///< that of `normal` if it is all of the interface there
    bool is_closed = false; ///< whether the sheet closes around the vertex: else it ends at curves
};
/// The normal of the sheet that has the edge, which is on no curve, of a classified star. O(size).
[[nodiscard]] SheetNormal normal_at(const Complex& complex, const InterfaceStar& interface_star,
                                    const StarEdge& edge);

} // namespace dsc3
