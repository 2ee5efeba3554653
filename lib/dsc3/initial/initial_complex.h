// SPDX-License-Identifier: MIT
// The complex that a scene starts from: a box with any number of shapes, each with its phase. A
// lattice of cubes of six tets each (H. W. Kuhn 1960) is bisected at longest edges until it is fine
// near the shapes and coarse elsewhere (M.-C. Rivara 1984); its vertices near a shape snap to it,
// edges that cross it are cut, and the mesh is improved.
#pragma once

#include "dsc3/complex/complex.h"

#include <functional>
#include <initializer_list>
#include <span>

namespace dsc3 {

/// Negative inside a shape, positive outside: the signed distance to its surface, or roughly so,
/// since it says how far away edges may be longer.
using Distance = std::function<Real(const Point&)>;

/// A region and its phase.
struct Shape {
    Distance distance;
    Phase phase = 1; ///< inside; differs from the phase around it
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
    Real growth = 0.7;       ///< of the longest edge with the distance to the nearest shape
    int improve_rounds = 4;  ///< rounds of interface remeshing and mesh repair
    bool renumber = true;    ///< order ids along a space-filling curve
};

/// Fills `domain` with tets, with the surfaces of `shapes` as the interface. Of shapes that lie
/// within each other the later one counts. The same input gives the same bits.
///
/// \throw InputError where a side or the edge length makes no sense, a shape reaches the sides of
/// the domain, comes nearer than two edge lengths to another, or is too small to be seen.
[[nodiscard]] Complex initial_complex(const Box& domain, std::span<const Shape> shapes,
                                      const InitialOptions& options = {});

/// The same for shapes in braces.
[[nodiscard]] inline Complex initial_complex(const Box& domain, std::initializer_list<Shape> shapes,
                                             const InitialOptions& options = {}) {
    return initial_complex(domain, std::span(shapes.begin(), shapes.size()), options);
}

} // namespace dsc3
