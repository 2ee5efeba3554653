// SPDX-License-Identifier: MIT
#include "fluid/flow.h"

#include "fluid/assembly.h"
#include "fluid/solve.h"

#include <cmath>

namespace dsc {

namespace {

// Carries the interface with the fluid, by the Runge-Kutta method of order 4, and then holds the
// areas. Each search for a velocity begins at a triangle that the vertex alone decides.
InterfaceMotion<double> motion_in(const FluidPast& past, const std::vector<PhaseArea>& areas) {
    return [past, &areas](const InterfaceView<double>& view, double time, double dt,
                          std::span<Point<double>> displacements) {
        const Velocity<double> velocity = [&](std::span<const Point<double>> positions, double at,
                                              std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                velocities[i] = extrapolated_velocity(past, positions[i], at, view.vertices[i].id);
            }
        };
        std::vector<Point<double>> targets(view.size());
        IntegratorScratch<double> scratch;
        scratch.first.resize(view.size());
        velocity(view.positions, time, scratch.first);
        (void)integrate(Integrator::rk4, velocity, view.positions, time, dt,
                        std::span<Point<double>>(targets), scratch);
        hold_areas(view, areas, targets);
        for (std::size_t i = 0; i < view.size(); ++i) {
            displacements[i] = targets[i] - view.positions[i];
        }
    };
}

void check_complex(const FrozenMesh& mesh, const FluidOptions& options) {
    if (mesh.triangles.empty()) {
        throw InputError({.what = "the complex is empty",
                          .where = "Fluid",
                          .value = "no triangles",
                          .allowed = "a triangulated rectangle"});
    }
    for (const FrozenTriangle& triangle : mesh.triangles) {
        (void)fluid_of(options, triangle.phase);
    }
    for (const FrozenEdge& edge : mesh.interface) {
        (void)tension_of(options, edge.left, edge.right);
    }
}

} // namespace

void archive(Archive& archive, PhaseArea& area) { archive(area.phase, area.area); }

Fluid::Fluid(const Complex<double>& complex, FluidOptions options)
    : complex_(complex), options_(std::move(options)) {
    check_fluid(options_);
    FrozenMesh mesh = freeze(complex_);
    check_complex(mesh, options_);
    areas_ = phase_areas(mesh);
    if (options_.equations == FluidEquations::stokes) {
        FluidStep report;
        one_ = solution_in(std::move(mesh), 0, report);
        return;
    }
    FluidField rest{.mesh = std::move(mesh)};
    rest.velocity.assign(rest.mesh.nodes.size(), Point<double>(0, 0));
    rest.pressure.assign(rest.mesh.triangles.size(), {0, 0, 0});
    one_ = std::make_unique<FluidField>(std::move(rest));
}

Fluid::~Fluid() = default;

FluidStep Fluid::step(Simulation<double>& simulation, double dt) {
    require(std::isfinite(dt) && dt > 0, "dt of a step of a fluid", dt, "above 0");
    FluidStep report;
    // At rest the velocity says nothing of where it goes: the first step moves by the one that the
    // old mesh gives for its end.
    std::unique_ptr<FluidField> guess;
    FluidPast mover = past();
    if (options_.equations == FluidEquations::navier_stokes && two_ == nullptr) {
        guess = solution_in(one_->mesh, time() + dt, report);
        mover = {guess.get(), one_.get()};
    }
    Timer timer;
    report.moved = simulation.step(motion_in(mover, areas_), time(), dt);
    report.move_s = timer.lap();
    if (report.moved.gave_up == GiveUp::none) {
        auto next = solution_in(freeze(complex_), time() + dt, report);
        two_ = std::exchange(one_, std::move(next));
    }
    return report;
}

void Fluid::archive(Archive& archive) {
    archive(areas_);
    bool has_two = two_ != nullptr;
    archive(has_two);
    if (archive.is_reading()) {
        two_ = has_two ? std::make_unique<FluidField>() : nullptr;
    }
    archive(*one_);
    if (has_two) {
        archive(*two_);
    }
    archive.expect(!archive.is_reading() || one_->mesh.vertex_bound == complex_.vertex_bound(),
                   "holds the flow of another mesh");
}

std::unique_ptr<FluidField> Fluid::solution_in(FrozenMesh mesh, double time,
                                               FluidStep& report) const {
    Timer timer;
    const FluidNumbering numbers = number_unknowns(mesh, options_.walls);
    const FluidSystem system = assemble(mesh, numbers, options_, past(), time);
    report.assembly_s += timer.lap();
    const Eigen::VectorXd unknowns = solve(system, report.solved);
    auto field = std::make_unique<FluidField>(field_of(std::move(mesh), numbers, unknowns, time));
    report.solve_s += timer.lap();
    return field;
}

} // namespace dsc
