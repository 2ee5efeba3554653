// SPDX-License-Identifier: MIT
// Functions shared by creating and merging submeshes.
#pragma once

#include "dsc/complex/complex.h"

#include <utility>
#include <vector>

namespace dsc::copying {

// The same attributes without entries.
inline AttributeSet without_entries(const AttributeSet& attributes) {
    AttributeSet empty;
    for (const auto& each : attributes.list()) {
        auto copy = each->clone_empty();
        copy->set_field(each->is_field(), each->on_interface());
        empty.add(std::move(copy));
    }
    return empty;
}

// Appends the entries order[i] of a set that has the same attributes; no_id: the initial value.
// Call `count_entries` after the last one.
inline void append(AttributeSet& to, SimplexKind kind, const AttributeSet& from,
                   const std::vector<std::uint32_t>& order) {
    for (std::size_t i = 0; i < to.list().size(); ++i) {
        if (to.list()[i]->kind() == kind) {
            to.list()[i]->append(*from.list()[i], order);
        }
    }
}

// Copies the data of triangles, and of their edges, which are stored at corners.
inline void append_triangles(AttributeSet& to, const AttributeSet& from,
                             const std::vector<std::uint32_t>& order,
                             std::vector<std::uint32_t>& corner_order) {
    append(to, SimplexKind::triangle, from, order);
    if (to.empty(SimplexKind::edge)) {
        return;
    }
    corner_order.clear();
    corner_order.reserve(4 * order.size());
    for (const std::uint32_t triangle : order) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            corner_order.push_back(triangle == no_id ? no_id : corner_of(triangle, i));
        }
    }
    append(to, SimplexKind::edge, from, corner_order);
}

// Tells the attributes how many simplices there are: new attributes get as many entries.
template <class Real>
void count_entries(Complex<Real>& complex) {
    complex.attributes.resize_vertices(complex.vertices.size());
    complex.attributes.resize_triangles(complex.triangles.size());
}

// The record of the border, as a new complex has it.
template <class Real>
void clear(Complex<Real>& complex) {
    complex.vertices.clear();
    complex.triangles.assign(
        1, {{0, 0, 0}, {border_corner, border_corner, border_corner}, border_phase, 0});
    complex.ids.clear();
}

} // namespace dsc::copying
