// SPDX-License-Identifier: MIT
// One time step. The sub-step is the outermost loop: no vertex is asked to move more than a
// fraction of an edge length at a time, and all passes end before the next sub-step begins.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc3/passes/state.h"

#include <cstdint>

namespace dsc3 {

using dsc::GiveUp;

/// What one step did.
struct StepReport {
    OperationCounts operations;  ///< counts of what was done
    std::uint32_t sub_steps = 0; ///< how many the step was cut into
    std::uint32_t passes = 0;    ///< of movement and mesh repair, summed over sub-steps
    /// Vertices that did not arrive, summed over sub-steps; includes `held`. Each goes on from
    /// where it should have been.
    std::uint64_t unreached = 0;
    std::uint64_t held = 0;     ///< of these: held because of a velocity that was not finite
    std::uint64_t unjammed = 0; ///< interface collapses with laxer rules, to let vertices arrive
    /// Vertices of the interface, summed over sub-steps: what the cost of a step is measured by.
    std::uint64_t moves = 0;
    double error = 0;                     ///< the largest estimate of `adaptive`, a length
    GiveUp gave_up = GiveUp::none;        ///< `none` if the step was done as a whole
    std::uint32_t interface_vertices = 0; ///< at the end of the step
    double reached = 0; ///< the time at the end: earlier than asked for if the step gave up
};

/// A simulation of a complex. Keeps a reference to the complex, which must outlive it, and a copy
/// of the options. Between two steps the application may edit the complex by the public operations:
/// the next step then finds the interface anew. Not thread-safe itself. Only one simulation a
/// complex at a time: the constructor throws InputError where another one lives.
class Simulation : public Unmovable {
public:
    /// Throws InputError if an option is out of range.
    Simulation(Complex& complex, const Options& options);

    [[nodiscard]] const Options& options() const { return options_; }

    /// Moves the interface from `time` to `time + dt`. O(interface vertices and what changes around
    /// them). Throws InputError if dt is negative or not finite, or an attribute is a field.
    StepReport step(const Velocity& velocity, Real time, Real dt);

    /// Writes all that the steps to come depend on, the complex included, or reads it back into a
    /// simulation with the same options; the steps that follow are then the same to the bit.
    /// O(n log n). Throws FileError if the bytes hold no valid complex, or one with other
    /// attributes: the simulation and its complex then go on from where they were.
    void archive(dsc::Archive& archive);

    /// The vertices of the interface, by ascending id.
    [[nodiscard]] const std::vector<std::uint32_t>& interface() const { return state_.interface; }

private:
    struct Late {
        std::uint32_t vertex = no_id;
        /// Where it is: a new vertex that got the id of an old one is elsewhere.
        Point place = Point::Zero();
        Point target = Point::Zero();
    };
    void find_origins();
    /// Returns the duration of the sub-step; 0 if more sub-steps than allowed would be needed.
    Real find_targets(const Velocity& velocity, Real time, Real remaining, StepReport& report);
    void move(StepReport& report);
    void transfer(dsc::Archive& archive);

    Complex& complex_;
    dsc::Claim claim_;
    Options options_;
    PassState state_;
    std::uint64_t version_;  ///< of the complex at the end of the last step
    std::vector<Late> late_; ///< vertices that have not arrived, by ascending id
    std::vector<Point> origins_;
    std::vector<Point> targets_;
    std::vector<std::uint8_t> held_;
    IntegratorScratch scratch_;
};

} // namespace dsc3
