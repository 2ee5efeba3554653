// SPDX-License-Identifier: MIT
#include "fluid/flow.h"

#include "dsc/base/timer.h"
#include "dsc/geometry/points.h"
#include "fluid/interface/boundary_flow.h"
#include "fluid/interface/even_spacing.h"
#include "fluid/solve/solve.h"
#include "fluid/system/assembly.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

// Whether the options ask for equal interface edges: lengths that depend neither on the shape nor
// on the application.
bool has_even_edges(const Options<double>& options) {
    return options.interface.turn_degrees == 0 && options.interface.gap == 0 &&
           !options.sizes.on_interface;
}

// The growth of each phase's area per unit of time by inflow and outflow.
std::vector<double> inflows_of(const FluidField& field, const std::vector<PhaseArea>& areas) {
    std::vector<double> inflows(areas.size(), 0);
    for (const SnapshotTriangle& triangle : field.mesh.triangles) {
        const auto at = std::ranges::find(areas, triangle.phase, &PhaseArea::phase);
        for (std::uint32_t i = 0; i < 3 && at != areas.end(); ++i) {
            if (triangle.across[i] == no_id) {
                const std::uint32_t from = triangle.nodes[next_index(i)];
                const std::uint32_t to = triangle.nodes[prev_index(i)];
                const Point<double> mean =
                    (field.velocity[from] + 4 * field.velocity[triangle.nodes[3 + i]] +
                     field.velocity[to]) /
                    6;
                inflows[static_cast<std::size_t>(at - areas.begin())] +=
                    cross<double>(field.mesh.nodes[to] - field.mesh.nodes[from], mean);
            }
        }
    }
    return inflows;
}

// Advects the interface with the fluid by the Runge-Kutta method of order 4, spaces its vertices
// evenly and then restores the areas. Each search for a velocity begins at a triangle that the
// vertex alone decides.
InterfaceMotion<double> motion_in(const FluidPast& past, BoundaryFlow& boundary, bool is_even) {
    return [past, &boundary, is_even](const InterfaceView<double>& view, double time, double dt,
                                      std::span<Point<double>> displacements) {
        const Velocity<double> velocity = [&](std::span<const Point<double>> positions, double at,
                                              std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                velocities[i] = extrapolated_velocity(past, positions[i], at, view.vertices[i].id);
            }
        };
        boundary.begin(view, time);
        std::vector<Point<double>> targets(view.size());
        IntegratorScratch<double> scratch;
        scratch.first.resize(view.size());
        velocity(view.positions, time, scratch.first);
        (void)integrate(Integrator::rk4, velocity, view.positions, time, dt,
                        std::span<Point<double>>(targets), scratch);
        boundary.cut_at_outlets(view, targets);
        if (is_even) {
            space_evenly(view, targets);
        }
        boundary.keep_on_boundary(view, targets);
        hold_areas(view, boundary.areas_at(time + dt), targets);
        for (std::size_t i = 0; i < view.size(); ++i) {
            displacements[i] = targets[i] - view.positions[i];
        }
    };
}

// A void is solved as a fluid without mass or pressure, whose viscosity is too small to affect the
// others. Its velocity continues theirs, so velocities interpolated beside the surface are smooth.
void fill_voids(std::vector<FluidPhase>& phases) {
    constexpr double share = 1e-6;
    double largest = 0;
    for (const FluidPhase& phase : phases) {
        largest = phase.is_void ? largest : std::max(largest, phase.viscosity);
    }
    for (FluidPhase& phase : phases) {
        if (phase.is_void) {
            phase.density = 0;
            phase.viscosity = share * largest;
        }
    }
}

// The largest estimated error of the motion of an edge's end in a step, relative to the length of
// the edge.
double error_of_motion(const FluidField& field, const FluidPast& moving_vertex, double dt) {
    double largest = 0;
    for (const SnapshotEdge& edge : field.mesh.interface) {
        const double length = (field.mesh.nodes[edge.to] - field.mesh.nodes[edge.from]).norm();
        for (const std::uint32_t end : {edge.from, edge.to}) {
            const Point<double> assumed =
                extrapolated_velocity(moving_vertex, field.mesh.nodes[end], field.time, end);
            largest = std::max(largest, dt * (field.velocity[end] - assumed).norm() / length);
        }
    }
    return largest;
}

constexpr double min_factor = 0.3; // ratio of a step to the previous one

// The duration for which the error, which grows with its third power, meets the tolerance, with a
// margin, because a step with a larger error is not repeated.
double next_duration(double dt, double error, double tolerance) {
    constexpr double caution = 0.8;
    constexpr double largest_factor = 1.5;
    return dt * std::clamp(caution * std::cbrt(tolerance / error), min_factor, largest_factor);
}

void add(FluidStep& all, const FluidStep& one) {
    StepReport moved = one.moved;
    moved.operations += all.moved.operations;
    moved.sub_steps += all.moved.sub_steps;
    moved.passes += all.moved.passes;
    moved.unreached += all.moved.unreached;
    moved.held += all.moved.held;
    all = {.steps = all.steps + one.steps,
           .error = std::max(all.error, one.error),
           .moved = moved,
           .solved = one.solved,
           .move_s = all.move_s + one.move_s,
           .assembly_s = all.assembly_s + one.assembly_s,
           .solve_s = all.solve_s + one.solve_s};
}

void check_complex(const MeshSnapshot& mesh, const FluidOptions& options) {
    if (mesh.triangles.empty()) {
        throw InputError({.what = "the complex is empty",
                          .where = "Fluid",
                          .value = "no triangles",
                          .allowed = "a triangulated domain"});
    }
    for (const SnapshotTriangle& triangle : mesh.triangles) {
        (void)fluid_of(options, triangle.phase);
    }
    for (const SnapshotEdge& edge : mesh.interface) {
        (void)pair_of(options, edge.left, edge.right);
    }
}

} // namespace

void archive(Archive& archive, PhaseArea& area) { archive(area.phase, area.area); }

Fluid::Fluid(const Complex<double>& complex, FluidOptions options)
    : complex_(complex), options_(std::move(options)), system_(std::make_unique<FluidSystem>()) {
    check_fluid(options_);
    fill_voids(options_.phases);
    MeshSnapshot mesh = snapshot_of(complex_);
    check_complex(mesh, options_);
    check_sides_exist(mesh, options_);
    const bool has_curved_walls = walls_of(mesh, options_, 0, nullptr).has_curved;
    areas_ = phase_areas(mesh);
    if (options_.equations == FluidEquations::stokes) {
        FluidStep report;
        one_ = solution_in(mesh, 0, nullptr, report);
        if (has_curved_walls) { // their velocities depend on a solution
            one_ = solution_in(std::move(mesh), 0, one_.get(), report);
        }
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
    if (&simulation.complex() != &complex_) {
        throw InputError(
            {.what = "the simulation belongs to another complex",
             .where = "Fluid::step",
             .value = "a Simulation of another Complex",
             .allowed = "a Simulation of the Complex given to the constructor of Fluid"});
    }
    if (two_ == nullptr) { // the first step; an archive of the complex has the marks
        for (const Vertex v : ends_of_sides(snapshot_of(complex_), options_)) {
            simulation.complex().set_boundary_feature(v, true);
        }
    }
    FluidStep report;
    // At the start, at rest, the velocity cannot be extrapolated: the first step moves the
    // interface by the solution in the old mesh for the end of the step.
    std::unique_ptr<FluidField> guess;
    FluidPast moving_vertex = past();
    if (options_.equations == FluidEquations::navier_stokes && two_ == nullptr) {
        guess = solution_in(one_->mesh, time() + dt, one_.get(), report);
        moving_vertex = {guess.get(), one_.get()};
    }
    BoundaryFlow boundary(areas_, time(), inflows_at(moving_vertex, time() + dt / 2),
                          swept_by_boundary(one_->mesh, areas_), one_->mesh.domain, options_);
    // Refuses a profile before anything moves.
    (void)walls_of(one_->mesh, options_, time() + dt, one_.get());
    Timer timer;
    report.moved = simulation.step(
        motion_in(moving_vertex, boundary, has_even_edges(simulation.options())), time(), dt);
    report.move_s = timer.lap();
    if (report.moved.gave_up != GiveUp::none) {
        report.steps = 0;
    } else {
        auto next = solution_in(snapshot_of(complex_), time() + dt, moving_vertex.one, report);
        areas_ = boundary.areas_at(next->time);
        report.error = error_of_motion(*next, moving_vertex, next->time - time());
        two_ = std::exchange(one_, std::move(next));
    }
    return report;
}

FluidStep Fluid::advance(Simulation<double>& simulation, double duration) {
    if (options_.tolerance == 0) {
        return step(simulation, duration);
    }
    require(std::isfinite(duration) && duration > 0, "duration of a fluid's motion", duration,
            "above 0");
    const double end = time() + duration;
    const double shortest = duration / 1000;
    const double longest = duration;
    FluidStep all;
    all.steps = 0;
    while (all.moved.gave_up == GiveUp::none && end - time() > shortest / 2) {
        const double wanted = std::clamp(next_dt_, shortest, longest);
        const double dt = (end - time()) / std::ceil((end - time()) / wanted - 1e-9);
        const FluidStep one = step(simulation, dt);
        next_dt_ =
            one.steps == 0 ? min_factor * dt : next_duration(dt, one.error, options_.tolerance);
        add(all, one);
    }
    return all;
}

void Fluid::archive(Archive& archive) {
    as_a_whole(archive, [&](Archive& each) {
        transfer(each);
        // This bound is not checked for a value read back, because the mesh may have changed since.
        each.expect(!archive.is_reading() || &each != &archive ||
                        one_->mesh.vertex_bound == complex_.vertex_bound(),
                    "contains the flow of another mesh");
    });
}

void Fluid::transfer(Archive& archive) {
    archive(areas_, next_dt_);
    archive.expect(std::isfinite(next_dt_) && next_dt_ >= 0,
                   "contains a time step that is negative or not finite");
    bool has_two = two_ != nullptr;
    archive(has_two);
    if (archive.is_reading()) {
        two_ = has_two ? std::make_unique<FluidField>() : nullptr;
    }
    archive(*one_);
    if (has_two) {
        archive(*two_);
    }
}

Point<double> Fluid::force_on(const std::string& side) const {
    const auto found = std::ranges::find(options_.sides, side, &FluidSide::name);
    if (found == options_.sides.end()) {
        std::string names;
        for (const FluidSide& known : options_.sides) {
            names += (names.empty() ? "" : ", ") + known.name;
        }
        throw InputError({.what = "no such side in FluidOptions::sides",
                          .where = "Fluid::force_on",
                          .value = "'" + side + "'",
                          .allowed = names.empty() ? "none: no sides are given" : names});
    }
    const auto index = static_cast<std::size_t>(found - options_.sides.begin());
    return index < one_->side_forces.size() ? one_->side_forces[index] : Point<double>(0, 0);
}

// The pressure is extrapolated in time, like the velocity.
std::vector<double> Fluid::inflows_at(const FluidPast& past, double at) const {
    const Walls& walls = options_.walls;
    const bool is_open = std::ranges::any_of(
        std::array{walls.left, walls.right, walls.bottom, walls.top, walls.other},
        [](Wall wall) { return wall == Wall::open; });
    const bool has_flow = std::ranges::any_of(options_.sides, [](const FluidSide& side) {
        return side.wall == Wall::open || side.velocity || side.inflow;
    });
    if (!is_open && !has_flow && !options_.wall_at && !options_.wall_velocity) {
        return {};
    }
    std::vector<double> inflows = inflows_of(*past.one, areas_);
    if (past.two != nullptr) {
        const double share = (at - past.one->time) / (past.one->time - past.two->time);
        const std::vector<double> two = inflows_of(*past.two, areas_);
        for (std::size_t i = 0; i < inflows.size(); ++i) {
            inflows[i] += share * (inflows[i] - two[i]);
        }
    }
    return inflows;
}

std::unique_ptr<FluidField> Fluid::solution_in(MeshSnapshot mesh, double time,
                                               const FluidField* last, FluidStep& report) {
    Timer timer;
    const Dissection dissection = dissect(mesh);
    const FluidNumbering numbers = number_unknowns(mesh, dissection, options_, time, last);
    assemble(mesh, numbers, options_, past(), time, *system_);
    report.assembly_s += timer.lap();
    const Eigen::VectorXd unknowns =
        solve(*system_, dissection, numbers, options_.threads, report.solved);
    auto field = std::make_unique<FluidField>(field_of(std::move(mesh), numbers, unknowns, time));
    field->side_forces = side_forces(*system_, numbers, unknowns, *field, options_.sides.size());
    report.solve_s += timer.lap();
    return field;
}

} // namespace dsc
