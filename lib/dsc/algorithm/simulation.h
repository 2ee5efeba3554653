// SPDX-License-Identifier: MIT
// One time step [5.6, 8.10]. The sub-step is the outermost loop: no vertex is asked to travel more
// than a part of an edge length at a time, and all passes end before the next sub-step begins.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/motion/integrator.h"

#include <atomic>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace dsc {

enum class GiveUp : std::uint8_t {
    none,
    too_many_sub_steps, ///< the velocity asks for more than `max_sub_steps`
    interrupted,        ///< `Simulation::interrupt_by`
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
    double reached = 0; ///< the time at the end: earlier than asked for where it gave up
};

/// How many threads, and how the mesh is divided among them; see parallel/parallel.h.
struct Parallel;

/// A complex under way. Keeps a reference to the complex, which must outlive it, and a copy of the
/// options. Between two steps the application may edit the complex by the public operations (and
/// `set_position`, `set_phase`, `renumber`): the next step takes up what they changed. Not
/// thread-safe itself; one simulation a complex at a time.
template <class Real>
class Simulation {
public:
    /// Sequential, with the default algorithm. Throws InputError where an option is out of range.
    Simulation(Complex<Real>& complex, const Options<Real>& options);
    /// In parallel: `Simulation simulation(complex, options, Parallel{.threads = 2})`. The result
    /// does not depend on the number of threads.
    Simulation(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel);
    /// With an executor of one's own, or an algorithm of one's own in one of the library's.
    Simulation(Complex<Real>& complex, const Options<Real>& options,
               std::unique_ptr<Executor<Real>> executor);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    Simulation(Simulation&&) = delete;
    Simulation& operator=(Simulation&&) = delete;

    [[nodiscard]] const Options<Real>& options() const { return options_; }
    /// Checks the options and takes them as a whole for the next step; integrators with a memory
    /// start anew where the integrator changes. Throws InputError where one is out of range, and
    /// keeps the old ones then.
    void set_options(const Options<Real>& options);

    /// Has all edits told from now on: those of the application between steps at the beginning of
    /// the next step, those of a step after each of its sub-steps. The same records in the same
    /// order for any number of threads. Without a listener nothing is paid for it.
    void add_listener(EditListener listener);

    /// Steps end after the sub-step in which the flag is set, as given up. Null: none does.
    void interrupt_by(const std::atomic<bool>* flag) { interrupted_ = flag; }

    /// Moves the interface from `time` to `time + dt`. O(interface vertices and what changes about
    /// them), never O(mesh). Throws InputError where dt is negative or not finite.
    StepReport step(const Velocity<Real>& velocity, Real time, Real dt) {
        return step_along(velocity, time, dt);
    }
    /// The same by a flow that sees the interface (motion/interface_flow.h).
    StepReport step(const InterfaceFlow<Real>& flow, Real time, Real dt) {
        return step_along(flow, time, dt);
    }

    /// The flow has changed from one moment to the next: integrators with a memory start anew.
    /// O(interface vertices) for those, O(1) for all others.
    void forget();

    /// The vertices of the interface, about in the order of the curve. O(their number).
    [[nodiscard]] std::vector<std::uint32_t> interface() const;
    [[nodiscard]] std::size_t interface_size() const { return executor_->interface_size(); }

private:
    StepReport step_along(const Flow<Real>& flow, Real time, Real dt);
    bool sub_step(const Flow<Real>& flow, Real& time, Real& remaining, StepReport& report);
    [[nodiscard]] Real pieces_of_speed(Real remaining, Real fastest) const;
    [[nodiscard]] Real pieces_of(Real remaining, Real fastest) const;
    Real shorten(const Flow<Real>& flow, Real time, Real dt, Reach<Real>& reach);
    void find_fastest(const Flow<Real>& flow, Real time, StepReport& report) const;

    void absorb();
    void forget_vertex(Vertex v);
    void tell(std::span<const Edit> edits);
    void tell_what_was_done();

    Complex<Real>& complex_;
    Options<Real> options_;
    std::unique_ptr<Executor<Real>> executor_;
    Real fastest_ = 0; ///< speed of the last sub-step: what the next is expected to be like
    std::vector<EditListener> listeners_;
    std::size_t absorbed_ = 0; ///< records of the journal that have been read
    const std::atomic<bool>* interrupted_ = nullptr;
    Real most_dt_ = std::numeric_limits<Real>::infinity(); ///< by the tolerance of `adaptive`
};

} // namespace dsc
