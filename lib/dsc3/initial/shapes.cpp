// SPDX-License-Identifier: MIT
#include "dsc3/initial/shapes.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

std::vector<Shape> voronoi_cells(std::span<const Point> sites) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const std::vector<Point> before(sites.begin(),
                                        sites.begin() + static_cast<std::ptrdiff_t>(i));
        const auto twin = std::find(before.begin(), before.end(), sites[i]);
        if (!sites[i].allFinite() || twin != before.end()) {
            throw InputError({.what = "a site of a Voronoi cell is not finite, or given twice",
                              .where = "voronoi_cells, site " + std::to_string(i),
                              .value = to_text(sites[i]),
                              .allowed = "finite points that differ from each other"});
        }
        if (i == 0) {
            continue; // the exterior phase, until others divide it
        }
        Shape cell;
        cell.phase = static_cast<Phase>(i);
        cell.distance = [before, site = sites[i]](const Point& p) {
            Real farthest = -std::numeric_limits<Real>::infinity();
            for (const Point& other : before) { // beyond the bisectors of the two sites
                const Point middle = midpoint(site, other);
                farthest = std::max(farthest, (middle - p).dot(unit(site - other)));
            }
            return farthest;
        };
        for (Phase phase = 0; phase < cell.phase; ++phase) {
            cell.divides.push_back({phase, cell.phase});
        }
        shapes.push_back(std::move(cell));
    }
    return shapes;
}

} // namespace dsc3
