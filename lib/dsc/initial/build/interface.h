// SPDX-License-Identifier: MIT
// Puts the interface into the lattice: makes room for it, inserts its points, makes its pieces
// edges of the triangulation, and gives each region between them the phase that the paths around it
// name.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/initial/input/input_check.h"

#include <span>
#include <vector>

namespace dsc::initial {

/// A path by the ids of its vertices, one chain for each path.
using Chain = std::vector<std::uint32_t>;
using Chains = std::vector<Chain>;

/// Removes the lattice's inner vertices that are closer to a piece of a path than `clearance` times
/// the length of that piece. Only for a lattice that is unchanged since `write_lattice`. O(1) per
/// piece.
template <class Real>
void clear_lattice(Complex<Real>& complex, const Lattice& lattice,
                   std::span<const CheckedPath> paths, double clearance);

/// Inserts all points of the paths; for each path the ids of its vertices, in order.
template <class Real>
Chains insert_paths(Complex<Real>& complex, const Lattice& lattice,
                    std::span<const CheckedPath> paths);

/// Makes each link of the chains an edge: edges that cross a missing one are flipped until none is
/// left (S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993).
/// A vertex that lies exactly on a link becomes part of the chain. Links must not cross. Returns
/// the vertices around which edges were flipped: there the triangulation may not be Delaunay any
/// more. O(crossed edges) for each missing link, if they are few.
template <class Real>
std::vector<std::uint32_t> recover_segments(Complex<Real>& complex, Chains& chains);

/// Gives each region between the paths the phase that they name; a region that no path names keeps
/// its phase. All marks of triangles must be 0, and are 0 afterwards. Throws InputError if two
/// paths name different phases for one region, or one has the same phase on both sides.
/// O(triangles).
template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const CheckedPath> paths, const Chains& chains);

/// The vertices of the chains, the first of each last. A junction occurs once for each of its
/// chains.
inline std::vector<std::uint32_t> vertices_on(const Chains& chains) {
    std::vector<std::uint32_t> result;
    for (const Chain& chain : chains) {
        result.insert(result.end(), chain.begin() + 1, chain.end());
        if (chain.front() != chain.back()) {
            result.push_back(chain.front());
        }
    }
    return result;
}

} // namespace dsc::initial
