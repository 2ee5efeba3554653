// SPDX-License-Identifier: MIT
// Solves the linear systems of a network of curves, whose matrix has a block of two rows for each
// vertex and one for each edge: it is eliminated along each curve, junctions last.
#pragma once

#include "geometric_flows/block.h"
#include "geometric_flows/curve_graph.h"
#include "geometric_flows/sparse_solver.h"

#include <span>
#include <vector>

namespace dsc {

/// How the pressures beside a curve act on it. The force at a vertex is its push times the
/// pressure on the left minus that on the right. The displacement of a vertex times the same push
/// is the area that the left gains and the right loses.
struct CurvePush {
    int left = -1;     ///< index of that pressure, or -1 if there is none
    int right = -1;    ///< the same
    Vector2 at_from{}; ///< the push on its first anchor, unless the curve is a loop
    Vector2 at_to{};   ///< on its last one
};

/// Pressures that keep areas, as further unknowns: the vertices that they push, and the required
/// areas.
struct PressureRows {
    std::span<CurvePush> pushes;   ///< by curve
    std::span<Vector2> columns;    ///< the push by vertex, except at junctions
    std::span<const double> gains; ///< by pressure: the required growth of its area
    std::span<double> pressures;   ///< by pressure: the solution
};

/// A block elimination in the order of the curves (Cholesky's method for a block tridiagonal matrix
/// with a border). It leaves a sparse system of the junctions, and of pressures where there are
/// any. Without pivots: the matrix has to be symmetric and positive definite. One solver serves
/// many networks, one after the other, and reuses its memory. Its result does not depend on
/// threads: the caller adds the contributions of curves at a junction in a fixed order.
///
/// To solve, eliminate and reduce each share, then factorise the junctions, then finish. `diagonal`
/// has the block of each vertex, `coupling` that of each edge: rows of its first vertex, columns of
/// its second. There is one column a vertex, solved for in place.
class CurveSolver {
public:
    /// Begins with a graph, which must live as long as it is solved for. O(1), except for
    /// allocation.
    void begin(const CurveGraph& graph);

    /// Eliminates the curves of a share. Reads no block of a junction. O(vertices).
    void eliminate(std::size_t share, std::span<const Block> diagonal,
                   std::span<const Block> coupling);
    /// The forward substitution in a share that is eliminated, except at junctions. O(vertices).
    void reduce(std::size_t share, std::span<Vector2> columns);
    /// The same for pressures, whose columns and anchors' pushes it changes. O(vertices).
    void reduce(std::size_t share, std::span<const Vector2> columns, const PressureRows& rows);
    /// Factorises the sparse system of the junctions, after all shares are reduced. No rows: no
    /// pressures.
    void factorise_junctions(std::span<const Block> diagonal, const PressureRows& rows = {});
    /// Solves for columns that are reduced in all shares. A closed curve without a solution becomes
    /// NaN; so do all other vertices where the curves between junctions have none. O(vertices).
    void finish(std::span<Vector2> columns, const InShares& in_shares,
                const PressureRows& rows = {});

private:
    /// The factors of a vertex between two anchors.
    struct Factor {
        Block inverse{};   ///< of its block after elimination
        Block to_before{}; ///< block with the vertex before
        Block to_first{};  ///< block with the first anchor
    };
    /// The contributions of a curve to its anchors and to pressures.
    struct Remainder {
        Block to_last{}; ///< block of its last vertex with the last anchor
        Block at_first{};
        Block at_last{};
        Block across{};      ///< rows of the last one
        Block cut_inverse{}; ///< of a loop
        double yielding = 0; ///< the area that the curve alone gains for a unit of pressure
        double gained = 0;   ///< what it gains without pressure
    };

    void eliminate_curve(std::size_t curve, std::span<const Block> diagonal,
                         std::span<const Block> coupling);
    void gather(std::size_t curve, std::span<Vector2> columns) const;
    void add_block(std::uint32_t row, std::uint32_t column, const Block& block);
    void add_pressures(const PressureRows& rows);
    void solve_junctions(std::span<Vector2> columns, const PressureRows& rows) const;

    const CurveGraph* graph_ = nullptr;
    std::vector<Factor> factors_;  ///< by place
    std::vector<Remainder> rests_; ///< by curve
    std::vector<Vector2> to_from_; ///< by place: subtracted from the column of `from`
    std::vector<Block> left_;      ///< diagonal blocks of the junctions
    std::vector<double> yielding_; ///< of pressures
    std::vector<Eigen::Triplet<double>> entries_;
    SparseSolver junction_solver_;
};

} // namespace dsc
