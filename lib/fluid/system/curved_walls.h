// SPDX-License-Identifier: MIT
// Walls on curved sides: between two vertices the wall lies off the edge of the mesh, and the fluid
// there moves relative to it. Boundary-value correction: J. H. Bramble, T. Dupont and V. Thomée,
// "Projection methods for Dirichlet's problem in approximating polygonal domains with
// boundary-value corrections" (1972). It makes the velocity of third order in the edge length.
#pragma once

#include "fluid/field/snapshot_field.h"

namespace dsc {

/// The way from the middle of the edge from `from` to `to` of the boundary to the curve through its
/// vertices: the mean of the circles through either end and its two neighbours, of which `before`
/// and `after` are the others. Zero where the side goes on straight at one of the ends, or neither
/// has a tangent. O(log n).
[[nodiscard]] Point<double> sagitta_of(const MeshSnapshot& mesh, std::uint32_t before,
                                       std::uint32_t from, std::uint32_t to, std::uint32_t after);

/// The change of the last velocity along the way `sagitta` at the node `middle` of a triangle of
/// `mesh`, on the edge between two vertices of the boundary. Where the triangle is flat, it is
/// limited to a quarter of its height: as the change determines the next velocity there, the error
/// of more than half of it would grow from step to step. O(1) if the search is short.
[[nodiscard]] Point<double> change_to_wall(const FluidField& last, const MeshSnapshot& mesh,
                                           const SnapshotTriangle& triangle, std::uint32_t middle,
                                           const Point<double>& sagitta);

} // namespace dsc
