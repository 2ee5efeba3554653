// SPDX-License-Identifier: MIT
// A sparse factorisation for matrices that mostly have the same pattern as the one before.
#pragma once

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <vector>

namespace dsc {

/// Solves with symmetric matrices that have factors without pivots, of which it reads the lower
/// half. The order of elimination depends on the pattern alone, and is computed again only if the
/// pattern changes.
class SparseSolver {
public:
    using Matrix = Eigen::SparseMatrix<double>;
    using Entries = std::vector<Eigen::Triplet<double>>;

    /// Factorises the matrix of these entries; entries in one place are added. False if it has no
    /// factors. O(entries), and the factorisation.
    bool factorise(Eigen::Index size, const Entries& entries);
    /// Whether the last factorisation succeeded.
    [[nodiscard]] bool is_solvable() const { return solver_.info() == Eigen::Success; }
    /// Solves by the last factorisation, which must have succeeded.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& column) const {
        return order_.inverse() * solver_.solve(order_ * column).eval();
    }

private:
    /// Where an entry goes.
    struct Slot {
        int row;
        int column;
        int value; ///< place among the values of `ordered_`
    };

    [[nodiscard]] bool has_known_slots(Eigen::Index size, const Entries& entries) const;
    [[nodiscard]] bool has_known_pattern(const Matrix& lower) const;
    void find_slots(Eigen::Index size, const Entries& entries);
    void find_order(const Matrix& lower);

    std::vector<Slot> slots_; ///< by entry
    Matrix analysed_;         ///< a lower half whose pattern the solver knows
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;
    Matrix ordered_; ///< the upper half, in the order of elimination
    Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> solver_;
};

} // namespace dsc
