// SPDX-License-Identifier: MIT
#include "fluid/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

namespace {

// Gauss's rule of four points on [0, 1], exact for degree 7.
constexpr std::array<double, 4> gauss_at{0.06943184420297371, 0.33000947820757187,
                                         0.66999052179242813, 0.93056815579702629};
constexpr std::array<double, 4> gauss_weight{0.17392742256872693, 0.32607257743127307,
                                             0.32607257743127307, 0.17392742256872693};

// A cubic on [0, 1], given by its values at 0, 1/3, 2/3 and 1.
struct Cubic {
    std::array<Point<double>, 4> at;

    // The divided differences of equidistant values (Newton's form).
    [[nodiscard]] std::pair<Point<double>, Point<double>> value_and_slope(double share) const {
        const double s = 3 * share;
        const Point<double> first = at[1] - at[0];
        const Point<double> second = (at[2] - 2 * at[1] + at[0]) / 2;
        const Point<double> third = (at[3] - 3 * at[2] + 3 * at[1] - at[0]) / 6;
        return {at[0] + s * (first + (s - 1) * (second + (s - 2) * third)),
                3 * (first + (2 * s - 1) * second + (3 * s * s - 6 * s + 2) * third)};
    }
};

Cubic cubic_along(const Complex<double>& complex, const VertexLoop& loop, std::size_t i) {
    const std::size_t n = loop.size();
    const auto at = [&](std::size_t k) { return complex.position(loop[(i + k) % n]); };
    const CurveNeighbours<double> neighbours{.p0 = at(n - 1),
                                             .p1 = at(0),
                                             .p2 = at(1),
                                             .p3 = at(2),
                                             .has_first = true,
                                             .has_last = true};
    return {{neighbours.p1, curve_point(neighbours, 1.0 / 3), curve_point(neighbours, 2.0 / 3),
             neighbours.p2}};
}

template <class Function>
void for_each_of_phase(const FluidField& field, Phase phase, Function function) {
    for (std::size_t t = 0; t < field.mesh.triangles.size(); ++t) {
        if (field.mesh.triangles[t].phase == phase) {
            function(t, area(field.mesh, field.mesh.triangles[t]));
        }
    }
}

} // namespace

double CubicOutline::circularity() const { return 2 * std::sqrt(std::numbers::pi * area) / length; }

CubicOutline cubic_outline(const Complex<double>& complex, Phase phase) {
    CubicOutline outline;
    for (const VertexLoop& loop : outlines(complex, phase)) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Cubic cubic = cubic_along(complex, loop, i);
            for (std::size_t q = 0; q < gauss_at.size(); ++q) {
                const auto [p, slope] = cubic.value_and_slope(gauss_at[q]);
                // Green's theorem: the area and both moments as integrals along the curve.
                const double swept = gauss_weight[q] * (p.x() * slope.y() - p.y() * slope.x());
                outline.length += gauss_weight[q] * slope.norm();
                outline.area += swept / 2;
                outline.centroid += swept / 3 * p;
            }
        }
    }
    outline.centroid /= outline.area;
    return outline;
}

Point<double> mean_velocity(const FluidField& field, Phase phase) {
    Point<double> sum(0, 0);
    double whole = 0;
    for_each_of_phase(field, phase, [&](std::size_t t, double size) {
        // The quadratic shape functions of the vertices have mean 0.
        for (std::size_t i = 3; i < 6; ++i) {
            sum += size / 3 * field.velocity[field.mesh.triangles[t].nodes[i]];
        }
        whole += size;
    });
    return whole > 0 ? Point<double>(sum / whole) : sum;
}

double mean_pressure(const FluidField& field, Phase phase) {
    double sum = 0;
    double whole = 0;
    for_each_of_phase(field, phase, [&](std::size_t t, double size) {
        const auto& p = field.pressure[t];
        sum += size / 3 * (p[0] + p[1] + p[2]);
        whole += size;
    });
    return whole > 0 ? sum / whole : 0;
}

double largest_speed(const FluidField& field, const FluidOptions& options) {
    double largest = 0;
    for (const SnapshotTriangle& triangle : field.mesh.triangles) {
        if (!fluid_of(options, triangle.phase).is_void) {
            for (const std::uint32_t node : triangle.nodes) {
                largest = std::max(largest, field.velocity[node].norm());
            }
        }
    }
    return largest;
}

FluidEnergy energy(const FluidField& field, const FluidOptions& options) {
    FluidEnergy energy;
    const MeshSnapshot& mesh = field.mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const SnapshotTriangle& triangle = mesh.triangles[t];
        const FluidPhase& fluid = fluid_of(options, triangle.phase);
        if (fluid.is_void) {
            continue;
        }
        const double mass = area(mesh, triangle) * fluid.density;
        for (const QuadraturePoint& point : points_of_degree_5) {
            energy.kinetic +=
                mass * point.weight / 2 * velocity_at(field, {t, point.at}).squaredNorm();
        }
        const Point<double> centre =
            (mesh.nodes[triangle.nodes[0]] + mesh.nodes[triangle.nodes[1]] +
             mesh.nodes[triangle.nodes[2]]) /
            3;
        energy.potential -= mass * options.gravity.dot(centre);
    }
    for (const SnapshotEdge& edge : mesh.interface) {
        energy.surface += pair_of(options, edge.left, edge.right).tension *
                          (mesh.nodes[edge.to] - mesh.nodes[edge.from]).norm();
    }
    return energy;
}

} // namespace dsc
