// SPDX-License-Identifier: MIT
// The interface around a vertex: the faces of its star between tets of different phases. They
// determine its stratum.
#pragma once

#include "dsc3/complex/star.h"

#include <cstdint>
#include <vector>

namespace dsc3 {

/// A face (centre, x, y) of the interface, counter-clockwise as seen from the lower phase.
struct StarFace {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t tet; ///< on the side of the higher phase
};

/// The faces of the interface at a vertex.
struct InterfaceStar {
    std::uint32_t centre = no_id;
    std::vector<StarFace> faces;

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(faces.size()); }
    /// Whether the interface has the edge from the centre to this vertex. O(size).
    [[nodiscard]] bool has_edge_to(std::uint32_t vertex) const;
};

/// The star of the centre of a star. O(degree).
void gather(const Complex& complex, const Star& star, InterfaceStar& interface_star);

/// The kind of manifold that the interface is at a vertex.
enum class Stratum : std::uint8_t {
    none,  ///< no interface
    sheet, ///< one closed disc of faces: between two phases
    other, ///< a junction curve, an end of one, or sheets that touch
};

/// Derived from the star alone. O(size^2).
[[nodiscard]] Stratum stratum(const InterfaceStar& interface_star);

/// The unit normal of the interface at the centre of the star, towards the lower phase. Weighted
/// such that it is exact where all vertices lie on a sphere: N. Max, "Weights for computing vertex
/// normals from facet normals" (1999).
[[nodiscard]] Point normal(const Complex& complex, const InterfaceStar& interface_star);

} // namespace dsc3
