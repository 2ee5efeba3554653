// SPDX-License-Identifier: MIT
#include "fluid/flow.h"

#include "fluid/assembly.h"
#include "fluid/solve.h"

#include <cmath>

namespace dsc {

namespace {

// The velocity of the fluid, and on top of it what holds the areas. A submesh may begin anywhere in
// the view, so that each search begins at a triangle that the vertex alone decides.
InterfaceFlow<double> flow_of(const FluidPast& past, const std::vector<PhaseArea>& areas,
                              const std::vector<double>& pushes) {
    return vertex_flow<double>([past, &areas, &pushes](const InterfaceView<double>& view,
                                                       std::size_t i, double time) {
        const std::uint32_t vertex = view.vertices[i].id;
        const Point<double> velocity = extrapolated_velocity(past, view.positions[i], time, vertex);
        if (view.is_junction(i) || view.is_on_boundary(i)) {
            return velocity;
        }
        const double push =
            pushes[place_of(areas, view.left[i])] - pushes[place_of(areas, view.right[i])];
        return Point<double>(velocity + push * normal(view, i));
    });
}

void check_complex(const FrozenMesh& mesh, const FluidOptions& options) {
    if (mesh.triangles.empty()) {
        throw InputError({.what = "the complex is empty",
                          .where = "Fluid",
                          .value = "no triangles",
                          .allowed = "a triangulated rectangle"});
    }
    for (const PhaseArea& phase : phase_areas(mesh)) {
        (void)fluid_of(options, phase.phase);
    }
    for (const FrozenEdge& edge : mesh.interface) {
        (void)tension_of(options, edge.left, edge.right);
    }
}

} // namespace

Fluid::Fluid(const Complex<double>& complex, FluidOptions options)
    : complex_(complex), options_(std::move(options)) {
    check_fluid(options_);
    FrozenMesh mesh = freeze(complex_);
    check_complex(mesh, options_);
    areas_ = phase_areas(mesh);
    if (options_.equations == FluidEquations::stokes) {
        FluidStep report;
        solve_in(std::move(mesh), 0, report);
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
    Timer timer;
    const std::vector<double> pushes = area_pushes(one_->mesh, areas_, dt);
    report.moved = simulation.step(flow_of(past(), areas_, pushes), time(), dt);
    report.move_s = timer.lap();
    if (report.moved.gave_up == GiveUp::none) {
        solve_in(freeze(complex_), time() + dt, report);
    }
    return report;
}

void Fluid::solve_in(FrozenMesh mesh, double time, FluidStep& report) {
    Timer timer;
    const FluidNumbering numbers = number_unknowns(mesh, options_.walls);
    const FluidSystem system = assemble(mesh, numbers, options_, past(), time);
    report.assembly_s = timer.lap();
    const Eigen::VectorXd unknowns = solve(system, report.solved);
    auto field = std::make_unique<FluidField>(field_of(std::move(mesh), numbers, unknowns, time));
    report.solve_s = timer.lap();
    two_ = std::move(one_);
    one_ = std::move(field);
}

} // namespace dsc
