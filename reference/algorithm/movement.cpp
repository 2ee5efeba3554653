// SPDX-License-Identifier: MIT
#include "reference/algorithm/movement.h"

#include "reference/complex/geometry.h"

#include <algorithm>

namespace dsc::reference {

double movable_fraction(const Complex& K, Vertex v, const Point<double>& destination) {
    double fraction = 1;
    for (const TriangleKey& t : K.triangles_at(v)) {
        OrientedTriangle o = K.oriented(t);
        std::rotate(o.begin(), std::find(o.begin(), o.end(), v), o.end());
        const Point<double>& a = K.coord(o[1]);
        const Point<double>& b = K.coord(o[2]);
        // Twice the area is altitude times base, so this divided by base^2 is altitude / base.
        const double before = cross(a, b, K.coord(v));
        const double after = cross(a, b, destination);
        const double limit = std::min(min_altitude * (b - a).squaredNorm(), 0.5 * before);
        if (after < limit) {
            fraction = std::min(fraction, (before - limit) / (before - after));
        }
    }
    return std::max(fraction, 0.0);
}

bool move_vertex(Vertex v, const Point<double>& destination, Complex& K) {
    const Point<double> start = K.coord(v);
    const auto inverted = [&](const TriangleKey& t) { return K.orientation(t) <= 0; };
    double fraction = movable_fraction(K, v, destination);
    // The areas above are rounded, so the move is checked exactly. After 52 halvings a double has
    // no digit left.
    for (int halvings = 0; halvings < 52 && fraction > 0; ++halvings, fraction *= 0.5) {
        K.set_coord(v, fraction < 1 ? Point<double>(start + fraction * (destination - start))
                                    : destination);
        if (std::ranges::none_of(K.triangles_at(v), inverted)) {
            return fraction == 1;
        }
    }
    K.set_coord(v, start);
    return start == destination;
}

void movement(Destinations& under_way, Complex& K) {
    std::erase_if(under_way, [&](const auto& item) {
        return !K.is_valid_simplex(item.first) || move_vertex(item.first, item.second, K);
    });
}

} // namespace dsc::reference
