// SPDX-License-Identifier: MIT
// Solves the linear systems of a network of curves, whose matrix has a block of two rows for each
// vertex and one for each edge: it is eliminated along each curve, junctions last.
#pragma once

#include "dsc/base/types.h"

#include "geometric_flows/sparse_solver.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

struct CurveNetwork;

/// A matrix of two rows and two columns. Its products are written out: Eigen fuses the additions of
/// its own where the processor can, and the result would depend on that.
struct Block {
    double xx = 0; ///< first row, first column
    double xy = 0; ///< first row, second column
    double yx = 0; ///< second row, first column
    double yy = 0; ///< second row, second column

    [[nodiscard]] Block transposed() const { return {xx, yx, xy, yy}; }
    /// The product with a column.
    [[nodiscard]] Point<double> of(const Point<double>& p) const {
        return {xx * p.x() + xy * p.y(), yx * p.x() + yy * p.y()};
    }
    Block& operator+=(const Block& other) {
        xx += other.xx;
        xy += other.xy;
        yx += other.yx;
        yy += other.yy;
        return *this;
    }
};

[[nodiscard]] constexpr Block operator-(const Block& a) { return {-a.xx, -a.xy, -a.yx, -a.yy}; }
[[nodiscard]] constexpr Block operator*(const Block& a, const Block& b) {
    return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx,
            a.yx * b.xy + a.yy * b.yy};
}

/// A block elimination in the order of the curves (Cholesky's method for a block tridiagonal matrix
/// with a border). It leaves a sparse system of the junctions alone; a closed curve is cut at one
/// of its vertices. Without pivots: the matrix has to be symmetric and positive definite. One
/// solver serves many networks, one after the other, and reuses its memory.
class CurveSolver {
public:
    /// Finds the curves of a network, which must live as long as it is solved for. O(vertices and
    /// edges).
    void begin(const CurveNetwork& network);

    /// `diagonal` has the block of each vertex, `coupling` that of each edge: rows of its first
    /// vertex, columns of its second. O(vertices), and a sparse factorisation of the junctions.
    void factorise(std::span<const Block> diagonal, std::span<const Block> coupling);

    /// Solves for one column a vertex, in place. A closed curve without a solution becomes NaN; so
    /// do all other vertices where the curves between junctions have none. O(vertices).
    void solve(std::span<Point<double>> columns) const;

private:
    /// An edge as seen from one of its ends, which has the rows of the block.
    struct Side {
        std::uint32_t edge;
        bool is_first; ///< the end is the first vertex of the edge
    };
    /// Successive vertices between two anchors, which are junctions, or twice the cut of a loop.
    struct Curve {
        std::size_t begin;   ///< of its places
        std::size_t end;     ///< of its places
        std::uint32_t from;  ///< the anchor before the first vertex
        std::uint32_t to;    ///< the anchor after the last one
        Side last;           ///< from the last vertex to `to`
        Block to_last{};     ///< its block
        Block cut_inverse{}; ///< of a loop
    };
    /// A vertex between two anchors, and its factors.
    struct Place {
        std::uint32_t vertex;
        Side before;       ///< to the vertex before it, or the first anchor
        Block inverse{};   ///< of what is left of its block
        Block to_before{}; ///< block with the vertex before
        Block to_first{};  ///< block with the first anchor
    };
    /// What a curve leaves at its anchors.
    struct Remainder {
        Block at_first{};
        Block at_last{};
        Block across{}; ///< rows of the last one
    };

    void find_sides();
    void find_curves();
    void follow(std::uint32_t anchor, std::uint32_t edge);
    [[nodiscard]] std::uint32_t far_end(std::uint32_t edge, std::uint32_t vertex) const;
    [[nodiscard]] Remainder eliminate(Curve& curve, std::span<const Block> diagonal,
                                      std::span<const Block> coupling);
    void factorise_junctions();
    void solve_junctions(std::span<Point<double>> columns) const;
    void add_block(std::uint32_t row, std::uint32_t column, const Block& block);

    const CurveNetwork* network_ = nullptr;
    std::vector<std::uint32_t> degree_;                  ///< edges at each vertex
    std::vector<std::array<std::uint32_t, 2>> edges_at_; ///< of each vertex that has just two
    std::vector<std::uint8_t> is_taken_;                 ///< by edge: it is part of a curve
    std::vector<Curve> loops_;
    std::vector<Curve> curves_; ///< between junctions
    std::vector<Place> places_; ///< curve by curve
    std::vector<std::uint32_t> junctions_;
    std::vector<std::uint32_t> number_;  ///< of the junction at a vertex, or no_id
    std::vector<std::uint32_t> bridges_; ///< edges between two junctions

    std::vector<Block> left_; ///< diagonal blocks of the junctions
    std::vector<Eigen::Triplet<double>> entries_;
    SparseSolver junction_solver_;
};

} // namespace dsc
