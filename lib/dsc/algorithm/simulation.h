// SPDX-License-Identifier: MIT
// One time step [5.6, 8.10]. The sub-step is the outermost loop: no vertex is asked to travel more
// than a part of an edge length at a time, and all passes end before the next sub-step begins.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/motion/integrator.h"

#include <limits>
#include <memory>

namespace dsc {

enum class GiveUp : std::uint8_t {
    none,
    too_many_sub_steps, ///< the velocity asks for more than `max_sub_steps`
};

/// What one step did.
struct StepReport {
    OperationCounts operations;
    std::uint32_t sub_steps = 0;
    std::uint32_t passes = 0;
    std::uint64_t unreached =
        0;                  ///< vertices that did not arrive, summed over sub-steps; with `held`
    std::uint64_t held = 0; ///< of these: held for a velocity that was not finite
    double error = 0;       ///< the largest estimate of `adaptive` that was accepted, a length
    GiveUp gave_up = GiveUp::none;
    Vertex where;                         ///< of the give-up: the fastest vertex...
    double speed = 0;                     ///< ...and its speed
    std::uint32_t interface_vertices = 0; ///< at the end of the step
};

/// A complex under way. Keeps references to the complex and the options; not thread-safe itself.
template <class Real>
class Simulation {
public:
    /// Sequential, with the default algorithm. Throws InputError where an option is out of range.
    Simulation(Complex<Real>& complex, const Options<Real>& options);
    /// With an algorithm or an executor of one's own.
    Simulation(Complex<Real>& complex, const Options<Real>& options,
               std::unique_ptr<Executor<Real>> executor);

    /// Moves the interface from `time` to `time + dt`. O(interface vertices and what changes about
    /// them), never O(mesh). Throws InputError where dt is negative or not finite.
    StepReport step(const Velocity<Real>& velocity, Real time, Real dt);

    /// The flow has changed from one moment to the next: integrators with a memory start anew.
    /// O(interface vertices) for those, O(1) for all others.
    void forget();

    /// The vertices of the interface, about in the order of the curve. O(their number).
    [[nodiscard]] std::vector<std::uint32_t> interface() const;
    [[nodiscard]] std::size_t interface_size() const { return executor_->interface_size(); }

private:
    bool sub_step(const Velocity<Real>& velocity, Real& time, Real& remaining, StepReport& report);
    [[nodiscard]] Real pieces_of_speed(Real remaining, Real fastest) const;
    [[nodiscard]] Real pieces_of(Real remaining, Real fastest) const;
    Real shorten(const Velocity<Real>& velocity, Real time, Real dt, Reach<Real>& reach);
    void find_fastest(const Velocity<Real>& velocity, Real time, StepReport& report) const;

    Complex<Real>& complex_;
    const Options<Real>& options_;
    std::unique_ptr<Executor<Real>> executor_;
    Real fastest_ = 0; ///< speed of the last sub-step: what the next is expected to be like
    Real most_dt_ = std::numeric_limits<Real>::infinity(); ///< by the tolerance of `adaptive`
};

} // namespace dsc
