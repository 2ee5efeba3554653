// SPDX-License-Identifier: MIT
#include "fluid/system/assembly.h"

#include "fluid/system/share_out.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

namespace {

// The sum over quadrature points of the products of two nodes' values. Written out, because Eigen
// would fuse additions on processors that can, and the result would depend on the processor.
double sum_of_products(const Eigen::Matrix<double, 6, 3>& one,
                       const Eigen::Matrix<double, 6, 3>& other, Eigen::Index i, Eigen::Index j) {
    return one(i, 0) * other(j, 0) + one(i, 1) * other(j, 1) + one(i, 2) * other(j, 2);
}

// Viscous stress, 2 mu D(u) : D(v), and the divergence.
void add_stress(FluidElement& element, const Eigen::Matrix<double, 2, 3>& slopes, double area,
                double viscosity) {
    Eigen::Matrix<double, 6, 3> in_x; // gradients at the points, by node and point
    Eigen::Matrix<double, 6, 3> in_y;
    for (Eigen::Index q = 0; const QuadraturePoint& point : points_of_degree_2) {
        const Eigen::Matrix<double, 2, 6> gradients = quadratic_gradients(point.at, slopes);
        in_x.col(q) = gradients.row(0);
        in_y.col(q++) = gradients.row(1);
        for (Eigen::Index j = 0; const double pressure : point.at) {
            element.matrix.row(12 + j++).head<12>() -=
                area * point.weight * pressure * gradients.reshaped();
        }
    }
    const double weight = area * points_of_degree_2[0].weight * viscosity; // of all points
    for (Eigen::Index j = 0; j < 6; ++j) {
        for (Eigen::Index i = 0; i < 6; ++i) {
            const double xx = weight * sum_of_products(in_x, in_x, i, j);
            const double yy = weight * sum_of_products(in_y, in_y, i, j);
            element.matrix(2 * i, 2 * j) += 2 * xx + yy;
            element.matrix(2 * i + 1, 2 * j + 1) += xx + 2 * yy;
            element.matrix(2 * i, 2 * j + 1) += weight * sum_of_products(in_y, in_x, i, j);
            element.matrix(2 * i + 1, 2 * j) += weight * sum_of_products(in_y, in_x, j, i);
        }
    }
    element.matrix.topRightCorner<12, 3>() = element.matrix.bottomLeftCorner<3, 12>().transpose();
}

// The mean products of the shape functions.
Eigen::Matrix<double, 6, 6> mean_products() {
    Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
    for (const QuadraturePoint& point : points_of_degree_5) {
        const Eigen::Matrix<double, 6, 1> shapes = quadratic_shapes(point.at);
        for (Eigen::Index j = 0; j < 6; ++j) {
            products.col(j) += point.weight * shapes[j] * shapes;
        }
    }
    return products;
}

void add_inertia(FluidElement& element, const Eigen::Matrix<double, 6, 6>& products,
                 double mass_rate) {
    for (Eigen::Index j = 0; j < 6; ++j) {
        for (Eigen::Index i = 0; i < 6; ++i) {
            const double inertia = mass_rate * products(i, j);
            element.matrix(2 * i, 2 * j) += inertia;
            element.matrix(2 * i + 1, 2 * j + 1) += inertia;
        }
    }
}

void add_force(FluidElement& element, const QuadraturePoint& point, const Point<double>& force) {
    const Eigen::Matrix<double, 6, 1> shapes = quadratic_shapes(point.at);
    for (Eigen::Index i = 0; i < 6; ++i) {
        element.forces.segment<2>(2 * i) += point.weight * shapes[i] * force;
    }
}

// The velocity at the midpoint of an edge between phases is the mean of those at its ends, so half
// of its equations is added to each end.
void tie_middle(FluidElement& element, Eigen::Index i) {
    const Eigen::Index middle = 2 * (3 + i);
    for (const Eigen::Index end : {2 * ((i + 1) % 3), 2 * ((i + 2) % 3)}) {
        element.matrix.middleRows<2>(end) += element.matrix.middleRows<2>(middle) / 2;
        element.forces.segment<2>(end) += element.forces.segment<2>(middle) / 2;
    }
    for (const Eigen::Index end : {2 * ((i + 1) % 3), 2 * ((i + 2) % 3)}) {
        element.matrix.middleCols<2>(end) += element.matrix.middleCols<2>(middle) / 2;
    }
}

// Half of the tension of the edge opposite to vertex i: the triangle beyond it has the other half.
void add_tension(FluidElement& element, const MeshSnapshot& mesh, const SnapshotTriangle& triangle,
                 std::uint32_t i, const FluidOptions& options, const FluidPast& past, double time) {
    const std::uint32_t a = next_index(i);
    const std::uint32_t b = prev_index(i);
    const Point<double> way = mesh.nodes[triangle.nodes[b]] - mesh.nodes[triangle.nodes[a]];
    const Phase beyond = mesh.triangles[triangle.across[i]].phase;
    const double pull = pair_of(options, triangle.phase, beyond).tension / 2 / way.norm();
    Point<double> force = pull * way;
    double resistance = 0;
    if (past.one != nullptr) {
        const auto before = [&](std::uint32_t node) {
            return last_velocity(past, mesh.nodes[node], time, node);
        };
        resistance = pull * options.implicitness * (time - past.one->time);
        force -= resistance * (before(triangle.nodes[b]) - before(triangle.nodes[a]));
    }
    const Eigen::Index from = 2 * a;
    const Eigen::Index to = 2 * b;
    element.forces.segment<2>(from) += force;
    element.forces.segment<2>(to) -= force;
    for (const Eigen::Index k : {0, 1}) {
        element.matrix(from + k, from + k) += resistance;
        element.matrix(to + k, to + k) += resistance;
        element.matrix(from + k, to + k) -= resistance;
        element.matrix(to + k, from + k) -= resistance;
    }
}

void number(FluidElement& element, const FluidNumbering& numbers, const SnapshotTriangle& triangle,
            const std::array<int, 3>& pressures) {
    for (std::size_t i = 0; i < 6; ++i) {
        element.unknowns[2 * i] = numbers.velocity[triangle.nodes[i]][0];
        element.unknowns[2 * i + 1] = numbers.velocity[triangle.nodes[i]][1];
    }
    std::ranges::copy(pressures, element.unknowns.begin() + 12);
}

// The walls pull at the end of an interface so that the tensions are in balance at the contact
// angle (T. Young, "An essay on the cohesion of fluids", 1805).
void add_contacts(FluidSystem& system, const MeshSnapshot& mesh, const FluidOptions& options) {
    constexpr double radians = std::numbers::pi / 180;
    std::vector<std::uint32_t> behind(mesh.vertex_bound,
                                      no_id); // the missing triangle across a wall's edge
    const auto for_each_boundary_edge = [&](auto visit) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                if (mesh.triangles[t].across[i] == no_id) {
                    visit(t, next_index(i), prev_index(i));
                }
            }
        }
    };
    for_each_boundary_edge([&](std::uint32_t t, std::uint32_t from, std::uint32_t) {
        behind[mesh.triangles[t].nodes[from]] = t;
    });
    for_each_boundary_edge([&](std::uint32_t t, std::uint32_t from, std::uint32_t to) {
        const SnapshotTriangle& triangle = mesh.triangles[t];
        const std::uint32_t end = triangle.nodes[to];
        const Phase phase = triangle.phase;
        const Phase beyond = mesh.triangles[behind[end]].phase;
        const bool do_meet = std::ranges::any_of(mesh.interface, [&](const SnapshotEdge& edge) {
            return (edge.from == end || edge.to == end) &&
                   std::minmax(edge.left, edge.right) == std::minmax(phase, beyond);
        });
        if (!do_meet) { // or the phases meet only at this vertex, with a third phase between them
            return;
        }
        const FluidTension& pair = pair_of(options, phase, beyond);
        const Point<double> way = (mesh.nodes[end] - mesh.nodes[triangle.nodes[from]]).normalized();
        const double pull = pair.tension * std::cos(radians * pair.contact_angle);
        system.elements[t].forces.segment<2>(2 * to) += (phase == pair.other ? pull : -pull) * way;
    });
}

// Turns the velocity at vertex or middle i into the directions of a wall.
void turn(FluidElement& element, Eigen::Index i, const Point<double>& first) {
    // Written out: in Eigen's products multiplications and additions are fused.
    const auto turn_pair = [&first](double& x, double& y) {
        const double along = first.x() * x + first.y() * y;
        y = first.x() * y - first.y() * x;
        x = along;
    };
    for (Eigen::Index k = 0; k < element.matrix.cols(); ++k) {
        turn_pair(element.matrix(2 * i, k), element.matrix(2 * i + 1, k));
    }
    for (Eigen::Index k = 0; k < element.matrix.rows(); ++k) {
        turn_pair(element.matrix(k, 2 * i), element.matrix(k, 2 * i + 1));
    }
    turn_pair(element.forces[2 * i], element.forces[2 * i + 1]);
}

// What walls fix becomes forces.
void add_walls(FluidSystem& system, const MeshSnapshot& mesh, const FluidWalls& walls) {
    std::vector<std::uint32_t> wall_at(mesh.nodes.size(), no_id);
    for (std::uint32_t k = 0; k < walls.nodes.size(); ++k) {
        const WallNode& wall = walls.nodes[k];
        if (wall.first.y() != 0 || !wall.velocity.isZero(0)) {
            wall_at[wall.node] = k;
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        FluidElement& element = system.elements[t];
        for (Eigen::Index i = 0; const std::uint32_t node : mesh.triangles[t].nodes) {
            if (wall_at[node] != no_id) {
                const WallNode& wall = walls.nodes[wall_at[node]];
                if (wall.first.y() != 0) {
                    turn(element, i, wall.first);
                }
                const Point<double> velocity(wall.velocity.dot(wall.first),
                                             wall.velocity.dot(turned_left(wall.first)));
                for (const Eigen::Index k : {0, 1}) {
                    if (velocity[k] != 0) {
                        for (Eigen::Index row = 0; row < element.forces.size(); ++row) {
                            element.forces[row] -= element.matrix(row, 2 * i + k) * velocity[k];
                        }
                    }
                }
            }
            ++i;
        }
    }
}

} // namespace

void assemble(const MeshSnapshot& mesh, const FluidNumbering& numbers, const FluidOptions& options,
              const FluidPast& past, double time, FluidSystem& system) {
    const bool has_inertia = options.equations == FluidEquations::navier_stokes;
    const double rate = has_inertia ? backward_difference(past, time).now : 0;
    const Eigen::Matrix<double, 6, 6> products = mean_products();
    // About the squared size of the domain over (2 pi)^2: that of the longest wave.
    const double extent = (mesh.domain.high - mesh.domain.low).squaredNorm() / 10;
    system.size = numbers.size;
    system.elements.resize(mesh.triangles.size());
    share_out(mesh.triangles.size(), options.threads, [&](std::size_t t) {
        const SnapshotTriangle& triangle = mesh.triangles[t];
        const FluidPhase& fluid = fluid_of(options, triangle.phase);
        const double size = area(mesh, triangle);
        FluidElement& element = system.elements[t];
        element.matrix.setZero();
        element.forces.setZero();
        number(element, numbers, triangle, numbers.pressure[t]);
        add_stress(element, slopes_of(mesh, triangle, size), size, fluid.viscosity);
        std::array<Point<double>, 7> accelerations;
        accelerations.fill(Point<double>(0, 0));
        if (has_inertia) {
            add_inertia(element, products, size * fluid.density * rate);
            accelerations = past_accelerations(mesh, triangle, past, time);
        }
        for (std::size_t q = 0; q < points_of_degree_5.size(); ++q) {
            add_force(element, points_of_degree_5[q],
                      size * fluid.density * (options.gravity - accelerations[q]));
        }
        for (const std::uint32_t i : {0U, 1U, 2U}) {
            if (numbers.is_middle_of_phases[triangle.nodes[3 + i]] != 0) {
                tie_middle(element, i);
                add_tension(element, mesh, triangle, i, options, past, time);
            }
        }
        element.pressure_scale = size / 3 / (fluid.viscosity + fluid.density * rate * extent);
    });
    add_contacts(system, mesh, options);
    add_walls(system, mesh, numbers.walls);
}

} // namespace dsc
