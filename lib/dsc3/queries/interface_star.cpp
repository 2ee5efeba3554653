// SPDX-License-Identifier: MIT
#include "dsc3/queries/interface_star.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>

namespace dsc3 {

bool InterfaceStar::has_edge_to(std::uint32_t vertex) const {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const StarFace& f) { return f.x == vertex || f.y == vertex; });
}

void gather(const Complex& complex, const Star& star, InterfaceStar& interface_star) {
    interface_star.centre = star.centre;
    interface_star.faces.clear();
    for (const Corner corner : star.corners) {
        const std::uint32_t t = tet_of(corner);
        const TetRecord& tet = complex.tets[t];
        const auto& others = face_indices[index_of(corner)];
        for (std::uint32_t j = 0; j < 3; ++j) {
            // The border's phase is the largest.
            if (complex.phase_at(tet.n[others[j]]) < complex.phases[t]) {
                interface_star.faces.push_back(
                    {tet.v[others[(j + 2) % 3]], tet.v[others[(j + 1) % 3]], t});
            }
        }
    }
}

Stratum stratum(const InterfaceStar& interface_star) {
    if (interface_star.faces.empty()) {
        return Stratum::none;
    }
    std::uint32_t met = 0;
    std::uint32_t at = interface_star.faces[0].x;
    do {
        const StarFace* next = nullptr;
        for (const StarFace& face : interface_star.faces) {
            if (face.x == at) {
                if (next != nullptr) {
                    return Stratum::other;
                }
                next = &face;
            }
        }
        if (next == nullptr) {
            return Stratum::other;
        }
        at = next->y;
        ++met;
    } while (at != interface_star.faces[0].x && met < interface_star.size());
    return met == interface_star.size() && at == interface_star.faces[0].x ? Stratum::sheet
                                                                           : Stratum::other;
}

Point normal(const Complex& complex, const InterfaceStar& interface_star) {
    const Point& centre = complex.at(interface_star.centre);
    Point sum = Point::Zero();
    for (const StarFace& face : interface_star.faces) {
        const Point a = complex.at(face.x) - centre;
        const Point b = complex.at(face.y) - centre;
        sum += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    }
    return unit(sum);
}

} // namespace dsc3
