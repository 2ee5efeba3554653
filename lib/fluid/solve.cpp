// SPDX-License-Identifier: MIT
#include "fluid/solve.h"

#include "fluid/factors.h"

#include <cmath>
#include <numeric>

namespace dsc {

namespace {

// A matrix with a positive definite block for the velocities and a negative definite one for the
// pressures has a factorisation without pivoting in any order (R. J. Vanderbei, "Symmetric
// quasidefinite matrices", 1995). The second block is zero: this share of its natural size takes
// its place, and refinement removes the error, by about as many digits a time. A solution takes a
// tenth of the time of a factorisation, so that it goes on down to rounding: currents that are not
// there are then no larger than that.
constexpr double pressure_mass = 1e-8;
constexpr double largest_residual = 1e-9; // above it the solution is refused
constexpr int most_refinements = 12;

// Summed in order, so that it does not depend on how many lanes the processor has.
double norm(const Eigen::VectorXd& vector) {
    return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

} // namespace

Eigen::VectorXd solve(const FluidSystem& system, SolveReport& report) {
    report = {.unknowns = static_cast<int>(system.forces.size())};
    const double size = norm(system.forces);
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(system.forces.size());
    if (size == 0) {
        return solution;
    }
    const Eigen::VectorXd mass = pressure_mass * system.pressure_scale;
    Eigen::SparseMatrix<double> regular = system.matrix;
    regular.diagonal() -= mass;
    const SparseFactors factors = factorise(regular);
    Eigen::VectorXd residual = system.forces;
    report.residual = 1;
    for (int k = 0; k <= most_refinements && factors.has_all_pivots; ++k) {
        solve_in_place(factors, residual);
        solution += residual;
        residual = system.forces;
        residual.noalias() -= system.matrix.selfadjointView<Eigen::Lower>() * solution;
        const double before = report.residual;
        report.residual = norm(residual) / size;
        report.refinements = k;
        if (!(report.residual <= before / 2)) {
            break; // rounding is reached
        }
    }
    if (!(report.residual <= largest_residual)) {
        throw SolveError("the equations of the flow could not be solved: the residual is " +
                         to_text(report.residual) + " of the forces, with " +
                         to_text(report.unknowns) + " unknowns");
    }
    return solution;
}

FluidField field_of(FrozenMesh mesh, const FluidNumbering& numbers, const Eigen::VectorXd& unknowns,
                    double time) {
    FluidField field{.mesh = std::move(mesh), .time = time};
    const auto value = [&](int i) { return i == no_unknown ? 0.0 : unknowns[i]; };
    field.velocity.reserve(numbers.velocity.size());
    for (const auto& [x, y] : numbers.velocity) {
        field.velocity.emplace_back(value(x), value(y));
    }
    for (const FrozenEdge& edge : field.mesh.interface) {
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
            p -= sum / whole;
        }
    }
    return field;
}

} // namespace dsc
