// SPDX-License-Identifier: MIT
// A sparse factorisation for matrices that mostly have the pattern of the one before.
#pragma once

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <vector>

namespace dsc {

/// Solves with symmetric, positive definite matrices, of which it reads the lower half. The order
/// of elimination depends on the pattern alone, and is found anew only where that has changed.
class SparseSolver {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /// Factorises the matrix of these entries, of which those in one place are added. False if it
    /// is not positive definite.
    bool factorise(Eigen::Index size, const std::vector<Eigen::Triplet<double>>& entries) {
        matrix_.resize(size, size);
        matrix_.setFromTriplets(entries.begin(), entries.end());
        if (!has_known_pattern()) {
            solver_.analyzePattern(matrix_);
            analysed_ = matrix_;
        }
        solver_.factorize(matrix_);
        return is_solvable();
    }
    /// Whether the last factorisation succeeded.
    [[nodiscard]] bool is_solvable() const { return solver_.info() == Eigen::Success; }
    /// Of the last factorisation, which must have succeeded.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& column) const {
        return solver_.solve(column);
    }

private:
    [[nodiscard]] bool has_known_pattern() const {
        const Matrix& a = matrix_;
        const Matrix& b = analysed_;
        return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
               std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
               std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
    }

    Matrix matrix_;
    Matrix analysed_; // one whose pattern the solver knows
    Eigen::SimplicialLDLT<Matrix> solver_;
};

} // namespace dsc
