// SPDX-License-Identifier: MIT
#include "dsc3/queries/fan.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>

namespace dsc3 {

bool Fan::has_edge_to(std::uint32_t vertex) const {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const FanFace& f) { return f.x == vertex || f.y == vertex; });
}

void gather(const Complex& complex, const Star& star, Fan& fan) {
    fan.centre = star.centre;
    fan.faces.clear();
    for (const Corner corner : star.corners) {
        const std::uint32_t t = tet_of(corner);
        const TetRecord& tet = complex.tets[t];
        const auto& others = face_indices[index_of(corner)];
        for (std::uint32_t j = 0; j < 3; ++j) {
            // The border's phase is the largest.
            if (complex.phase_at(tet.n[others[j]]) < complex.phases[t]) {
                fan.faces.push_back({tet.v[others[(j + 2) % 3]], tet.v[others[(j + 1) % 3]], t});
            }
        }
    }
}

Stratum stratum(const Fan& fan) {
    if (fan.faces.empty()) {
        return Stratum::none;
    }
    std::uint32_t met = 0;
    std::uint32_t at = fan.faces[0].x;
    do {
        const FanFace* next = nullptr;
        for (const FanFace& face : fan.faces) {
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
    } while (at != fan.faces[0].x && met < fan.size());
    return met == fan.size() && at == fan.faces[0].x ? Stratum::sheet : Stratum::other;
}

Point normal(const Complex& complex, const Fan& fan) {
    const Point& centre = complex.at(fan.centre);
    Point sum = Point::Zero();
    for (const FanFace& face : fan.faces) {
        const Point a = complex.at(face.x) - centre;
        const Point b = complex.at(face.y) - centre;
        sum += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    }
    return unit(sum);
}

} // namespace dsc3
