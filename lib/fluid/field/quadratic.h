// SPDX-License-Identifier: MIT
// Quadratic functions on a triangle, in barycentric coordinates: nodes 0 to 2 are the vertices,
// node 3 + i is the midpoint of the edge opposite to vertex i.
#pragma once

#include "dsc/dsc.h"

#include <array>

namespace dsc {

/// Barycentric coordinates of a point in a triangle; they add up to 1.
using Barycentric = std::array<double, 3>;

/// The six quadratic shape functions.
[[nodiscard]] inline Eigen::Matrix<double, 6, 1> quadratic_shapes(const Barycentric& at) {
    Eigen::Matrix<double, 6, 1> shapes;
    shapes << at[0] * (2 * at[0] - 1), at[1] * (2 * at[1] - 1), at[2] * (2 * at[2] - 1),
        4 * at[1] * at[2], 4 * at[2] * at[0], 4 * at[0] * at[1];
    return shapes;
}

/// The gradients of the shape functions as columns; those of `slopes` are the gradients of the
/// barycentric coordinates.
[[nodiscard]] inline Eigen::Matrix<double, 2, 6>
quadratic_gradients(const Barycentric& at, const Eigen::Matrix<double, 2, 3>& slopes) {
    Eigen::Matrix<double, 2, 6> gradients;
    for (const std::size_t i : {0U, 1U, 2U}) {
        const auto column = static_cast<Eigen::Index>(i);
        const Eigen::Index j = (column + 1) % 3;
        const Eigen::Index k = (column + 2) % 3;
        gradients.col(column) = (4 * at[i] - 1) * slopes.col(column);
        gradients.col(3 + column) =
            4 * (at[(i + 1) % 3] * slopes.col(k) + at[(i + 2) % 3] * slopes.col(j));
    }
    return gradients;
}

/// A point of a quadrature rule; the weights of a rule add up to 1.
struct QuadraturePoint {
    Barycentric at; ///< where
    double weight;  ///< its share
};

/// Exact for polynomials of degree 2: products of two gradients, and of a gradient and a linear
/// function.
inline constexpr std::array<QuadraturePoint, 3> points_of_degree_2{{
    {{0.0, 0.5, 0.5}, 1.0 / 3},
    {{0.5, 0.0, 0.5}, 1.0 / 3},
    {{0.5, 0.5, 0.0}, 1.0 / 3},
}};

/// Exact for degree 5, J. Radon (1948): the products of two shape functions, and velocities
/// interpolated in other meshes.
inline constexpr std::array<QuadraturePoint, 7> points_of_degree_5 = [] {
    constexpr double root = 3.872983346207417; // of 15
    std::array<QuadraturePoint, 7> points{{{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 9.0 / 40}}};
    std::size_t n = 1;
    for (const double sign : {-1.0, 1.0}) {
        const double a = (6 + sign * root) / 21;
        for (std::size_t i = 0; i < 3; ++i) {
            points[n].at = {a, a, a};
            points[n].at[i] = 1 - 2 * a;
            points[n].weight = (155 + sign * root) / 1200;
            ++n;
        }
    }
    return points;
}();

} // namespace dsc
