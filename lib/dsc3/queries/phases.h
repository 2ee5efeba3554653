// SPDX-License-Identifier: MIT
// Measures of phases and of the mesh. O(mesh) each: not for each step of a long run.
#pragma once

#include "dsc3/complex/complex.h"

#include <array>
#include <vector>

namespace dsc3 {

/// The volume of all tets of a phase.
[[nodiscard]] Real phase_volume(const Complex& complex, Phase phase);

/// A face between two phases, counter-clockwise as seen from the lower one.
struct InterfaceFace {
    std::array<std::uint32_t, 3> v; ///< vertices by id
    Phase inside;                   ///< the higher phase
    Phase outside;                  ///< the lower phase
};

/// All faces of the interface, in the order of their tets.
[[nodiscard]] std::vector<InterfaceFace> interface_faces(const Complex& complex);

/// The extremes over all tets, and over all faces of the interface.
struct MeshQuality {
    Real worst = 1;            ///< quality
    Real min_dihedral = 180;   ///< in degrees
    Real max_dihedral = 0;     ///< in degrees
    Real min_face_angle = 180; ///< of the interface, in degrees

    /// The extremes of both.
    MeshQuality& operator+=(const MeshQuality& other);
    friend bool operator==(const MeshQuality&, const MeshQuality&) = default;
};

/// Measures the mesh; `Simulation::mesh_quality` does it with several threads.
[[nodiscard]] MeshQuality mesh_quality(const Complex& complex);
/// Measures the tets with ids from `first` to `last` - 1, and the faces of the interface at them.
[[nodiscard]] MeshQuality mesh_quality(const Complex& complex, std::uint32_t first,
                                       std::uint32_t last);

} // namespace dsc3
