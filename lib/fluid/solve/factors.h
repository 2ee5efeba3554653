// SPDX-License-Identifier: MIT
// L D L' factorisation of the matrix of a mesh without pivoting: the multifrontal method (I. S.
// Duff, J. K. Reid, "The multifrontal solution of indefinite sparse symmetric linear equations",
// 1983) on the parts of a dissection. The matrix of a part is the sum of those of its halves; its
// inner unknowns are eliminated in a dense matrix, and the Schur complement couples the unknowns on
// its border.
#pragma once

#include "fluid/system/assembly.h"

#include <memory>

namespace dsc {

/// The factors of a part: its inner unknowns are eliminated.
struct PartFactors {
    std::uint32_t first = 0;                ///< inner unknown
    std::uint32_t count = 0;                ///< inner unknowns
    std::vector<std::uint32_t> border = {}; ///< the other unknowns of the part, ascending
    std::vector<double> lower =
        {}; ///< L by column without unit diagonal; rows: first + i, border[i]
    std::vector<double> pivots = {}; ///< D
    /// The Schur complement, until the enclosing part has used it: square, by column.
    std::unique_ptr<double[]> left = nullptr;

    /// The number of rows of L.
    [[nodiscard]] std::size_t height() const { return count + border.size(); }
};

/// The factors of a matrix.
struct Factors {
    bool has_all_pivots = true; ///< no pivot was zero or not finite
    std::vector<PartFactors> parts = {};
};

/// Factorises the matrix of the system minus `pressure_mass` times the scale of each pressure on
/// the diagonal. O(n^1.5). Bitwise identical on any processor and for any number of threads.
[[nodiscard]] Factors factorise(const FluidSystem& system, const Dissection& dissection,
                                const FluidNumbering& numbers, double pressure_mass,
                                std::uint32_t threads);

/// Replaces a right-hand side by the solution. O(entries of the factors).
void solve_in_place(const Factors& factors, Eigen::VectorXd& vector);

} // namespace dsc
