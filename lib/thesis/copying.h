// SPDX-License-Identifier: MIT
// What creating and merging submeshes share.
#pragma once

#include "dsc/complex/complex.h"

#include <algorithm>
#include <vector>

namespace dsc::copying {

inline bool has_edges(const AttributeSet& attributes) {
    return std::any_of(attributes.list().begin(), attributes.list().end(),
                       [](const auto& each) { return each->kind() == SimplexKind::edge; });
}

// Copies the data of triangles, and of their edges, which are stored at corners.
inline void append_triangles(AttributeSet& to, const AttributeSet& from,
                             const std::vector<std::uint32_t>& order,
                             std::vector<std::uint32_t>& corner_order) {
    to.append(SimplexKind::triangle, from, order);
    if (!has_edges(to)) {
        return;
    }
    corner_order.clear();
    corner_order.reserve(4 * order.size());
    for (const std::uint32_t triangle : order) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            corner_order.push_back(triangle == no_id ? no_id : corner_of(triangle, i));
        }
    }
    to.append(SimplexKind::edge, from, corner_order);
}

// The record of the border, as a new complex has it.
template <class Real>
void clear(Complex<Real>& complex) {
    complex.vertices.clear();
    complex.triangles.assign(
        1, {{0, 0, 0}, {border_corner, border_corner, border_corner}, border_phase, 0});
    complex.ids.vertices.clear();
    complex.ids.triangles.clear();
    complex.lent_vertices = 0;
    complex.lent_triangles = 0;
}

} // namespace dsc::copying
