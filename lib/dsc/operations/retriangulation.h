// SPDX-License-Identifier: MIT
// How a polygon inside the complex is triangulated.
#pragma once

#include <cstdint>
#include <string_view>

namespace dsc {

/// How a polygon is cut into triangles.
enum class RetriangulationMethod : std::uint8_t {
    ear_clipping, ///< the thesis's method; may leave slivers
    /// Ear clipping, then flips until it is the constrained Delaunay triangulation (C. L. Lawson,
    /// "Software for C1 surface interpolation", 1977), as the thesis asks in chapter 13.
    delaunay,
};

[[nodiscard]] constexpr std::string_view to_string(RetriangulationMethod method) {
    return method == RetriangulationMethod::ear_clipping ? "ear_clipping" : "delaunay";
}

} // namespace dsc
