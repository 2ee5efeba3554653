// SPDX-License-Identifier: MIT
#include "dsc3/motion/insertion.h"

#include "dsc3/geometry/tet.h"

namespace dsc3 {

Point curved_middle(const Complex& complex, Workspace& work, std::uint32_t a, std::uint32_t b) {
    const Point middle = midpoint(complex.at(a), complex.at(b));
    std::array<Point, 2> normals;
    for (std::uint32_t i = 0; i < 2; ++i) {
        gather(complex, i == 0 ? a : b, work.star);
        gather(complex, work.star, work.interface_star);
        if (stratum(work.interface_star) != Stratum::sheet) {
            return middle;
        }
        normals[i] = normal(complex, work.interface_star);
    }
    if (normals[0].dot(normals[1]) < 0) {
        return middle;
    }
    const Point edge = complex.at(b) - complex.at(a);
    const Point offset =
        0.125 * (edge.dot(normals[1]) * normals[1] - edge.dot(normals[0]) * normals[0]);
    const Real limit = 0.2 * edge.norm();
    const Real length = offset.norm();
    return middle + (length > limit ? Point((limit / length) * offset) : offset);
}

} // namespace dsc3
