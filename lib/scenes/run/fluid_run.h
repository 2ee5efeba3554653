// SPDX-License-Identifier: MIT
// A fluid during a run, and its figures after each step: of the phase that the scene measures, or
// of phase 1. Lengths are in units of the domain; other units follow from those of the scene's
// fluids.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/io/pictures.h"
#include "fluid/fluid.h"
#include "measures/figures.h"
#include "scenes/scene.h"

#include <vector>

namespace dsc::scenes {

/// Figures of a fluid at one time; NaN if not measured.
struct FluidMoment {
    double time = 0;
    double circularity = 0;      ///< by the cubic through the vertices; NaN for a phase at a wall
    double centre = 0;           ///< y of the phase's centroid
    double rise_velocity = 0;    ///< the mean of its vertical velocity
    double area = 0;             ///< with straight edges
    double largest_velocity = 0; ///< anywhere
    double pressure_jump = 0;    ///< mean pressure of the phase minus that of the exterior phase
    double energy = 0;           ///< sum of kinetic, potential and surface energies
    double amplitude = 0;        ///< of the scene's small wave; NaN without one
    double exact_amplitude = 0;  ///< the same
    double neck = 0;             ///< of the scene's neck; NaN without one
    double exact_neck = 0;       ///< the same
};

/// Whether the measured phase touches no side of the domain at the start, so that it has a
/// circularity. Takes as long as the first mesh.
[[nodiscard]] bool has_circularity(const Setup& setup, const Parameters& parameters);

/// A fluid with its figures over time and the time it took.
class FluidRun {
public:
    /// The complex must outlive it. Throws InputError where `Fluid` does.
    FluidRun(const Complex<double>& complex, const Setup& setup, std::uint32_t threads);

    /// Throws InputError for a tension of two phases that do not meet now. To be called if the
    /// topology is kept, because such phases then never meet.
    void check_pairs_meet() const;
    /// Saves the state, which is restored if the step fails, because a failed step leaves a mesh
    /// without a flow.
    void before_step(Simulation<double>& simulation);
    /// Moves the interface of the simulation. A failed step is undone; its report only says why it
    /// gave up.
    StepReport step(Simulation<double>& simulation, double dt);
    /// Measures the last step, which must have a flow.
    void look();
    /// Why the last step failed; empty if it did not.
    [[nodiscard]] const std::string& failure() const { return failure_; }

    /// The last figures, for a row of a series: always the same names.
    [[nodiscard]] Figures now() const;
    /// The figures of the whole run, and the seconds of the solver, the assembly and the mesh.
    [[nodiscard]] Figures figures() const;
    /// Sets `velocity` at the vertices, and adds `pressure` and `pressure_beyond` of each vertex:
    /// the pressures in its phases with the smallest and the largest number. They are equal away
    /// from the interface.
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
