// SPDX-License-Identifier: MIT
// What several tests in three dimensions use: a flow, and visits to the interface.
#pragma once

#include "dsc3/dsc3.h"

#include <cmath>
#include <numbers>
#include <span>

namespace dsc3::test {

/// Enright's flow at time 0 for ever.
inline void swirl(std::span<const Point> positions, double, std::span<Point> velocities) {
    using std::numbers::pi;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Point p = pi * positions[i];
        const Point s(std::sin(p.x()), std::sin(p.y()), std::sin(p.z()));
        const Point d(std::sin(2 * p.x()), std::sin(2 * p.y()), std::sin(2 * p.z()));
        velocities[i] = Point(2 * s.x() * s.x() * d.y() * d.z(), -d.x() * s.y() * s.y() * d.z(),
                              -d.x() * d.y() * s.z() * s.z());
    }
}

/// Gives each tet its id.
inline void number_tets(const Complex& complex, TetAttribute<std::uint32_t>& number) {
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        number[Tet{t}] = t;
    }
}
/// Whether most tets have another id than `number_tets` gave them; operations change those of few.
inline bool are_renumbered(const Complex& complex, const TetAttribute<std::uint32_t>& number) {
    std::uint32_t count = 0;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        count += complex.is_alive(Tet{t}) && number[Tet{t}] != t ? 1U : 0U;
    }
    return 2 * count > complex.tet_count();
}

/// Calls `visit(vertex, its interface star, its stratum)` for all vertices of the interface.
template <class Visit>
void for_each_interface_star(const Complex& complex, Visit visit) {
    Star star;
    InterfaceStar interface_star;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.is_alive(Vertex{v}) && complex.is_interface(Vertex{v})) {
            gather(complex, v, star);
            gather(complex, star, interface_star);
            const Stratum stratum = classify(interface_star);
            visit(v, interface_star, stratum);
        }
    }
}

} // namespace dsc3::test
