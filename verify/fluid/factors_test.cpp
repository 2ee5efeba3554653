// SPDX-License-Identifier: MIT
// The factorisation against the matrix it was made from.
#include "fluid/factors.h"

#include <gtest/gtest.h>

#include <random>

namespace dsc::factors_test {
namespace {

// Positive and negative definite parts that are coupled at random: no order of elimination meets a
// pivot of zero.
Eigen::SparseMatrix<double> quasi_definite(int size, int couplings, std::mt19937& random) {
    std::uniform_int_distribution<int> row(0, size - 1);
    std::uniform_real_distribution<double> entry(-1, 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) {
        entries.emplace_back(i, i, i % 3 == 0 ? -0.01 : 0.01);
    }
    for (int k = 0; k < couplings; ++k) {
        const int i = row(random);
        const int j = row(random);
        const double value = entry(random);
        entries.emplace_back(std::max(i, j), std::min(i, j), i == j ? 0 : value);
        if (i % 3 == 0 && j % 3 != 0) {
            continue;
        }
        if (i % 3 != 0 && j % 3 == 0) {
            continue;
        }
        // Within a part, dominated by the diagonal.
        const double sign = i % 3 == 0 ? -1 : 1;
        entries.emplace_back(i, i, sign * std::abs(value));
        entries.emplace_back(j, j, sign * std::abs(value));
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

TEST(FluidFactors, SolveWhatTheyWereMadeFrom) {
    std::mt19937 random(7);
    for (const int size : {1, 2, 5, 17, 60, 300}) {
        for (const int couplings : {0, size / 2, 2 * size, 20 * size}) {
            const auto matrix = quasi_definite(size, couplings, random);
            const SparseFactors factors = factorise(matrix);
            ASSERT_TRUE(factors.has_all_pivots);
            Eigen::VectorXd exact(size);
            for (int i = 0; i < size; ++i) {
                exact[i] = i % 7 - 3;
            }
            const Eigen::VectorXd forces = matrix.selfadjointView<Eigen::Lower>() * exact;
            Eigen::VectorXd solution = forces;
            solve_in_place(factors, solution);
            const Eigen::VectorXd residual =
                forces - matrix.selfadjointView<Eigen::Lower>() * solution;
            for (int i = 0; i < size; ++i) {
                EXPECT_NEAR(residual[i], 0, 1e-9) << size << " rows, " << couplings << " entries";
            }
        }
    }
}

TEST(FluidFactors, APivotOfZeroIsTold) {
    Eigen::SparseMatrix<double> matrix(2, 2);
    matrix.insert(0, 0) = 0;
    matrix.insert(1, 0) = 1;
    matrix.makeCompressed();
    EXPECT_FALSE(factorise(matrix).has_all_pivots);
}

} // namespace
} // namespace dsc::factors_test
