// SPDX-License-Identifier: MIT
// Time steps (thesis, sections 5.6 and 8.10), which are divided into sub-steps with stages in
// between. The sub-step is the outermost loop: no vertex has to move more than a fraction of an
// edge length at a time, and all passes end before the next sub-step begins.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/base/names.h"
#include "dsc/complex/complex.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/passes/options.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace dsc {

template <class Real>
class Executor; // algorithm/executor.h
template <class Real>
class Stage; // algorithm/stage.h
template <class Real>
struct Reach;
template <class Real>
struct TargetReport;

/// Why a step ended early.
enum class GiveUp : std::uint8_t {
    none,
    too_many_sub_steps, ///< the velocity requires more than `max_sub_steps`
    too_many_passes,    ///< vertices had not arrived after `max_passes` of a sub-step
    velocity_jumps,     ///< sub-steps of `adaptive` become ever shorter where the velocity jumps
    interrupted,        ///< by `Simulation::interrupt_by`
};

inline constexpr std::array give_up_names{
    Named{GiveUp::none, "none"},
    Named{GiveUp::too_many_sub_steps, "too_many_sub_steps"},
    Named{GiveUp::too_many_passes, "too_many_passes"},
    Named{GiveUp::velocity_jumps, "velocity_jumps"},
    Named{GiveUp::interrupted, "interrupted"},
};

/// What one step did.
struct StepReport {
    OperationCounts operations;  ///< counts of operations, including those of stages
    std::uint32_t sub_steps = 0; ///< number of sub-steps
    std::uint32_t passes = 0;    ///< of movement and mesh update, summed over sub-steps
    /// Vertices that did not arrive, summed over sub-steps; includes `held`. Vertices whose piece
    /// of a phase vanished in the same sub-step do not count: no interface remains there.
    std::uint64_t unreached = 0;
    std::uint64_t held = 0; ///< of these, vertices held because of a velocity that was not finite
    double error = 0;       ///< the largest estimate of `adaptive` that was accepted, a length
    GiveUp gave_up = GiveUp::none; ///< `none` if the step was done as a whole
    Vertex where;     ///< when the step gave up: the fastest vertex, or where the velocity jumps
    double speed = 0; ///< when the step gave up: the largest speed
    std::uint32_t interface_vertices = 0; ///< at the end of the step
    double reached = 0; ///< the time at the end: time + dt, or earlier if the step gave up
};

/// Why a step gave up and what may help; empty if it did not give up.
[[nodiscard]] std::string sentence(const StepReport& report);

/// The number of threads, and how the mesh is divided among them; see parallel/parallel.h.
struct Parallel;

/// Reserves a complex for one simulation while this object lives. Throws InputError if another
/// simulation has reserved it.
class Claim : public Unmovable {
public:
    /// Reserves the complex that `use` belongs to.
    explicit Claim(InUse& use) : use_(use) {
        use.expect_free();
        use.by_a_simulation = true;
    }
    ~Claim() { use_.by_a_simulation = false; }

private:
    InUse& use_;
};

/// A simulation of a complex. Keeps a reference to the complex, which must outlive it, and a copy
/// of the options. Between two steps the application may edit the complex by the public operations
/// (and `set_position`, `set_phase`, `renumber`): the next step takes account of these changes. Not
/// thread-safe itself. While a step runs, `step`, `set_options`, `add_listener`, `add_stage` and
/// `archive` throw InputError. Only one simulation per complex at a time: the constructors throw
/// InputError if another one exists.
template <class Real>
class Simulation : public Unmovable {
public:
    /// Sequential, with the default algorithm. Throws InputError if an option is out of range.
    Simulation(Complex<Real>& complex, const Options<Real>& options);
    /// In parallel: `Simulation simulation(complex, options, Parallel{.threads = 2})`. The result
    /// does not depend on the number of threads.
    Simulation(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel);
    /// With a custom executor, or a custom algorithm in one of the library's executors.
    Simulation(Complex<Real>& complex, const Options<Real>& options,
               std::unique_ptr<Executor<Real>> executor);
    ~Simulation();

    /// The complex passed to the constructor.
    [[nodiscard]] Complex<Real>& complex() { return complex_; }
    /// The same, read-only.
    [[nodiscard]] const Complex<Real>& complex() const { return complex_; }
    /// The options, valid from the next step on.
    [[nodiscard]] const Options<Real>& options() const { return options_; }
    /// Checks the options and replaces all of them for the next step; integrators with a memory
    /// start afresh if the integrator changes. Throws InputError if one is out of range or a stage
    /// refuses them, and then keeps the old ones. All vertices are visited if sizes are or were not
    /// uniform, or if the advected phases change; otherwise none.
    void set_options(const Options<Real>& options);

    /// Reports all edits to the listener from now on: those of the application between steps at the
    /// beginning of the next step, those of a step after each of its sub-steps. The records and
    /// their order are the same for any number of threads. An exception of a listener is passed on
    /// by the step, after all listeners have been called. A listener should not edit the complex:
    /// its edits are reported at the beginning of the next step. Without a listener there is no
    /// cost.
    void add_listener(EditListener listener);

    /// From now on steps list the stars in which they may leave triangles of this quality (equation
    /// 4) or less. This costs almost nothing, because the mesh update knows the quality of the
    /// stars that it leaves.
    void watch_quality(double quality);
    /// Vertices whose stars hold all triangles of the watched quality or less that steps have made
    /// or changed since the last call, and some others; with duplicates, and some may have
    /// vanished. `no_id` is among them if all stars must be examined: after `renumber`, a restore
    /// or create and merge, and once the list has grown longer than the mesh has triangles. Edits
    /// of the application between steps belong to the next step. Valid until the next call. O(their
    /// number).
    [[nodiscard]] std::span<const std::uint32_t> take_poor();

    /// Runs the stage after each sub-step from now on, after the stages that were added before, and
    /// its pass at the end of the remeshing. Call between two steps. Throws InputError if the stage
    /// does not suit the complex or the options, or already belongs to a living simulation.
    void add_stage(std::shared_ptr<Stage<Real>> stage);

    /// A step gives up after the sub-step in which the flag is set. Null: steps are not
    /// interrupted.
    void interrupt_by(const std::atomic<bool>* flag) { interrupted_ = flag; }

    /// Moves the interface from `time` to `time + dt`. O(interface vertices and what changes around
    /// them), never O(mesh), as long as sizes are uniform. Otherwise one vertex in 32 is visited as
    /// well, or all if targets change in time. Throws InputError if dt is negative or not finite;
    /// nothing has changed then. Exceptions of the application's functions are rethrown after the
    /// edits so far have been reported to the listeners; the complex is valid, and the interface
    /// somewhere between `time` and time + dt.
    StepReport step(const Velocity<Real>& velocity, Real time, Real dt) {
        return step_along(velocity, time, dt);
    }
    /// The same with a velocity that is called once for the whole interface
    /// (motion/interface_flow.h).
    StepReport step(const VelocityAtOnce<Real>& at_once, Real time, Real dt) {
        return step_along(at_once, time, dt);
    }
    /// The same with a flow that depends on the interface (motion/interface_flow.h).
    StepReport step(const InterfaceFlow<Real>& flow, Real time, Real dt) {
        return step_along(flow, time, dt);
    }
    /// The same with a motion of the whole interface (motion/interface_flow.h). Also throws
    /// InputError if dt is 0, by which displacements are divided.
    StepReport step(const InterfaceMotion<Real>& motion, Real time, Real dt) {
        return step_along(motion, time, dt);
    }

    /// Between two steps: writes all state that the next one depends on, or reads it back into a
    /// simulation that was made in the same way, of a complex that began as the other did, with the
    /// same options and executor; the steps that follow are then bitwise identical. Listeners are
    /// not included. O(n). Throws FileError if the bytes are of another version of the complex's
    /// attributes, of the other scalar type, or hold an invalid complex; the simulation and its
    /// complex are then unchanged. Throws InputError if a custom executor, partition or attribute
    /// has no archive function. For files: replay/sealed_file.h.
    void archive(Archive& archive);

    /// Call when the flow has changed abruptly: integrators with a memory start afresh. O(interface
    /// vertices) for those, O(1) for all others.
    void forget();

    /// The vertices of the interface, roughly in the order of the curve. O(their number).
    [[nodiscard]] std::vector<std::uint32_t> interface() const;
    /// The number of interface vertices. O(submeshes); as costly as `interface` if phases are
    /// advected.
    [[nodiscard]] std::size_t interface_size() const;

private:
    void transfer(Archive& archive);
    StepReport step_along(const Flow<Real>& flow, Real time, Real dt);
    bool sub_step(const Flow<Real>& flow, Real& time, Real end, Real& remaining,
                  StepReport& report);
    [[nodiscard]] Real pieces_of_speed(Real remaining, Real fastest) const;
    [[nodiscard]] Real pieces_of(Real remaining, Real fastest) const;
    Real shorten(const Flow<Real>& flow, Real time, Real dt, Reach<Real>& reach);
    bool is_at_a_jump(const Flow<Real>& flow, Real time, Real dt,
                      const TargetReport<Real>& targets);

    enum class By : std::uint8_t { application, stage };
    void absorb(By by, Real time);
    void begin_options(const Options<Real>& before);
    void expect_between_steps(const char* where) const;
    std::uint64_t run_stages(Real time, Real dt, std::uint64_t unreached, std::uint64_t missed);
    bool run_each_stage(Real time, Real dt, std::uint64_t unreached, bool is_again);
    [[nodiscard]] std::vector<std::uint32_t> moved() const;
    void begin_integrator();
    void forget_past(std::span<const std::uint32_t> vertices);
    [[nodiscard]] Options<Real> completed() const;
    void measure(Real time);
    void sweep();
    void tell(std::span<const Edit> edits);
    void tell_what_was_done();

    Complex<Real>& complex_;
    Claim claim_;
    Options<Real> options_;
    std::unique_ptr<Executor<Real>> executor_;
    Real fastest_ = 0; ///< speed of the last sub-step: the estimate for the next one
    std::vector<EditListener> listeners_;
    std::vector<std::shared_ptr<Stage<Real>>> stages_;
    std::vector<std::uint32_t> to_stages_; ///< scratch of run_stages
    std::vector<std::uint32_t> gone_;      ///< vertices whose targets are void after the stages
    std::vector<std::pair<std::uint32_t, Phase>> around_missed_; ///< before the stages
    std::uint32_t swept_ = 0;             ///< the vertex at which the slow sweep continues
    std::vector<std::uint32_t> to_sweep_; ///< scratch of sweep, and of the count of the interface
    LogReader reading_;                   ///< of the journal, while the simulation lives
    std::size_t absorbed_;                ///< records of the journal that have been read
    std::vector<Edit> absorbing_;         ///< scratch of absorb
    bool is_in_step_ = false;
    const std::atomic<bool>* interrupted_ = nullptr;
    Real max_dt_ = std::numeric_limits<Real>::infinity(); ///< by the tolerance of `adaptive`
    std::uint32_t short_ = 0; ///< sub-steps of this step that the tolerance made very short
};

} // namespace dsc
