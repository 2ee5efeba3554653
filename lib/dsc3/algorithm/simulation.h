// SPDX-License-Identifier: MIT
// One time step. The sub-step is the outermost loop: in a sub-step no target is farther than a
// fraction of an edge length, and all passes end before the next sub-step begins.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc3/parallel/parallel.h"
#include "dsc3/passes/state.h"
#include "dsc3/queries/phases.h"

#include <cstdint>
#include <memory>

namespace dsc3 {

using dsc::GiveUp;

/// What one step did.
struct StepReport {
    OperationCounts operations;  ///< counts of what was done
    std::uint32_t sub_steps = 0; ///< number of sub-steps
    std::uint32_t passes = 0;    ///< of movement and mesh repair, summed over sub-steps
    /// Vertices that did not arrive, summed over sub-steps; includes `held`. Their motion continues
    /// from the target that they missed.
    std::uint64_t unreached = 0;
    std::uint64_t held = 0;     ///< vertices that stayed because their velocity was not finite
    std::uint64_t unjammed = 0; ///< interface collapses under relaxed rules, to let vertices arrive
    /// Vertices of the interface, summed over sub-steps: a measure of the work of a step.
    std::uint64_t moves = 0;
    std::uint64_t treated = 0;            ///< tets that mesh repair tried to improve
    std::uint64_t treated_together = 0;   ///< of these, by several submeshes at the same time
    double error = 0;                     ///< the largest estimate of `adaptive`, a length
    GiveUp gave_up = GiveUp::none;        ///< `none` if the step was completed
    std::uint32_t interface_vertices = 0; ///< at the end of the step
    double reached = 0; ///< the time at the end; earlier than `time + dt` if the step gave up
};

/// A simulation of a complex. Keeps a reference to the complex, which must outlive it, and a copy
/// of the options. Between two steps the application may edit the complex by the public operations:
/// the next step then searches for the interface again. Not thread-safe. A complex has at most one
/// simulation at a time: the constructor throws InputError if there is another one.
class Simulation : public Unmovable {
public:
    /// Throws InputError if an option is out of range.
    Simulation(Complex& complex, const Options& options);
    /// In parallel. The result is the same for any number of threads; it differs from that of the
    /// sequential method, because submeshes are repaired in another order. The velocity is called
    /// by several threads at once, each time for some of the vertices.
    Simulation(Complex& complex, const Options& options, const Parallel& parallel);

    [[nodiscard]] const Options& options() const { return options_; }

    /// Moves the interface from `time` to `time + dt`. O(interface vertices and changed tets). A
    /// step that begins after many edits first renumbers the tets, in O(n log n): handles of tets
    /// are valid until the next step, those of vertices as long as their vertex lives. Throws
    /// InputError if dt is negative or not finite, or an attribute is a field.
    StepReport step(const Velocity& velocity, Real time, Real dt) {
        return advance(velocity, submeshes_ != nullptr, time, dt);
    }
    /// The same with a velocity that is called once for the whole interface.
    StepReport step(const VelocityAtOnce& at_once, Real time, Real dt) {
        return advance(at_once.velocity, false, time, dt);
    }

    /// The report of the last step. If an exception of the velocity ended it, the complex is valid,
    /// and this is the report of the sub-steps before: `reached` is the time of the complex.
    [[nodiscard]] const StepReport& report() const { return report_; }

    /// The times of the last step; empty without `Parallel::profile`, and after a state was read.
    [[nodiscard]] const StepProfile& profile() const { return team_.profile(); }

    /// Writes the whole state, the complex included, or reads it back into a simulation with the
    /// same options and submeshes, on any number of threads; the following steps are then bitwise
    /// identical. O(n log n). Throws FileError if the bytes hold no valid complex, or one with
    /// other attributes or submeshes; the simulation and its complex are then unchanged.
    void archive(dsc::Archive& archive);

    /// The extremes of the mesh, found by the threads of the simulation; adds to `profile`.
    /// O(mesh).
    [[nodiscard]] MeshQuality mesh_quality();

    /// The vertices of the interface, by ascending id.
    [[nodiscard]] const std::vector<std::uint32_t>& interface() const { return state_.interface; }

private:
    Simulation(Complex& complex, const Options& options, const Parallel* parallel);

    StepReport advance(const Velocity& velocity, bool in_chunks, Real time, Real dt);
    template <class Work>
    void in_shares(std::size_t n, Work work);
    void find_origins();
    /// Returns the duration of the sub-step; 0 if more sub-steps than allowed would be needed.
    Real find_targets(const Velocity& velocity, Real time, Real remaining);
    void move();
    void note(Real reached);
    void transfer(dsc::Archive& archive);

    Complex& complex_;
    dsc::Claim claim_;
    Options options_;
    Team team_;
    std::unique_ptr<Submeshes> submeshes_; ///< none: sequential
    PassState state_;
    std::uint64_t version_;       ///< of the complex at the end of the last step
    std::uint64_t rewirings_ = 0; ///< since the last renumbering, without the last step
    bool in_chunks_ = false;      ///< whether the velocity may be called for some of the vertices
    StepReport report_;
    std::vector<Point> origins_;
    std::vector<Point> targets_;
    // Fixed coordinates, by interface vertex; empty if there are none.
    std::vector<std::uint32_t> fixed_;
    std::vector<std::uint8_t> held_;
    std::array<IntegratorScratch, Team::max_chunks> scratch_; ///< by share
    std::array<Real, Team::max_chunks> largest_{};            ///< velocity or error, by share
    std::array<Real, Team::max_chunks> farthest_{};           ///< displacement, by share
};

} // namespace dsc3
