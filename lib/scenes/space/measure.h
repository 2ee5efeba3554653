// SPDX-License-Identifier: MIT
// How far an interface in three dimensions is from where it should be.
#pragma once

#include "scenes/space/scene.h"

namespace dsc::scenes::space {

/// The volume between the interface and a shape: the distance, integrated over the faces.
[[nodiscard]] double volume_between(const dsc3::Complex& complex, const dsc3::Distance& shape);

/// The volume between the interface at some time and the exact one, for a flow that keeps volumes.
/// It is measured at time 0, where the exact interface is known: pieces of all faces are taken back
/// by the flow, the faces' own vertices among them, as if each face were cut into 16.
[[nodiscard]] double volume_between(const dsc3::Complex& complex, const Setup& setup, double time);

/// Distances of the interface's vertices from a shape.
struct VertexErrors {
    std::uint32_t vertices = 0;
    double rms = 0;
    double largest = 0;
};
[[nodiscard]] VertexErrors vertex_errors(const dsc3::Complex& complex, const dsc3::Distance& shape);

} // namespace dsc::scenes::space
