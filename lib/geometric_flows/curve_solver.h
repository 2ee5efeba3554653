// SPDX-License-Identifier: MIT
// Solves the linear systems of a network of curves, whose matrix has a block of two rows for each
// vertex and one for each edge: it is eliminated along each curve, junctions last. Between its
// junctions no curve depends on another, so that threads share the curves.
#pragma once

#include "dsc/base/types.h"
#include "dsc/motion/interface_flow.h"

#include "geometric_flows/sparse_solver.h"

#include <array>
#include <cstdint>
#include <functional>
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

/// A part of a network: whole curves, or all junctions.
struct CurvePart {
    std::span<const std::uint32_t> vertices;
    std::span<const std::uint32_t> edges; ///< all that the vertices have
    bool are_junctions = false;           ///< the vertices; otherwise none of them is one
};

/// A block elimination in the order of the curves (Cholesky's method for a block tridiagonal matrix
/// with a border). It leaves a sparse system of the junctions alone; a closed curve is cut at one
/// of its vertices. Without pivots: the matrix has to be symmetric and positive definite. One
/// solver serves many networks, one after the other, and reuses its memory. Its result does not
/// depend on threads: what curves leave at a junction is added up in one order, by the caller.
class CurveSolver {
public:
    /// Finds the curves of a network, and puts them into shares. The network and the threads of
    /// `in_shares` must live as long as it is solved for. O(vertices and edges).
    void begin(const CurveNetwork& network, const InShares& in_shares);

    /// Calls `task(share)` for each share of the curves, on several threads.
    template <class Task>
    void for_each_share(const Task& task) const;
    /// The curves in a share. No other share has any of their vertices.
    [[nodiscard]] CurvePart part(std::size_t share) const;
    /// What no share has, with edges in the order of the network.
    [[nodiscard]] CurvePart junctions() const { return {junctions_, arms_, true}; }
    /// Whether it counts as a junction: as one of the network, or without just two edges.
    [[nodiscard]] bool is_junction(std::uint32_t vertex) const { return number_[vertex] != no_id; }

    // To solve is to eliminate and to reduce each share, then to factorise the junctions, and to
    // finish. `diagonal` has the block of each vertex, `coupling` that of each edge: rows of its
    // first vertex, columns of its second. There is one column a vertex, solved for in place.

    /// Eliminates the curves of a share. Reads no block of a junction. O(vertices).
    void eliminate(std::size_t share, std::span<const Block> diagonal,
                   std::span<const Block> coupling);
    /// Of what is left when all shares are eliminated: a sparse factorisation.
    void factorise_junctions(std::span<const Block> diagonal, std::span<const Block> coupling);
    /// The forward substitution in a share that is eliminated, but at junctions. O(vertices).
    void reduce(std::size_t share, std::span<Point<double>> columns);
    /// Solves for columns that are reduced in all shares. A closed curve without a solution becomes
    /// NaN; so do all other vertices where the curves between junctions have none. O(vertices).
    void finish(std::span<Point<double>> columns);
    /// Reduces and finishes columns, once there are factors of all. O(vertices).
    void solve(std::span<Point<double>> columns);

private:
    /// An edge as seen from one of its ends, which has the rows of the block.
    struct Side {
        std::uint32_t edge;
        bool is_first; ///< the end is the first vertex of the edge
    };
    /// What a curve leaves at its anchors.
    struct Remainder {
        Block at_first{};
        Block at_last{};
        Block across{}; ///< rows of the last one
    };
    /// Successive vertices between two anchors, which are junctions, or twice the cut of a loop.
    struct Curve {
        std::size_t begin;  ///< of its places
        std::size_t end;    ///< of its places
        std::uint32_t from; ///< the anchor before the first vertex
        std::uint32_t to;   ///< the anchor after the last one
        Side last;          ///< from the last vertex to `to`
        bool is_loop;
        Block to_last{}; ///< block of `last`
        Remainder rest{};
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
    /// Where a share ends in the lists; the next one begins there.
    struct ShareEnd {
        std::size_t curves = 0;
        std::size_t vertices = 0;
        std::size_t edges = 0;
    };

    void find_sides();
    void find_curves();
    void follow(std::uint32_t anchor, std::uint32_t edge);
    [[nodiscard]] std::uint32_t far_end(std::uint32_t edge, std::uint32_t vertex) const;
    void end_share() { ends_.push_back({curves_.size(), vertices_.size(), edges_.size()}); }
    [[nodiscard]] std::size_t shares() const { return ends_.size() - 1; }
    [[nodiscard]] std::span<Curve> curves_of(std::size_t share);
    [[nodiscard]] std::span<const Curve> between_junctions() const {
        return std::span(curves_).first(first_loop_);
    }
    void eliminate(Curve& curve, std::span<const Block> diagonal, std::span<const Block> coupling);
    void gather(const Curve& curve, std::span<Point<double>> columns) const;
    void solve_junctions(std::span<Point<double>> columns) const;
    void add_block(std::uint32_t row, std::uint32_t column, const Block& block);

    const CurveNetwork* network_ = nullptr;
    const InShares* in_shares_ = nullptr;
    std::vector<std::uint32_t> degree_;                  ///< edges at each vertex
    std::vector<std::array<std::uint32_t, 2>> edges_at_; ///< of each vertex that has just two
    std::vector<std::uint8_t> is_taken_;                 ///< by edge: it is part of a curve
    std::vector<Curve> curves_;                          ///< loops last
    std::size_t first_loop_ = 0;
    std::vector<Place> places_;           ///< curve by curve
    std::vector<std::uint32_t> vertices_; ///< curve by curve, with the cuts of loops
    std::vector<std::uint32_t> edges_;    ///< curve by curve
    std::vector<ShareEnd> ends_;          ///< of shares; before them where the first one begins
    std::vector<std::uint32_t> junctions_;
    std::vector<std::uint32_t> number_; ///< of the junction at a vertex, or no_id
    std::vector<std::uint32_t> arms_;   ///< edges with a junction, or two

    std::vector<Point<double>> to_from_; ///< by place: what it takes from the column of `from`
    std::vector<Block> left_;            ///< diagonal blocks of the junctions
    std::vector<Eigen::Triplet<double>> entries_;
    SparseSolver junction_solver_;
};

template <class Task>
void CurveSolver::for_each_share(const Task& task) const {
    if (shares() == 1) {
        task(std::size_t{0});
    } else if (shares() > 1) {
        (*in_shares_)(shares(), std::cref(task)); // by reference: no allocation
    }
}

} // namespace dsc
