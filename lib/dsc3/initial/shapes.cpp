// SPDX-License-Identifier: MIT
#include "dsc3/initial/shapes.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>

namespace dsc3 {

Distance box(const Box& box) {
    const Point centre = midpoint(box.low, box.high);
    const Point half = 0.5 * (box.high - box.low);
    return [=](const Point& p) {
        const Point beyond = (p - centre).cwiseAbs() - half;
        return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), Real(0));
    };
}

Distance ellipsoid(const Point& centre, const Point& radii) {
    return [=](const Point& p) {
        const Point scaled = (p - centre).cwiseQuotient(radii);
        const Real level = scaled.norm();
        const Real slope = scaled.cwiseQuotient(radii).norm();
        return slope > 0 ? level * (level - 1) / slope : -radii.minCoeff();
    };
}

Distance torus(const Point& centre, const Point& axis, Real circle_radius, Real tube_radius) {
    if (!(axis.norm() > 0) || !axis.allFinite()) {
        throw InputError({.what = "the axis of a torus has no direction",
                          .where = "torus",
                          .value = to_text(axis),
                          .allowed = "a finite vector that is not 0"});
    }
    return [=, along = unit(axis)](const Point& p) {
        const Point from = p - centre;
        const Real height = from.dot(along);
        const Real radius = (from - height * along).norm();
        return std::hypot(radius - circle_radius, height) - tube_radius;
    };
}

} // namespace dsc3
