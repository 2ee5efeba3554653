// SPDX-License-Identifier: MIT
// Which submesh may edit what: each vertex belongs to one submesh in each colour. A tet belongs to
// a submesh if its four vertices do; while a colour runs, tets with vertices of several submeshes
// are written by nobody. So a vertex whose star has no such tet can be searched around without
// locks or tests, and a submesh may edit everything there.
#pragma once

#include "dsc3/complex/complex.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace dsc3 {

/// What one colour defers is done by the next one, which cuts the mesh elsewhere; what the last one
/// defers is done by one thread.
inline constexpr std::uint32_t colour_count = 4;
/// No colour divides the mesh into more submeshes.
inline constexpr std::uint32_t submesh_limit = 64;

/// One byte for each colour: the submesh of a vertex, and the outer bit, which says that a tet of
/// its star has a vertex of another submesh. The bit may be set without need after edits.
using Label = std::uint32_t;
inline constexpr Label outer_bits = 0x80808080U;

/// The outer bits of the vertices of a tet with these labels.
[[nodiscard]] constexpr Label outer_of(Label a, Label b, Label c, Label d) {
    const Label differ = ((a ^ b) | (a ^ c) | (a ^ d)) & ~outer_bits;
    return (differ + ~outer_bits) & outer_bits;
}
/// The byte of a colour.
[[nodiscard]] constexpr std::uint32_t byte_of(Label label, std::uint32_t colour) {
    return (label >> (8 * colour)) & 255U;
}

/// Divides space by planes: node n has the children 2n and 2n + 1.
struct CutTree {
    std::uint32_t levels = 0;
    std::array<std::uint8_t, submesh_limit> axes{};
    std::array<Real, submesh_limit> cuts{}; ///< infinite: everything is on the lower side

    /// The cell of a point, below 2^levels.
    [[nodiscard]] std::uint32_t cell(const Point& p) const {
        std::uint32_t node = 1;
        for (std::uint32_t level = 0; level < levels; ++level) {
            node = 2 * node + (p[axes[node]] >= cuts[node] ? 1U : 0U);
        }
        return node - (1U << levels);
    }
    /// The distance to the nearest of the planes that decide the cell of the point.
    [[nodiscard]] Real distance(const Point& p) const;
};

/// An application's own division: the number of the submesh at a place. Called for every living
/// vertex, also of a state that is being read, whatever its domain, and for places up to a few edge
/// lengths outside of the domain, by several threads at once; must return the same number for the
/// same place, and must not throw.
using Partition = std::function<std::uint32_t(const Point& place)>;

/// The submeshes of all vertices in all colours.
struct Ownership {
    std::array<CutTree, colour_count> trees;
    Partition partition;         ///< of the first colour, in place of its tree, if not empty
    std::uint32_t submeshes = 0; ///< of the partition
    std::vector<Label> labels;   ///< by vertex

    /// The label of a new vertex at this place, without outer bits.
    [[nodiscard]] Label label_at(const Point& p) const;
    /// Sets the outer bits of the vertices of a tet.
    void note(const TetRecord& tet) {
        const auto& v = tet.v;
        const Label outer = outer_of(labels[v[0]], labels[v[1]], labels[v[2]], labels[v[3]]);
        if (outer != 0) {
            for (const std::uint32_t vertex : v) {
                labels[vertex] |= outer;
            }
        }
    }
    /// The submesh that may edit the stars of all these vertices; `no_id` if there is none.
    template <class Vertices>
    [[nodiscard]] std::uint32_t owner(const Vertices& vertices, std::uint32_t colour) const {
        const std::uint32_t first = byte_of(labels[vertices[0]], colour);
        for (const std::uint32_t v : vertices) {
            if (const std::uint32_t byte = byte_of(labels[v], colour);
                byte != first || byte > 127) {
                return no_id;
            }
        }
        return first;
    }
};

/// What one thread edits while a colour runs.
struct Submesh {
    std::uint32_t index = 0;
    std::uint32_t colour = 0;
    std::vector<std::uint32_t> free_vertices; ///< its share of the free ids
    std::vector<std::uint32_t> free_tets;
    std::uint32_t spare_entry = 0; ///< of the attributes of tets: scratch
};

} // namespace dsc3
