// SPDX-License-Identifier: MIT
// L D L' of a sparse symmetric matrix without pivoting: the multifrontal method (I. S. Duff,
// J. K. Reid, "The multifrontal solution of indefinite sparse symmetric linear equations", 1983).
// Columns that have the same rows are eliminated together in a dense matrix, which takes a fraction
// of the time of column by column.
#pragma once

#include "dsc/dsc.h"

#include <Eigen/SparseCore>

#include <vector>

namespace dsc {

/// Neighbouring columns with the same rows below them.
struct FrontColumns {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::vector<std::uint32_t> rows = {};     ///< below the last of the columns, ascending
    std::vector<std::uint32_t> children = {}; ///< fronts whose first row is one of these columns
    std::vector<double> lower = {};  ///< L by column, without its ones: first + i, then rows[i]
    std::vector<double> pivots = {}; ///< D

    /// The rows of the dense matrix: those of the columns themselves included.
    [[nodiscard]] std::size_t height() const { return count + rows.size(); }
};

/// The factors of a matrix.
struct SparseFactors {
    std::uint32_t size = 0;
    bool has_all_pivots = true; ///< none was zero or not finite
    std::vector<FrontColumns> fronts = {};
};

/// Factorises the symmetric matrix with this lower triangle, in the order of its columns. O(n^1.5)
/// for a mesh of n triangles in a good order. The same bits on any processor.
[[nodiscard]] SparseFactors factorise(const Eigen::SparseMatrix<double>& lower);

/// Replaces a right-hand side by the solution. O(entries of the factors).
void solve_in_place(const SparseFactors& factors, Eigen::VectorXd& vector);

} // namespace dsc
