// SPDX-License-Identifier: MIT
#include "dsc/initial/build/lattice.h"

#include <algorithm>
#include <cmath>

namespace dsc::initial {

namespace {

// Height over base of an equilateral triangle.
constexpr double equilateral_height = 0.86602540378443865;

std::uint32_t nearest_count(double length, double step) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(length / step)));
}

// The triangles of a strip, from the left, are based on its odd row and on its even row in turn.
// Corner 0 is the apex; across the base lies the triangle of the same place in the next strip.
template <class Real>
void write_strip(const Lattice& lattice, std::uint32_t strip, Complex<Real>& complex) {
    const bool even_below = (strip & 1U) == 0;
    const std::uint32_t even = lattice.vertex(even_below ? strip : strip + 1, 0);
    const std::uint32_t odd = lattice.vertex(even_below ? strip + 1 : strip, 0);
    const std::uint32_t count = lattice.triangles_in_strip();
    const std::uint32_t first = lattice.first_triangle(strip);
    const auto across = [&](bool above, std::uint32_t place) {
        if (above) {
            return strip + 1 < lattice.rows ? corner_of(first + count + place, 0) : border_corner;
        }
        return strip > 0 ? corner_of(first - count + place, 0) : border_corner;
    };
    for (std::uint32_t place = 0; place < count; ++place) {
        const std::uint32_t i = place / 2;
        const std::uint32_t id = first + place;
        const bool on_odd_row = (place & 1U) == 0;
        const Corner left_1 = place > 0 ? corner_of(id - 1, 1) : border_corner;
        const Corner left_2 = place > 0 ? corner_of(id - 1, 2) : border_corner;
        const Corner right_1 = place + 1 < count ? corner_of(id + 1, 1) : border_corner;
        const Corner right_2 = place + 1 < count ? corner_of(id + 1, 2) : border_corner;
        TriangleRecord record;
        record.phase = exterior_phase;
        record.mark = 0;
        std::uint32_t apex = even + i;
        std::uint32_t left = odd + i;
        std::uint32_t right = odd + i + 1;
        if (!on_odd_row) {
            apex = odd + i + 1;
            left = even + i;
            right = even + i + 1;
        }
        const bool base_above = on_odd_row == even_below;
        if (base_above) {
            record.v = {apex, right, left};
            record.n = {across(true, place), left_1, right_2};
        } else {
            record.v = {apex, left, right};
            record.n = {across(false, place), right_1, left_2};
        }
        for (std::uint32_t k = 0; k < 3; ++k) {
            complex.vertices[record.v[k]].corner = corner_of(id, k);
        }
        complex.triangles.push_back(record);
    }
}

} // namespace

std::uint32_t Lattice::triangle_near(const Point<double>& point) const {
    const double strip = std::floor((point.y() - low.y()) / height);
    const double place = std::floor(2.0 * (point.x() - low.x()) / spacing);
    const auto clamp = [](double value, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(value, 0.0, static_cast<double>(count) - 1.0));
    };
    return first_triangle(clamp(strip, rows)) + clamp(place, triangles_in_strip());
}

Lattice fit_lattice(const Point<double>& low, const Point<double>& high, double edge_length) {
    Lattice lattice;
    lattice.low = low;
    lattice.high = high;
    const double width = high.x() - low.x();
    const double height = high.y() - low.y();
    lattice.columns = nearest_count(width, edge_length);
    lattice.spacing = width / lattice.columns;
    lattice.rows = nearest_count(height, equilateral_height * lattice.spacing);
    lattice.height = height / lattice.rows;
    return lattice;
}

template <class Real>
void write_lattice(const Lattice& lattice, std::size_t spare_vertices, Complex<Real>& complex) {
    const std::size_t vertex_total =
        lattice.vertex(lattice.rows, 0) + lattice.vertices_in_row(lattice.rows);
    const std::size_t triangle_total = std::size_t{lattice.rows} * lattice.triangles_in_strip();
    complex.reserve(vertex_total + spare_vertices, triangle_total + 2 * spare_vertices);
    for (std::uint32_t row = 0; row <= lattice.rows; ++row) {
        const auto y = static_cast<Real>(lattice.y(row));
        for (std::uint32_t column = 0; column < lattice.vertices_in_row(row); ++column) {
            complex.vertices.push_back(
                {static_cast<Real>(lattice.x(row, column)), y, no_id, 0, 0, no_id});
        }
    }
    for (std::uint32_t strip = 0; strip < lattice.rows; ++strip) {
        write_strip(lattice, strip, complex);
    }
    complex.attributes.resize_vertices(complex.vertices.size());
    complex.attributes.resize_triangles(complex.triangles.size());
}

template void write_lattice(const Lattice&, std::size_t, Complex<double>&);
template void write_lattice(const Lattice&, std::size_t, Complex<float>&);

} // namespace dsc::initial
