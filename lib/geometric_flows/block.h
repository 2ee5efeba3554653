// SPDX-License-Identifier: MIT
// Vectors of the plane, and matrices of two rows and two columns, in scalars.
#pragma once

#include "dsc/base/types.h"

#include <cmath>

namespace dsc {

/// A vector of the plane. It is used instead of Eigen's vectors, which are written number by number
/// and read as a whole: a read right after a write stalls the processor, and a foam takes a quarter
/// more time.
struct Vector2 {
    double x = 0;
    double y = 0;

    Vector2& operator+=(const Vector2& other) { return *this = {x + other.x, y + other.y}; }
    Vector2& operator-=(const Vector2& other) { return *this = {x - other.x, y - other.y}; }
    friend bool operator==(const Vector2&, const Vector2&) = default;
};

template <class Real>
[[nodiscard]] Vector2 vector_of(const Point<Real>& point) {
    return {static_cast<double>(point.x()), static_cast<double>(point.y())};
}

[[nodiscard]] constexpr Vector2 operator+(const Vector2& a, const Vector2& b) {
    return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] constexpr Vector2 operator-(const Vector2& a, const Vector2& b) {
    return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] constexpr Vector2 operator*(double factor, const Vector2& a) {
    return {factor * a.x, factor * a.y};
}
[[nodiscard]] constexpr Vector2 operator/(const Vector2& a, double divisor) {
    return {a.x / divisor, a.y / divisor};
}
[[nodiscard]] constexpr double dot(const Vector2& a, const Vector2& b) {
    return a.x * b.x + a.y * b.y;
}
[[nodiscard]] constexpr double cross(const Vector2& a, const Vector2& b) {
    return a.x * b.y - a.y * b.x;
}
[[nodiscard]] inline double norm(const Vector2& a) { return std::sqrt(dot(a, a)); }

/// A matrix of two rows and two columns. Its products are written out as well: Eigen's use fused
/// multiply-adds where the processor has them, and the result would depend on that.
struct Block {
    double xx = 0; ///< first row, first column
    double xy = 0; ///< first row, second column
    double yx = 0; ///< second row, first column
    double yy = 0; ///< second row, second column

    [[nodiscard]] Block transposed() const { return {xx, yx, xy, yy}; }
    /// The product with a column.
    [[nodiscard]] Vector2 of(const Vector2& column) const {
        return {xx * column.x + xy * column.y, yx * column.x + yy * column.y};
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

} // namespace dsc
