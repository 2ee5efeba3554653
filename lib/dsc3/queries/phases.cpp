// SPDX-License-Identifier: MIT
#include "dsc3/queries/phases.h"

#include "dsc3/geometry/tet.h"

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

MeshQuality mesh_quality(const Complex& complex) {
    MeshQuality result;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(Tet{t})) {
            const auto p = complex.positions_of(Tet{t});
            const DihedralAngles angles = dihedral_angles(p);
            result.worst = std::min(result.worst, quality(p[0], p[1], p[2], p[3]));
            result.min_dihedral = std::min(result.min_dihedral, angles.smallest);
            result.max_dihedral = std::max(result.max_dihedral, angles.largest);
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
