// SPDX-License-Identifier: MIT
#include "dsc3/queries/phases.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc3 {

Real phase_volume(const Complex& complex, Phase phase) {
    Real sum = 0;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.phases[t] == phase && complex.is_alive(Tet{t})) {
            const auto p = complex.positions_of(Tet{t});
            sum += volume(p[0], p[1], p[2], p[3]);
        }
    }
    return sum;
}

std::vector<InterfaceFace> interface_faces(const Complex& complex) {
    std::vector<InterfaceFace> faces;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (!complex.is_alive(Tet{t})) {
            continue;
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Phase beyond = complex.phase_at(complex.tets[t].n[i]);
            if (beyond < complex.phases[t]) { // the border's phase is the largest
                faces.push_back({complex.face(corner_of(t, i)), complex.phases[t], beyond});
            }
        }
    }
    return faces;
}

namespace {

// The sine of a dihedral angle is det * l / (n m): l is the length of its edge, n and m are twice
// the areas of its faces, the heights of which over the edge are at most sqrt(S / 6) each if
// l = sqrt(S / 6) too, where S is the sum of all squared edges, and n m / l is then largest. So the
// sine is at least quality / sqrt(2). Returns a quality from which all angles lie between the two.
Real certain_quality(Real smallest, Real largest) {
    constexpr Real degree = std::numbers::pi / 180;
    constexpr Real factor = 1.42; // a little more than sqrt(2), for rounding
    return largest > 90 ? factor * std::max(std::sin(smallest * degree), std::sin(largest * degree))
                        : 2;
}

} // namespace

MeshQuality mesh_quality(const Complex& complex) {
    MeshQuality result;
    Real relevant = 2; // no tet of this quality has a more extreme angle
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (!complex.is_alive(Tet{t})) {
            continue;
        }
        const auto p = complex.positions_of(Tet{t});
        const Real here = quality(p[0], p[1], p[2], p[3]);
        result.worst = std::min(result.worst, here);
        if (here < relevant) {
            const DihedralAngles angles = dihedral_angles(p);
            result.min_dihedral = std::min(result.min_dihedral, angles.smallest);
            result.max_dihedral = std::max(result.max_dihedral, angles.largest);
            relevant = certain_quality(result.min_dihedral, result.max_dihedral);
        }
    }
    for (const InterfaceFace& face : interface_faces(complex)) {
        const auto& [a, b, c] = face.v;
        result.min_face_angle = std::min(
            result.min_face_angle, min_angle_degrees(complex.at(a), complex.at(b), complex.at(c)));
    }
    return result;
}

} // namespace dsc3
