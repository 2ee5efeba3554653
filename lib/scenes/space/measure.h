// SPDX-License-Identifier: MIT
// Errors of an interface in three dimensions.
#pragma once

#include "scenes/space/scene.h"

namespace dsc::scenes::space {

/// The volume between the interface and a shape: the distance from the shape, integrated over the
/// faces.
[[nodiscard]] double volume_between(const dsc3::Complex& complex, const dsc3::Distance& shape);

/// The volume between the interface at some time and the exact one, for a flow that conserves
/// volume. It is measured at time 0, when the exact interface is known: each face is cut into 16
/// pieces, whose vertices are moved back by the flow. The result is the same for any number of
/// threads.
[[nodiscard]] double volume_between(const dsc3::Complex& complex, const Setup& setup, double time,
                                    std::uint32_t threads);

/// Distances of interface vertices from a shape.
struct VertexErrors {
    std::uint32_t vertices = 0;
    double rms = 0;
    double largest = 0;
};
[[nodiscard]] VertexErrors vertex_errors(const dsc3::Complex& complex, const dsc3::Distance& shape);

} // namespace dsc::scenes::space
