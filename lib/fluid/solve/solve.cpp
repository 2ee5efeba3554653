// SPDX-License-Identifier: MIT
#include "fluid/solve/solve.h"

#include "fluid/solve/factors.h"

#include <cmath>
#include <numeric>

namespace dsc {

namespace {

// A matrix with a positive definite block for the velocities and a negative definite one for the
// pressures has a factorisation without pivoting in any order (R. J. Vanderbei, "Symmetric
// quasidefinite matrices", 1995). The second block is zero; it is replaced by this fraction of its
// natural size, and iterative refinement removes the error, by about eight digits per iteration. A
// solution takes a tenth of the time of a factorisation, so refinement continues down to rounding:
// spurious currents then stay at rounding level.
constexpr double pressure_mass = 1e-8;
constexpr double largest_residual = 1e-9; // a solution with a larger residual is refused
constexpr double rounding = 1e-15;        // refinement stops below
constexpr int max_refinements = 12;

// Summed in order, so that it does not depend on the vector width of the processor.
double norm(const Eigen::VectorXd& vector) {
    return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

Eigen::VectorXd forces_of(const FluidSystem& system) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(system.size);
    for (const FluidElement& element : system.elements) {
        for (Eigen::Index i = 0; const int unknown : element.unknowns) {
            if (unknown != no_unknown) {
                forces[unknown] += element.forces[i];
            }
            ++i;
        }
    }
    return forces;
}

// The residual: forces minus matrix times unknowns.
Eigen::VectorXd residual_of(const FluidSystem& system, const Eigen::VectorXd& forces,
                            const Eigen::VectorXd& solution) {
    Eigen::VectorXd residual = forces;
    for (const FluidElement& element : system.elements) {
        Eigen::Matrix<double, 15, 1> values;
        for (Eigen::Index i = 0; const int unknown : element.unknowns) {
            values[i++] = unknown == no_unknown ? 0 : solution[unknown];
        }
        Eigen::Matrix<double, 15, 1> products = Eigen::Matrix<double, 15, 1>::Zero();
        for (Eigen::Index j = 0; j < 15; ++j) { // written out: Eigen's product would fuse additions
            for (Eigen::Index i = 0; i < 15; ++i) {
                products[i] += element.matrix(i, j) * values[j];
            }
        }
        for (Eigen::Index i = 0; const int unknown : element.unknowns) {
            if (unknown != no_unknown) {
                residual[unknown] -= products[i];
            }
            ++i;
        }
    }
    return residual;
}

} // namespace

Eigen::VectorXd solve(const FluidSystem& system, const Dissection& dissection,
                      const FluidNumbering& numbers, std::uint32_t threads, SolveReport& report) {
    report = {.unknowns = system.size};
    const Eigen::VectorXd forces = forces_of(system);
    const double size = norm(forces);
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(system.size);
    if (size == 0) {
        return solution;
    }
    const Factors factors = factorise(system, dissection, numbers, pressure_mass, threads);
    Eigen::VectorXd residual = forces;
    report.residual = 1;
    for (int k = 0; k <= max_refinements && factors.has_all_pivots; ++k) {
        solve_in_place(factors, residual);
        Eigen::VectorXd refined = solution + residual;
        residual = residual_of(system, forces, refined);
        const double before = report.residual;
        const double after = norm(residual) / size;
        if (!(after < before)) { // no improvement, or NaN: keep the previous solution
            break;
        }
        solution = std::move(refined);
        report.residual = after;
        report.refinements = k;
        if (after < rounding || after > before / 2) {
            break;
        }
    }
    if (!(report.residual <= largest_residual)) {
        throw SolveError("the equations of the flow could not be solved: the residual is " +
                         to_text(report.residual) + " of the forces, with " +
                         to_text(report.unknowns) + " unknowns");
    }
    return solution;
}

FluidField field_of(MeshSnapshot mesh, const FluidNumbering& numbers,
                    const Eigen::VectorXd& unknowns, double time) {
    FluidField field{.mesh = std::move(mesh), .time = time};
    const auto value = [&](int i) { return i == no_unknown ? 0.0 : unknowns[i]; };
    field.velocity.reserve(numbers.velocity.size());
    for (const auto& [x, y] : numbers.velocity) {
        field.velocity.emplace_back(value(x), value(y));
    }
    for (const WallNode& wall : numbers.walls.nodes) {
        Point<double>& velocity = field.velocity[wall.node];
        const Point<double> free = velocity;
        velocity = free.x() * wall.first + free.y() * turned_left(wall.first) + wall.velocity;
    }
    for (const SnapshotEdge& edge : field.mesh.interface) {
        field.velocity[edge.middle] = (field.velocity[edge.from] + field.velocity[edge.to]) / 2;
    }
    double sum = 0;
    double whole = 0;
    field.pressure.resize(numbers.pressure.size());
    for (std::size_t t = 0; t < numbers.pressure.size(); ++t) {
        const double size = area(field.mesh, field.mesh.triangles[t]);
        whole += size;
        for (std::size_t i = 0; i < 3; ++i) {
            field.pressure[t][i] = value(numbers.pressure[t][i]);
            sum += size / 3 * field.pressure[t][i];
        }
    }
    for (auto& corners : field.pressure) {
        for (double& p : corners) {
            p -= numbers.fixes_pressure() ? 0 : sum / whole;
        }
    }
    return field;
}

std::vector<Point<double>> side_forces(const FluidSystem& system, const FluidNumbering& numbers,
                                       const Eigen::VectorXd& unknowns, const FluidField& field,
                                       std::size_t sides) {
    std::vector<Point<double>> forces(sides, Point<double>(0, 0));
    if (sides == 0) {
        return forces;
    }
    std::vector<const WallNode*> wall_at(field.mesh.nodes.size(), nullptr);
    for (const WallNode& wall : numbers.walls.nodes) {
        wall_at[wall.node] = wall.side == no_id ? nullptr : &wall;
    }
    for (std::size_t t = 0; t < system.elements.size(); ++t) {
        const FluidElement& element = system.elements[t];
        const SnapshotTriangle& triangle = field.mesh.triangles[t];
        if (std::ranges::none_of(triangle.nodes, [&](auto i) { return wall_at[i] != nullptr; })) {
            continue;
        }
        Eigen::Matrix<double, 15, 1> values;
        for (Eigen::Index i = 0; const int unknown : element.unknowns) {
            values[i++] = unknown == no_unknown ? 0 : unknowns[unknown];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            values[static_cast<Eigen::Index>(12 + i)] = field.pressure[t][i];
        }
        for (Eigen::Index i = 0; const std::uint32_t node : triangle.nodes) {
            if (const WallNode* wall = wall_at[node]; wall != nullptr) {
                for (const Eigen::Index k : {0, 1}) {
                    double rest = element.forces[2 * i + k];
                    for (Eigen::Index j = 0; j < 15; ++j) {
                        rest -= element.matrix(2 * i + k, j) * values[j];
                    }
                    forces[wall->side] += rest * (k == 0 ? wall->first : turned_left(wall->first));
                }
            }
            ++i;
        }
    }
    return forces;
}

} // namespace dsc
