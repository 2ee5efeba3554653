// SPDX-License-Identifier: MIT
// The background of the initial complex: rows of near-equilateral triangles that fill a rectangle,
// every other row shifted by half a triangle. Ids, positions and neighbours are arithmetic.
#pragma once

#include "dsc/complex/complex.h"

namespace dsc::initial {

/// Even rows have their vertices at the multiples of `spacing`; odd rows halfway between them, and
/// one at either side of the rectangle.
struct Lattice {
    Point<double> low;
    Point<double> high;
    std::uint32_t columns = 1; ///< whole triangle bases in a row
    std::uint32_t rows = 1;    ///< strips of triangles
    double spacing = 1;
    double height = 1; ///< of a strip

    [[nodiscard]] std::uint32_t vertices_in_row(std::uint32_t row) const {
        return columns + 1 + (row & 1U);
    }
    [[nodiscard]] std::uint32_t vertex(std::uint32_t row, std::uint32_t column) const {
        return row * (columns + 1) + row / 2 + column;
    }
    [[nodiscard]] std::uint32_t triangles_in_strip() const { return 2 * columns + 1; }
    /// The first triangle of a strip; the border is triangle 0.
    [[nodiscard]] std::uint32_t first_triangle(std::uint32_t strip) const {
        return 1 + strip * triangles_in_strip();
    }
    /// A triangle near the point, by arithmetic.
    [[nodiscard]] std::uint32_t triangle_near(const Point<double>& point) const;
    [[nodiscard]] double x(std::uint32_t row, std::uint32_t column) const {
        if (column == 0) {
            return low.x();
        }
        if (column + 1 == vertices_in_row(row)) {
            return high.x();
        }
        return low.x() + spacing * (static_cast<double>(column) - ((row & 1U) != 0 ? 0.5 : 0.0));
    }
    [[nodiscard]] double y(std::uint32_t row) const {
        return row == rows ? high.y() : low.y() + height * static_cast<double>(row);
    }
};

/// The lattice whose spacing comes closest to the target edge length.
Lattice fit_lattice(const Point<double>& low, const Point<double>& high, double edge_length);

/// Writes the whole lattice, in `exterior_phase`, into an empty complex with room for so many
/// vertices (and twice as many triangles) more. O(1) per triangle.
template <class Real>
void write_lattice(const Lattice& lattice, std::size_t spare_vertices, Complex<Real>& complex);

} // namespace dsc::initial
