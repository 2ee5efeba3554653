// SPDX-License-Identifier: MIT
// A fluid that moves the interface of a simulation.
#pragma once

#include "fluid/field/convection.h"
#include "fluid/interface/held_areas.h"
#include "fluid/options.h"
#include "fluid/solve/solve_report.h"

#include <memory>

namespace dsc {

struct FluidSystem;

/// What a step of a fluid did, or several of them.
struct FluidStep {
    int steps = 1;         ///< how many were made; one that gave up is none
    double error = 0;      ///< of the interface: an estimate of the largest, in edges there
    StepReport moved;      ///< of the simulation: sums, and the end of the last step
    SolveReport solved;    ///< of velocity and pressure
    double move_s = 0;     ///< seconds for the simulation, with the look-up of velocities
    double assembly_s = 0; ///< seconds for the copy of the mesh, the numbering and the matrix
    double solve_s = 0;    ///< seconds for the factorisation and the refinement
};

/// Incompressible flow of two and more phases, fitted to the interface of a complex, and the
/// simulation's interface moved by it:
///
///     dsc::Fluid fluid(complex, options);
///     for (int i = 0; i < 300; ++i) { fluid.step(simulation, 0.01); }
///
/// The domain is a rectangle with sides parallel to the axes. Velocities are quadratic in each
/// triangle and linear along each edge between two phases, pressures linear with a jump there: a
/// polygon whose edges balance each other rests to rounding. A step moves the interface by the
/// velocity extrapolated in time (whatever the integrator of the simulation), and then solves for
/// velocity and pressure in the new mesh, with inertia by particles that are followed back to the
/// last two meshes. Second order in the edge length and in time; no limit on the time step from
/// tension or from the speed. Vertices slide along the interface towards equal edges, unless the
/// simulation has edges that follow the shape
/// (`turn_degrees`, `gap`) or a length of their own (`on_interface`). Stages of the
/// simulation, such as `TopologyStage`, run as in any other one. The area of each phase is held to
/// that of the start: after each sub-step each curve is moved along its normal by the distance that
/// brings back what is missing.
///
/// A step takes O(n) time, apart from the factorisation: about O(n^1.5). Memory: the factors, two
/// copies of the mesh and the matrices of the elements, about 2 kB for each triangle. Any number of
/// threads gives the same bits. Not thread-safe itself.
class Fluid {
public:
    /// At rest, at time 0; for `FluidEquations::stokes` with the velocity that the interface gives.
    /// The complex must outlive the fluid. Throws InputError if an option is out of range, a phase
    /// has no properties, two phases meet without a tension, or the domain is no rectangle with
    /// sides parallel to the axes; SolveError if the equations of Stokes cannot be solved.
    Fluid(const Complex<double>& complex, FluidOptions options);
    ~Fluid();
    Fluid(const Fluid&) = delete;
    Fluid& operator=(const Fluid&) = delete;
    Fluid(Fluid&&) = delete;
    Fluid& operator=(Fluid&&) = delete;

    /// Moves the interface of the simulation, which must be one of the fluid's complex, and finds
    /// the flow at `time() + dt`. If the simulation gives up, the flow stays as it was: see
    /// `moved.gave_up`. Throws InputError if dt is not above 0, or phases meet that have no
    /// tension; SolveError if the equations cannot be solved.
    /// After either of these two, and after a step that gave up, the mesh may have moved without
    /// its flow: to go back, archive the simulation and the fluid before a step that may fail.
    FluidStep step(Simulation<double>& simulation, double dt);
    /// Steps until `time() + duration`: one, or with a tolerance as many as it asks for. The error
    /// of a step is estimated by the difference of the velocity from the one that the interface was
    /// moved with. The length of the next step is chosen from it, from a thousandth of the duration
    /// to all of it; a step that exceeds the tolerance is kept. Stops where a step gives up; the
    /// next one is shorter then. Throws as `step` does.
    FluidStep advance(Simulation<double>& simulation, double duration);
    /// All that the next step depends on, apart from the simulation and its complex, which have to
    /// be archived before it. Throws FileError for what no fluid can have written, or of another
    /// mesh; the fluid is then what it was before.
    void archive(Archive& archive);

    /// Of the last solution.
    [[nodiscard]] double time() const { return one_->time; }
    /// Velocity and pressure. With inertia, the pressure is 0 until the first step has been made.
    [[nodiscard]] const FluidField& field() const { return *one_; }
    /// Those of all steps.
    [[nodiscard]] const FluidOptions& options() const { return options_; }

private:
    [[nodiscard]] FluidPast past() const { return {one_.get(), two_.get()}; }
    void transfer(Archive& archive);
    [[nodiscard]] std::unique_ptr<FluidField> solution_in(MeshSnapshot mesh, double time,
                                                          FluidStep& report);

    const Complex<double>& complex_;
    FluidOptions options_;
    std::vector<PhaseArea> areas_;        ///< to be held
    double next_dt_ = 0;                  ///< the step that aims at the tolerance; 0: not known yet
    std::unique_ptr<FluidField> one_;     ///< the last solution; null only during construction
    std::unique_ptr<FluidField> two_;     ///< the one before; null at the start
    std::unique_ptr<FluidSystem> system_; ///< of the last solution: the next one uses its memory
};

} // namespace dsc
