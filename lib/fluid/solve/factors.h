// SPDX-License-Identifier: MIT
// L D L' of the matrix of a mesh without pivoting: the multifrontal method (I. S. Duff, J. K. Reid,
// "The multifrontal solution of indefinite sparse symmetric linear equations", 1983) on the parts
// of a dissection. The matrix of a part is the sum of those of its halves; its inner unknowns are
// eliminated in a dense matrix, and what is left couples the unknowns on its border.
#pragma once

#include "fluid/system/assembly.h"

#include <memory>

namespace dsc {

/// The inner unknowns of a part, eliminated.
struct PartFactors {
    std::uint32_t first = 0;                ///< inner unknown
    std::uint32_t count = 0;                ///< inner unknowns
    std::vector<std::uint32_t> border = {}; ///< the other unknowns of the part, ascending
    std::vector<double> lower = {};         ///< L by column, without its ones: first + i, border[i]
    std::vector<double> pivots = {};        ///< D
    /// What is left for the part that this one is a half of, until it is used: by column, square.
    std::unique_ptr<double[]> left = nullptr;

    /// The rows of L.
    [[nodiscard]] std::size_t height() const { return count + border.size(); }
};

/// The factors of a matrix.
struct Factors {
    bool has_all_pivots = true; ///< none was zero or not finite
    std::vector<PartFactors> parts = {};
};

/// Factorises the matrix of the system, less `pressure_mass` times the scale of each pressure on
/// the diagonal. O(n^1.5). The same bits on any processor and for any number of threads.
[[nodiscard]] Factors factorise(const FluidSystem& system, const Dissection& dissection,
                                const FluidNumbering& numbers, double pressure_mass,
                                std::uint32_t threads);

/// Replaces a right-hand side by the solution. O(entries of the factors).
void solve_in_place(const Factors& factors, Eigen::VectorXd& vector);

} // namespace dsc
