// SPDX-License-Identifier: MIT
// The first complex of a scene: a box with any number of shapes, each with its phase. A lattice of
// cubes of six tets each (H. W. Kuhn 1960) is bisected at longest edges until it is fine near the
// shapes and coarse elsewhere (M.-C. Rivara 1984); its vertices near a shape snap to it, edges that
// cross it are cut, and the mesh is improved.
#pragma once

#include "dsc3/complex/complex.h"

#include <functional>
#include <initializer_list>
#include <span>
#include <vector>

namespace dsc3 {

/// The signed distance to the surface of a shape: negative inside, positive outside. It may be
/// approximate; away from the surface it only determines how long edges may be.
using Distance = std::function<Real(const Point&)>;

/// What a shape makes of a phase.
struct PhaseChange {
    Phase from;
    Phase to;
};

/// A region and its phase.
struct Shape {
    Distance distance;
    Phase phase = 1; ///< inside; differs from the phase around it
    /// If given, only these phases change inside the shape, and `phase` does not count: the surface
    /// of the shape divides them, and ends at their surfaces in junction curves.
    std::vector<PhaseChange> divides = {};
};

/// A ball.
[[nodiscard]] Distance ball(const Point& centre, Real radius);

/// A box with sides parallel to the axes.
struct Box {
    Point low{0.0, 0.0, 0.0};  ///< the corner of the smallest coordinates
    Point high{1.0, 1.0, 1.0}; ///< the corner of the largest coordinates
};

/// How fine the first complex is, and how much it is improved.
struct InitialOptions {
    Real edge_length = 0.05; ///< of the interface, in units of the coordinates
    Real growth = 0.7;       ///< of the largest edge length per distance to the nearest shape
    int improve_rounds = 4;  ///< rounds of interface remeshing and mesh repair
    bool renumber = true;    ///< order ids along a space-filling curve
    Real max_tets = 2e7;     ///< more are refused: about four gigabytes
};

/// Fills `domain` with tets, with the surfaces of `shapes` as the interface, which ends on the
/// sides of the domain where a shape reaches beyond them. Where a shape lies inside another, the
/// later one counts. The same input gives bitwise identical meshes.
///
/// \throw InputError if a side or the edge length is out of range, more than `max_tets` tets are
/// needed, or a shape is nearer than two edge lengths to another that it does not divide, or is too
/// small for the mesh.
[[nodiscard]] Complex initial_complex(const Box& domain, std::span<const Shape> shapes,
                                      const InitialOptions& options = {});

/// The same for a list of shapes in braces.
[[nodiscard]] inline Complex initial_complex(const Box& domain, std::initializer_list<Shape> shapes,
                                             const InitialOptions& options = {}) {
    return initial_complex(domain, std::span(shapes.begin(), shapes.size()), options);
}

} // namespace dsc3
