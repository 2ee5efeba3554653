// SPDX-License-Identifier: MIT
// A step of a simulation: how it is cut into sub-steps, and what happens in each of them.
#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/error.h"
#include "dsc/base/room.h"
#include "dsc/complex/circulate.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/readers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsc {

namespace {

/// In one sub-step, stages run at most this many times. Nearly always, the second run is the last.
constexpr int max_rounds_of_stages = 4;

} // namespace

template <class Real>
StepReport Simulation<Real>::step_along(const Flow<Real>& flow, Real time, Real dt) {
    const Real end = time + dt;
    if (!std::isfinite(dt) || dt < 0 || !std::isfinite(end)) {
        throw InputError({.what = "not a time step",
                          .where = "Simulation::step",
                          .value = "time " + to_text(time) + ", dt " + to_text(dt),
                          .allowed = "a finite time and a step of 0 or more"});
    }
    if (dt == 0 && flow.motion() != nullptr) {
        throw InputError({.what = "dt must be positive for an InterfaceMotion",
                          .where = "Simulation::step",
                          .value = "0",
                          .allowed = "a step of more than 0: displacements are divided by it"});
    }
    if (!options_.advected_phases.empty() && flow.velocity() == nullptr) {
        throw InputError({.what = "this flow is not defined inside a phase",
                          .where = "Simulation::step",
                          .value = "advected_phases with an InterfaceFlow or InterfaceMotion",
                          .allowed = "a Velocity, or no advected_phases"});
    }
    expect_between_steps("Simulation::step");
    struct InStep {
        explicit InStep(bool& is_in_step_in) : is_in_step(is_in_step_in) { is_in_step = true; }
        ~InStep() { is_in_step = false; }
        bool& is_in_step;
    };
    const InStep in_step(is_in_step_);
    StepReport report;
    absorb(By::application, time);
    complex_.journal.counts = {}; // of the application
    if (options_.sizes.changes_in_time) {
        measure(time);
    }
    if (!options_.sizes.is_uniform()) {
        sweep();
    }
    executor_->begin_step();
    short_ = 0;
    Real remaining = dt;
    try {
        while (remaining > 0 && sub_step(flow, time, end, remaining, report)) {
            tell_what_was_done();
            if (remaining > 0 && interrupted_ != nullptr && interrupted_->load()) {
                report.gave_up = GiveUp::interrupted;
                break;
            }
        }
    } catch (...) {
        // A function of the application threw: the complex is valid, but has not arrived yet.
        executor_->end_step();
        (void)executor_->take_counts();
        tell_what_was_done(); // before what the application does next
        throw;
    }
    executor_->end_step();
    tell_what_was_done(); // a sub-step that gave up has remeshed
    report.operations = executor_->take_counts();
    report.operations += std::exchange(complex_.journal.counts, {}); // of stages
    report.reached = static_cast<double>(time);
    if (options_.advected_phases.empty()) {
        report.interface_vertices = static_cast<std::uint32_t>(executor_->interface_size());
    } else { // as `interface_size`, without allocating
        to_sweep_.clear();
        executor_->append_interface(to_sweep_);
        report.interface_vertices = static_cast<std::uint32_t>(std::ranges::count_if(
            to_sweep_, [&](std::uint32_t v) { return is_on_interface(complex_, v); }));
    }
    return report;
}

// Divides the rest of a step into equal parts, as the speed requires...
template <class Real>
Real Simulation<Real>::pieces_of_speed(Real remaining, Real fastest) const {
    const Real farthest = static_cast<Real>(options_.sub_step) * options_.edge_length;
    return std::ceil(remaining * fastest / farthest);
}

// ...and as the tolerance allows.
template <class Real>
Real Simulation<Real>::pieces_of(Real remaining, Real fastest) const {
    return std::max(pieces_of_speed(remaining, fastest), std::ceil(remaining / max_dt_));
}

std::string sentence(const StepReport& report) {
    const auto at = [](const auto& value) { return to_text(value); };
    const std::string vertex = "vertex " + at(report.where.id);
    switch (report.gave_up) {
    case GiveUp::none: break;
    case GiveUp::too_many_sub_steps:
        return "the step needs more than max_sub_steps sub-steps: " + vertex +
               " moves at a speed of " + at(report.speed);
    case GiveUp::too_many_passes:
        return at(report.unreached) +
               " vertices were still on their way after max_passes passes of a "
               "sub-step; make sub_step smaller";
    case GiveUp::velocity_jumps:
        return "the velocity jumps at " + vertex +
               ", so that no sub-step meets the tolerance; use another integrator";
    case GiveUp::interrupted: return "the step was interrupted";
    }
    return {};
}

template <class Real>
bool Simulation<Real>::sub_step(const Flow<Real>& flow, Real& time, Real end, Real& remaining,
                                StepReport& report) {
    const auto dt_of = [&](Real pieces) { return pieces > 1 ? remaining / pieces : remaining; };
    // dt is predicted from the speed of the last sub-step, which is nearly always right: one call
    // then finds velocities and targets, and submeshes need not wait for each other in between.
    Real dt = dt_of(pieces_of(remaining, fastest_));
    TargetReport<Real> targets = executor_->compute_targets(flow, time, dt);
    complex_.attributes.failure.rethrow();
    fastest_ = targets.fastest;
    report.held += targets.held;
    report.unreached += targets.held;
    const auto give_up = [&](GiveUp reason, Vertex where) {
        report.gave_up = reason;
        report.unreached += targets.vertices;
        report.where = where;
        report.speed = static_cast<double>(targets.fastest);
    };
    const Real pieces = pieces_of(remaining, targets.fastest);
    // The sub-step that the tolerance requires may change within the step.
    const Real sure = std::max(pieces_of_speed(remaining, targets.fastest), Real(1));
    if (!(sure + static_cast<Real>(report.sub_steps) <=
          static_cast<Real>(options_.max_sub_steps))) {
        give_up(GiveUp::too_many_sub_steps, targets.where);
        return false;
    }
    if (dt_of(pieces) != dt) {
        dt = dt_of(pieces);
        targets.reach = executor_->recompute_targets(flow, time, dt);
    }
    dt = shorten(flow, time, dt, targets.reach);
    if (is_at_a_jump(flow, time, dt, targets)) {
        give_up(GiveUp::velocity_jumps, targets.reach.where);
        return false;
    }
    report.error = std::max(report.error, static_cast<double>(targets.reach.error));

    const MoveReport moved = executor_->move();
    complex_.attributes.failure.rethrow();
    report.held += moved.held;
    report.unreached += moved.unreached;
    report.passes += moved.passes;
    ++report.sub_steps;
    remaining = dt < remaining ? remaining - dt : Real(0);
    time = remaining > 0 ? time + dt : end; // without the rounding of the sum
    std::uint64_t left = moved.unreached - moved.held;
    if (!stages_.empty()) {
        const std::uint64_t freed = run_stages(time, dt, targets.held + moved.unreached, left);
        report.unreached -= freed;
        left -= std::min(left, freed);
    }
    if (left > 0 && moved.passes >= static_cast<std::uint32_t>(options_.max_passes)) {
        report.gave_up = GiveUp::too_many_passes; // unreached vertices have been counted
        return false;
    }
    return true;
}

// The speed may rise within the step, and the error may be too large: then the sub-step is made
// shorter, a bounded number of times. Errors that do not decrease come from a flow that is not
// differentiable; they are reported.
template <class Real>
Real Simulation<Real>::shorten(const Flow<Real>& flow, Real time, Real dt, Reach<Real>& reach) {
    constexpr int max_halvings = 6;
    constexpr int max_trials = 12;
    constexpr Real tolerated = 2;
    const Real farthest = tolerated * static_cast<Real>(options_.sub_step) * options_.edge_length;
    const Real tolerance = static_cast<Real>(options_.tolerance) * options_.edge_length;
    // The estimate falls with the fourth power of dt.
    const auto factor = [&](Real max) {
        return std::clamp(Real(0.9) * std::sqrt(std::sqrt(tolerance / reach.error)), Real(0.1),
                          max);
    };
    for (int trial = 0; trial < max_trials && reach.error > tolerance; ++trial) {
        dt *= factor(Real(0.9));
        reach = executor_->recompute_targets(flow, time, dt);
    }
    for (int halving = 0; reach.farthest > farthest && halving < max_halvings; ++halving) {
        dt *= Real(0.5);
        reach = executor_->recompute_targets(flow, time, dt);
    }
    max_dt_ = reach.error > 0 ? dt * factor(Real(4)) : std::numeric_limits<Real>::infinity();
    return dt;
}

// At a jump of the velocity the estimate falls only in proportion to dt, so vertices that cross it
// would move by a few tolerances per sub-step. As a flow may be rough for a moment only, the step
// continues for a while before it gives up.
template <class Real>
bool Simulation<Real>::is_at_a_jump(const Flow<Real>& flow, Real time, Real dt,
                                    const TargetReport<Real>& targets) {
    constexpr Real share = Real(1) / 64; // fraction of the sub-step that the speed allows
    constexpr std::uint32_t patience = 64;
    constexpr Real of_jump = Real(0.35); // estimate of half the time: 1/2 at a jump, else up to 1/4
    const Real length = options_.edge_length;
    const bool is_short =
        targets.reach.error > static_cast<Real>(options_.tolerance) * length / 16 &&
        dt * targets.fastest < share * static_cast<Real>(options_.sub_step) * length;
    if (!is_short || ++short_ % patience != 0) {
        return false;
    }
    const Real of_half = executor_->recompute_targets(flow, time, dt / 2).error;
    (void)executor_->recompute_targets(flow, time, dt);
    return of_half > of_jump * targets.reach.error;
}

// After each sub-step, serially. If stages have edited the complex, vertices that did not arrive
// try again, and the stages run again if some are still blocked. Returns how many of these vertices
// have now arrived, or have no target any more.
template <class Real>
std::uint64_t Simulation<Real>::run_stages(Real time, Real dt, std::uint64_t unreached,
                                           std::uint64_t missed) {
    around_missed_.clear();
    for (const MovingVertex<Real>& one : executor_->missed()) {
        const auto note = [&](Corner c) {
            around_missed_.emplace_back(one.vertex, complex_.phase_at(c));
        };
        for_each_corner(complex_, Vertex{one.vertex}, note);
    }
    std::uint64_t arrived = 0;
    for (int round = 0; round < max_rounds_of_stages; ++round) {
        const bool has_edited = run_each_stage(time, dt, unreached - arrived, round > 0);
        if (!has_edited || missed == 0) {
            break;
        }
        arrived += executor_->move_missed(gone_);
        complex_.attributes.failure.rethrow();
        if (arrived == missed) {
            break;
        }
    }
    return arrived;
}

// Returns whether stages have edited the complex; `gone_` are the vertices whose targets are void.
template <class Real>
bool Simulation<Real>::run_each_stage(Real time, Real dt, std::uint64_t unreached, bool is_again) {
    bool has_edited = false;
    gone_.clear();
    tell_what_was_done(); // edits of the sub-step come first
    for (const auto& stage : stages_) {
        to_stages_.clear();
        executor_->append_interface(to_stages_);
        const Between<Real> between{.complex = complex_,
                                    .interface = to_stages_,
                                    .edge_length = options_.edge_length,
                                    .time = time,
                                    .dt = dt,
                                    .unreached = unreached,
                                    .missed = executor_->missed(),
                                    .in_shares = executor_->in_shares()};
        if (is_again) {
            stage->run_again(between);
        } else {
            stage->run(between);
        }
        const std::span<const Edit> edits(complex_.journal.records);
        if (absorbed_ < edits.size()) {
            has_edited = true;
            append(gone_, without_target(edits.subspan(absorbed_)));
            absorb(By::stage, time);
        }
        stage->tell();
        complex_.attributes.failure.rethrow();
    }
    // A vertex has a target for the phases around it: without one of these, it moves differently.
    for (const auto& [vertex, phase] : around_missed_) {
        const auto is_around = [&complex = complex_, one = phase](Corner c) {
            return complex.phase_at(c) == one;
        };
        if (complex_.is_alive(Vertex{vertex}) &&
            find_corner(complex_, Vertex{vertex}, is_around) == no_id) {
            gone_.push_back(vertex);
        }
    }
    std::ranges::sort(gone_);
    return has_edited;
}

template StepReport Simulation<double>::step_along(const Flow<double>&, double, double);
template StepReport Simulation<float>::step_along(const Flow<float>&, float, float);

} // namespace dsc
