// SPDX-License-Identifier: MIT
// The pieces of the interface as walls that stop a flood, while the phases do not tell them yet.
#pragma once

#include "dsc/base/error.h"
#include "dsc/complex/complex.h"
#include "dsc/initial/build/chains.h"

namespace dsc::initial {

/// A piece by the corners opposite to it, in the triangles on the left and on the right of its way.
struct Wall {
    Corner left;
    Corner right;
    std::uint32_t chain; ///< of which it is a piece
};

/// Bit i of a triangle's mark: the edge opposite to its corner i is a wall.
template <class Real>
bool is_wall(const Complex<Real>& complex, Corner corner) {
    return (complex.triangles[triangle_of(corner)].mark >> index_of(corner) & 1U) != 0;
}

/// Marks all pieces, in the order of the chains. All marks must be 0. O(pieces).
template <class Real>
std::vector<Wall> raise_walls(Complex<Real>& complex, const Chains& chains) {
    std::vector<Wall> walls;
    for (std::uint32_t k = 0; k < chains.size(); ++k) {
        for (std::size_t i = 0; i + 1 < chains[k].size(); ++i) {
            const Corner left =
                complex.find_half_edge(Vertex{chains[k][i]}, Vertex{chains[k][i + 1]});
            if (left == no_id || is_border(complex.twin(left))) {
                throw InvariantError("raise_walls: a piece of the interface is no inner edge");
            }
            walls.push_back({left, complex.twin(left), k});
            for (const Corner c : {walls.back().left, walls.back().right}) {
                complex.triangles[triangle_of(c)].mark |= 1U << index_of(c);
            }
        }
    }
    return walls;
}

/// All marks are 0 again.
template <class Real>
void remove_walls(Complex<Real>& complex, const std::vector<Wall>& walls) {
    for (const Wall& wall : walls) {
        complex.triangles[triangle_of(wall.left)].mark = 0;
        complex.triangles[triangle_of(wall.right)].mark = 0;
    }
}

/// Visits the triangles that can be reached from those on `stack` without crossing a wall:
/// `enter(triangle)` says whether it is seen for the first time. Empties the stack.
template <class Real, class Enter>
void flood(const Complex<Real>& complex, std::vector<std::uint32_t>& stack, Enter enter) {
    while (!stack.empty()) {
        const std::uint32_t from = stack.back();
        stack.pop_back();
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner corner = corner_of(from, i);
            const Corner other = complex.twin(corner);
            if (!is_wall(complex, corner) && !is_border(other) && enter(triangle_of(other))) {
                stack.push_back(triangle_of(other));
            }
        }
    }
}

} // namespace dsc::initial
