// SPDX-License-Identifier: MIT
#include "measures/junctions.h"

#include "dsc/queries/phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace dsc::scenes {

namespace {

// The tangent, at the first point, of the parabola through three points, parametrised by chord
// length.
Point<double> tangent(const Point<double>& p0, const Point<double>& p1, const Point<double>& p2) {
    const double a = (p1 - p0).norm();
    const double b = (p2 - p1).norm();
    const Point<double> first = (p1 - p0) / a;
    const Point<double> second = (p2 - p1) / b;
    return first - (second - first) * (a / (a + b));
}

// The directions of the ends of curves, by vertex.
template <class Real>
std::map<Vertex, std::vector<Point<double>>> find_ends(const Complex<Real>& complex) {
    std::map<Vertex, std::vector<Point<double>>> ends;
    const auto at = [&](Vertex v) {
        return Point<double>(complex.position(v).template cast<double>());
    };
    for (const InterfaceCurve& curve : interface_curves(complex)) {
        const auto& v = curve.vertices;
        const std::size_t n = v.size();
        if (curve.is_closed) {
            continue;
        }
        const bool is_long = n > 2;
        ends[v[0]].push_back(is_long ? tangent(at(v[0]), at(v[1]), at(v[2])) : at(v[1]) - at(v[0]));
        ends[v[n - 1]].push_back(is_long ? tangent(at(v[n - 1]), at(v[n - 2]), at(v[n - 3]))
                                         : at(v[n - 2]) - at(v[n - 1]));
    }
    std::erase_if(ends, [&](const auto& entry) {
        return entry.second.size() < 3 || is_boundary(complex, entry.first);
    });
    return ends;
}

} // namespace

template <class Real>
std::vector<Junction> measure_junctions(const Complex<Real>& complex) {
    std::vector<Junction> junctions;
    for (const auto& [vertex, directions] : find_ends(complex)) {
        std::vector<double> angles;
        for (const Point<double>& d : directions) {
            angles.push_back(std::atan2(d.y(), d.x()) * 180 / std::numbers::pi);
        }
        std::ranges::sort(angles);
        angles.push_back(angles.front() + 360);
        Junction junction{.vertex = vertex,
                          .sectors = static_cast<std::uint32_t>(directions.size()),
                          .min_deg = 360};
        for (std::size_t i = 1; i < angles.size(); ++i) {
            junction.min_deg = std::min(junction.min_deg, angles[i] - angles[i - 1]);
            junction.max_deg = std::max(junction.max_deg, angles[i] - angles[i - 1]);
        }
        junctions.push_back(junction);
    }
    return junctions;
}

JunctionFigures summarise(const std::vector<Junction>& junctions) {
    JunctionFigures figures{.count = junctions.size(),
                            .worst_deviation_deg = std::numeric_limits<double>::quiet_NaN()};
    for (const Junction& junction : junctions) {
        if (junction.sectors > 3) {
            ++figures.crossings;
        } else { // replaces a NaN, too
            figures.worst_deviation_deg =
                std::fmax(figures.worst_deviation_deg,
                          std::max(120 - junction.min_deg, junction.max_deg - 120));
        }
    }
    return figures;
}

template std::vector<Junction> measure_junctions(const Complex<double>&);
template std::vector<Junction> measure_junctions(const Complex<float>&);

} // namespace dsc::scenes
