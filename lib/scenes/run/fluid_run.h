// SPDX-License-Identifier: MIT
// A fluid during a run, and what is measured of it after each step: of the phase that the scene
// measures, or of phase 1. Lengths are in units of the domain, all else follows from the units of
// the scene's fluids.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/io/pictures.h"
#include "fluid/fluid.h"
#include "measures/figures.h"
#include "scenes/scene.h"

#include <vector>

namespace dsc::scenes {

/// One moment of a fluid. What could not be measured is NaN.
struct FluidMoment {
    double time = 0;
    double circularity = 0;      ///< of the cubic through the vertices; NaN for a phase at a wall
    double centre = 0;           ///< y of the phase's centroid
    double rise_velocity = 0;    ///< the mean of its vertical velocity
    double area = 0;             ///< with straight edges
    double largest_velocity = 0; ///< anywhere
    double pressure_jump = 0;    ///< mean pressure of the phase less that of the exterior
    double energy = 0;           ///< kinetic, potential and of the surfaces
    double amplitude = 0;        ///< of the scene's small wave; NaN without one
    double exact_amplitude = 0;  ///< the same
    double neck = 0;             ///< of the scene's neck; NaN without one
    double exact_neck = 0;       ///< the same
};

/// A fluid, its moments so far and the time that it took.
class FluidRun {
public:
    /// The complex must outlive it. Throws InputError where `Fluid` does.
    FluidRun(const Complex<double>& complex, const Setup& setup, std::uint32_t threads);

    /// Throws InputError if there is a tension of two phases that do not meet now: to be called
    /// where the topology is kept, so that they never will.
    void check_pairs_meet() const;
    /// Keeps the state, to which a step that fails goes back: it leaves a mesh without its flow.
    void before_step(Simulation<double>& simulation);
    /// Moves the interface of the simulation. A step that fails is undone: its report says only why
    /// it gave up.
    StepReport step(Simulation<double>& simulation, double dt);
    /// Measures what the last step, which has a flow, has come to.
    void look();
    /// Why the last step has no flow; empty: it has.
    [[nodiscard]] const std::string& failure() const { return failure_; }

    /// The last moment, for a row of a series: always the same names.
    [[nodiscard]] Figures now() const;
    /// The figures of all moments, and the seconds of the solver, the assembly and the mesh.
    [[nodiscard]] Figures figures() const;
    /// Sets `velocity` to that at the vertices, and adds `pressure` and `pressure_beyond` of each
    /// vertex: its pressure in the phase of the smallest number there, and in that of the largest.
    /// Both are the same away from the interface.
    void put_into(std::vector<VtuArray>& arrays) const;

    void archive(Archive& archive);

private:
    const Complex<double>& complex_;
    FluidMotion motion_;
    Phase phase_;
    Fluid fluid_;
    Archive before_; ///< the state before the step
    std::string failure_;
    std::vector<FluidMoment> moments_;
    double solve_s_ = 0;
    double assembly_s_ = 0;
    double dsc_s_ = 0;
};

} // namespace dsc::scenes
