// SPDX-License-Identifier: MIT
// Division of a mesh as in the thesis: CreateSubmeshes and MergeSubmeshes, algorithms 6.1 and 6.2,
// with the counting method of slabbing (thesis, sections 6.3 and 8.5). Each submesh is a separate
// complex that holds copies; S_i says which of its vertices are shared with other submeshes, so
// that merging neither compares coordinates nor searches. The slabs that run in place
// (dsc/parallel/partition/partition.h) need no copies.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/submesh.h"

#include <memory>
#include <vector>

namespace dsc {

/// The two ways to place the slabs; black ones are shifted by half a share (thesis, section 6.3).
enum class RedBlack : std::uint8_t { red, black };

/// The counting method: slabs across the normal, each with the same share of the triangles.
struct CountingDivision {
    std::uint32_t submeshes = 8; ///< n
    double normal_x = 1;         ///< direction along which the slabs follow each other; length 1
    double normal_y = 0;
    RedBlack colour = RedBlack::red; ///< which of the two ways
};

/// Submesh i: the closure of its triangles. It has ids of its own; triangles at its boundary have
/// the border as their neighbour there.
template <class Real>
struct CopiedSubmesh {
    Complex<Real> complex; ///< K'_i; its pool may not grow
    /// S_i, by vertex of the submesh: the vertex of the mesh for those on the submesh boundary
    /// (IsSubmeshBoundary), no_id for all others, including those that are created later.
    std::vector<std::uint32_t> shared;
    /// S', by vertex of the submesh: the vertex of the merged mesh, or no_id. Filled by merging.
    std::vector<std::uint32_t> merged;
    std::vector<std::uint32_t> merged_triangles; ///< the same for triangles

    /// The part that operations may change: simplices without vertices on the submesh boundary
    /// (thesis, section 6.4). Invalid once vertices are added, as by `lend_ids`.
    [[nodiscard]] Region region() const {
        Region region;
        region.kind = Region::Kind::labels;
        region.labels = shared.data();
        region.label = no_id;
        return region;
    }
};

/// All submeshes of one division, and the maps into and out of them. Keeps its memory from one
/// division to the next.
template <class Real>
struct CopiedSubmeshes {
    static constexpr std::uint32_t several = no_id - 1; ///< in `owner`: on a submesh boundary

    std::vector<std::unique_ptr<CopiedSubmesh<Real>>> list; ///< K'_1 to K'_n; addresses stay
    std::vector<std::uint32_t> number; ///< N, by triangle of the mesh: its submesh
    /// By vertex of the mesh: the submesh that contains all its triangles, or `several`; no_id for
    /// vertices without triangles.
    std::vector<std::uint32_t> owner;
    /// M, by vertex of the mesh: its id in the submesh that owns it.
    std::vector<std::uint32_t> local;
    /// O, by vertex of the mesh: the id of a shared one in the merged mesh.
    std::vector<std::uint32_t> merged;

    /// The vertex of the merged mesh that was vertex v of the divided one; no_id if it vanished.
    [[nodiscard]] std::uint32_t merged_vertex(std::uint32_t v) const {
        if (owner[v] == several) {
            return merged[v];
        }
        return owner[v] == no_id ? no_id : list[owner[v]]->merged[local[v]];
    }

    // Scratch.
    /// Sorts triangles along the normal.
    struct Key {
        double place;           ///< three times the coordinate of the barycentre
        std::uint32_t triangle; ///< its id
    };
    /// Sorts the edges of submesh boundaries, so that the two sides of an edge are adjacent.
    struct HalfEdge {
        std::uint64_t ends; ///< smaller vertex, larger vertex
        Corner corner;      ///< in the merged mesh
    };
    std::vector<Key> keys;                     ///< of all triangles
    std::vector<std::size_t> cuts;             ///< begins of the shares in `keys`
    std::vector<std::size_t> begins;           ///< into `by_submesh`, by submesh
    std::vector<std::uint32_t> local_triangle; ///< by triangle of the mesh: its id in its submesh
    std::vector<std::uint32_t> by_submesh;     ///< triangles of the mesh, submesh by submesh
    std::vector<std::uint32_t> order;          ///< of the copied entries of the attributes
    std::vector<std::uint32_t> corner_order;   ///< the same for the entries of edges
    std::vector<HalfEdge> seams;               ///< of all submesh boundaries
    Complex<Real> fresh; ///< K' while it grows, and the arrays of the mesh before
};

/// CreateSubmeshes, algorithm 6.1. The triangles are ordered by their barycentres along the normal,
/// ties by id, and cut into n equal shares, of which the first ones may have one triangle more; for
/// black, the first half share and the rest at the end form one submesh, so that there are n again
/// (thesis, section 8.5). Copies phases, positions, flags, and the data of all attributes into new
/// ones. Vertices without triangles are in no closure and are not copied, as in the printed
/// algorithm. Submeshes may be empty if there are few triangles. `mesh` is not changed. O(t log n)
/// for the order, which is only as fine as the shares need, and O(v + t) for everything else.
/// Throws InputError if the division is out of range, or if submeshes hold ids of the mesh.
template <class Real>
void create_submeshes(const Complex<Real>& mesh, const CountingDivision& division,
                      CopiedSubmeshes<Real>& submeshes);

/// Gives a submesh free ids, for `vertices` new vertices and twice as many triangles: it may not
/// grow while it runs, so that its region stays valid. O(vertices).
template <class Real>
void lend_ids(CopiedSubmesh<Real>& submesh, std::size_t vertices);

/// MergeSubmeshes, algorithm 6.2: copies what is alive in the submeshes into a new complex, shared
/// vertices once, and replaces `mesh` by it (K <- K'). `mesh` must be the mesh that was divided,
/// with the same attributes. All simplices have new ids; none is free. The attributes are the same
/// objects with new entries, so that references to them stay valid; stamps are 0. O(v + t), and O(b
/// log b) for the b edges of the submesh boundaries. If anything throws, `mesh` is unchanged;
/// InvariantError if more than two triangles meet at a shared edge.
template <class Real>
void merge_submeshes(CopiedSubmeshes<Real>& submeshes, Complex<Real>& mesh);

/// Throws InputError if a division is out of range.
void check_division(const CountingDivision& division);

} // namespace dsc
