// SPDX-License-Identifier: MIT
// A fluid and the motion of a simulation's interface by it.
#pragma once

#include "fluid/field/convection.h"
#include "fluid/interface/held_areas.h"
#include "fluid/options.h"
#include "fluid/solve/solve_report.h"

#include <memory>

namespace dsc {

struct FluidSystem;

/// The result of one step of a fluid, or of several.
struct FluidStep {
    int steps = 1;         ///< number of completed steps
    double error = 0;      ///< estimate of the largest error of the interface, in edge lengths
    StepReport moved;      ///< report of the simulation: sums, and the state after the last step
    SolveReport solved;    ///< of velocity and pressure
    double move_s = 0;     ///< seconds for the simulation, including interpolation of velocities
    double assembly_s = 0; ///< seconds for the copy of the mesh, the numbering and the matrix
    double solve_s = 0;    ///< seconds for the factorisation and the refinement
};

/// Incompressible flow of two or more phases in the mesh of a complex, which fits the interface;
/// the flow moves the simulation's interface:
///
///     dsc::Fluid fluid(complex, options);
///     for (int i = 0; i < 300; ++i) { fluid.step(simulation, 0.01); }
///
/// The domain has any shape. Velocities are quadratic in each triangle and linear along each edge
/// between two phases, pressures linear with a jump there: spurious currents at a polygon whose
/// edges are in balance stay at rounding level. A step moves the interface by the velocity
/// extrapolated in time (whatever the integrator of the simulation), and then solves for velocity
/// and pressure in the new mesh, with inertia by particles that are followed back to the last two
/// meshes. Second order in the edge length and in time; away from interfaces velocities are of
/// third order, also beside curved walls without slip. No limit on the time step from tension or
/// from the speed. Vertices slide along the interface towards equal edges, unless the simulation's
/// options adapt edges to the shape (`turn_degrees`, `gap`) or set their length
/// (`on_interface`). Stages of the simulation, such as `TopologyStage`, run as in any other one.
/// The area of each phase is constant, apart from what flows in and out: after each sub-step each
/// curve is moved along its normal by the distance that restores the areas.
///
/// A step takes O(n) time, apart from the factorisation: about O(n^1.5). Memory: the factors, two
/// copies of the mesh and the matrices of the elements, about 2 kB for each triangle. Results are
/// bitwise identical for any number of threads. Not thread-safe.
class Fluid {
public:
    /// Makes a fluid at rest at time 0; for `FluidEquations::stokes`, with the velocity that
    /// follows from the interface. The complex must outlive the fluid. Throws InputError if an
    /// option is out of range, a phase has no properties, or two phases meet without a tension;
    /// SolveError if the equations of Stokes cannot be solved.
    Fluid(const Complex<double>& complex, FluidOptions options);
    ~Fluid();
    Fluid(const Fluid&) = delete;
    Fluid& operator=(const Fluid&) = delete;
    Fluid(Fluid&&) = delete;
    Fluid& operator=(Fluid&&) = delete;

    /// Moves the interface of the simulation, which must be one of the fluid's complex, and solves
    /// for the flow at `time() + dt`. If the simulation gives up, the flow stays unchanged: see
    /// `moved.gave_up`. Throws InputError if dt is not above 0, or two phases meet without a
    /// tension; SolveError if the equations cannot be solved. After an exception, and after a step
    /// that gave up, the mesh may have moved while the flow has not: to be able to go back, archive
    /// the simulation and the fluid before a step that may fail.
    FluidStep step(Simulation<double>& simulation, double dt);
    /// Advances to `time() + duration`: in one step, or with a tolerance in as many as needed. The
    /// error of a step is estimated from the difference between the new velocity and the one that
    /// moved the interface. It determines the length of the next step, from a thousandth of the
    /// duration to all of it; a step that exceeds the tolerance is not repeated. Stops when a step
    /// gives up; the next step is then shorter. Throws as `step` does.
    FluidStep advance(Simulation<double>& simulation, double duration);
    /// Writes or reads the whole state except the simulation and its complex, which must be
    /// archived before it. Throws FileError if the bytes are not those of a fluid, or belong to
    /// another mesh; the fluid is then unchanged.
    void archive(Archive& archive);

    /// The time of the last solution.
    [[nodiscard]] double time() const { return one_->time; }
    /// Velocity and pressure. With inertia, the pressure is 0 until the first step.
    [[nodiscard]] const FluidField& field() const { return *one_; }
    /// The force of the fluid on a side of `FluidOptions::sides`: drag and lift. It is zero before
    /// the first step with inertia; where sides meet it counts to the first of them. Throws
    /// InputError for an unknown name.
    [[nodiscard]] Point<double> force_on(const std::string& side) const;
    /// The options of all steps.
    [[nodiscard]] const FluidOptions& options() const { return options_; }

private:
    [[nodiscard]] FluidPast past() const { return {one_.get(), two_.get()}; }
    void transfer(Archive& archive);
    [[nodiscard]] std::vector<double> inflows_at(const FluidPast& past, double at) const;
    [[nodiscard]] std::unique_ptr<FluidField>
    solution_in(MeshSnapshot mesh, double time, const FluidField* last, FluidStep& report);

    const Complex<double>& complex_;
    FluidOptions options_;
    std::vector<PhaseArea> areas_; ///< areas to be restored, with inflow and outflow
    double next_dt_ = 0; ///< length of the step that meets the tolerance; 0: not known yet
    std::unique_ptr<FluidField> one_;     ///< the last solution; null only during construction
    std::unique_ptr<FluidField> two_;     ///< the previous solution; null at the start
    std::unique_ptr<FluidSystem> system_; ///< of the last solution; the next one reuses its memory
};

} // namespace dsc
