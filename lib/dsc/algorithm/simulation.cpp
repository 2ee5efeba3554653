// SPDX-License-Identifier: MIT
#include "dsc/algorithm/simulation.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/error.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/mesh/size_update.h"
#include "dsc/passes/readers.h"
#include "dsc/sizes/sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

namespace dsc {

namespace {

// O(vertices).
template <class Real>
void check_for(const Complex<Real>& complex, const Options<Real>& options) {
    check_options(options);
    const auto extent = static_cast<double>(extent_of(complex));
    require(complex.vertex_count() == 0 || static_cast<double>(options.edge_length) <= extent,
            "edge_length", static_cast<double>(options.edge_length),
            "up to " + to_text(extent) + ", the larger side of the mesh");
}

} // namespace

template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options)
    : Simulation(complex, options, nullptr) {}

template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options,
                             std::unique_ptr<Executor<Real>> executor)
    : complex_(complex), claim_(complex.in_use), options_(options), executor_(std::move(executor)),
      reading_(complex.journal), absorbed_(complex.journal.records.size()) {
    check_for(complex, options);
    begin_integrator();
    if (executor_) {
        if (&executor_->complex() != &complex) {
            throw InputError({.what = "the executor belongs to another complex",
                              .where = "Simulation",
                              .value = "an executor made for another complex",
                              .allowed = "one made by make_executor for this complex"});
        }
        executor_->set_options(completed());
        // Edits of the application since the executor was made are in no journal.
        executor_->absorb(std::array{Edit{.kind = EditKind::rebuild}});
    } else {
        executor_ =
            std::make_unique<Executor<Real>>(complex, completed(), default_algorithm<Real>());
    }
    mark_features(complex, interface(), options.interface.feature_degrees,
                  static_cast<Real>(feature_arc) *
                      finest_on_interface(options.sizes, options.edge_length));
    measure(0);
}

template <class Real>
Simulation<Real>::~Simulation() {
    for (const auto& stage : stages_) {
        stage->has_simulation_ = false;
    }
}

template <class Real>
void Simulation<Real>::set_options(const Options<Real>& options) {
    expect_between_steps("Simulation::set_options");
    check_for(complex_, options);
    for (const auto& stage : stages_) {
        stage->check(complex_, options);
    }
    const Options<Real> before = std::exchange(options_, options);
    try {
        begin_options(before);
    } catch (...) { // a function of the new options threw, or returned no length
        options_ = before;
        begin_options(options);
        throw;
    }
    if (options.integrator != before.integrator ||
        options.custom_integrator != before.custom_integrator) {
        forget();
    }
}

// Makes the integrator, executor, stages and edge lengths follow the options, which replace others.
template <class Real>
void Simulation<Real>::begin_options(const Options<Real>& before) {
    begin_integrator();
    executor_->set_options(completed());
    for (const auto& stage : stages_) {
        stage->begin(complex_, options_);
    }
    if (!before.sizes.is_uniform()) {
        executor_->resize(out_of_size(complex_, options_)); // sizes may have become uniform
    }
    measure(0);
}

// What replaces or lengthens what a step is going through is refused while it does.
template <class Real>
void Simulation<Real>::expect_between_steps(const char* where) const {
    if (is_in_step_) {
        throw InputError({.what = "a step of this simulation is running",
                          .where = where,
                          .value = "a call by its flow, a stage or a listener",
                          .allowed = "calls between two steps"});
    }
}

template <class Real>
void Simulation<Real>::begin_integrator() {
    if (options_.custom_integrator) {
        options_.custom_integrator->begin(complex_);
    }
}

// Without `sizes.longest`, the extent of the mesh is the bound: in a mesh without an interface,
// targets would grow for ever.
template <class Real>
Options<Real> Simulation<Real>::completed() const {
    Options<Real> options = options_;
    if (!options.sizes.is_uniform() && options.sizes.longest == 0) {
        options.sizes.longest = std::max(extent_of(complex_), options.edge_length);
    }
    return options;
}

// Measures the targets of all edges, unless sizes are uniform. O(mesh).
template <class Real>
void Simulation<Real>::measure(Real time) {
    if (!options_.sizes.is_uniform()) {
        measure_sizes(complex_, completed().sizes, options_.edge_length, time);
        executor_->resize(out_of_size(complex_, options_));
    }
}

// Visits all vertices in turn, a few in each step. Flips and smoothing nearby may change the target
// of a vertex that no pass visits; without the sweep, a single stale target would limit all those
// around it. Most vertices of a graded mesh are near the interface and visited anyway.
template <class Real>
void Simulation<Real>::sweep() {
    constexpr std::uint32_t steps = 32; // for the whole mesh
    const std::uint32_t bound = complex_.vertex_bound();
    to_sweep_.clear();
    for (std::uint32_t i = 0; i < bound / steps + 1; ++i, ++swept_) {
        swept_ = swept_ < bound ? swept_ : 0;
        if (complex_.is_alive(Vertex{swept_})) {
            to_sweep_.push_back(swept_);
        }
    }
    executor_->resize(to_sweep_);
}

template <class Real>
void Simulation<Real>::add_listener(EditListener listener) {
    expect_between_steps("Simulation::add_listener");
    listeners_.push_back(std::move(listener));
    executor_->keep_edits(true);
}

template <class Real>
void Simulation<Real>::add_stage(std::shared_ptr<Stage<Real>> stage) {
    expect_between_steps("Simulation::add_stage");
    if (stage == nullptr) {
        throw InputError({.what = "null stage",
                          .where = "Simulation::add_stage",
                          .value = "null",
                          .allowed = "an object of a class derived from Stage"});
    }
    if (stage->has_simulation_) {
        throw InputError({.what = "this stage already belongs to a simulation",
                          .where = "Simulation::add_stage",
                          .value = "a stage added before",
                          .allowed = "a separate stage for each simulation"});
    }
    stage->check(complex_, options_);
    stage->begin(complex_, options_);
    if (const auto pass = stage->pass()) {
        executor_->add_remeshing(*pass);
    }
    stages_.push_back(std::move(stage));
    stages_.back()->has_simulation_ = true;
}

// All listeners, also those after one that throws: a log of edits may have no gaps.
template <class Real>
void Simulation<Real>::tell(std::span<const Edit> edits) {
    if (edits.empty()) {
        return;
    }
    std::exception_ptr thrown;
    for (const EditListener& listener : listeners_) {
        try {
            listener(edits);
        } catch (...) {
            thrown = thrown ? thrown : std::current_exception();
        }
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

template <class Real>
void Simulation<Real>::tell_what_was_done() {
    if (!listeners_.empty()) {
        tell(executor_->take_edits());
    }
}

// Absorbs the edits of the application since the last step, or of the stage that has just run.
// O(edits).
template <class Real>
void Simulation<Real>::absorb(By by, Real time) {
    EditLog& journal = complex_.journal;
    if (absorbed_ == journal.records.size()) {
        return;
    }
    // A copy: listeners and stages may edit the complex, for the next call.
    const std::size_t seen = journal.records.size();
    const auto first = journal.records.begin();
    absorbing_.assign(first + static_cast<std::ptrdiff_t>(absorbed_), journal.records.end());
    const std::span<const Edit> edits(absorbing_);
    executor_->absorb(edits);
    const auto after = edits_after_renumbering(edits);
    if (after.size() != edits.size()) { // attributes may be others
        begin_integrator();
        for (const auto& stage : stages_) {
            stage->begin(complex_, options_);
        }
        measure(time);
    }
    // A sharp turn in a new interface edge of the application is a feature from now on. The sharp
    // turn at the end of a seam, which a stage makes, is not.
    if (by == By::application) {
        mark_features(complex_, on_interface(complex_, interface_changes(after)),
                      options_.interface.feature_degrees,
                      static_cast<Real>(feature_arc) *
                          finest_on_interface(options_.sizes, options_.edge_length));
    }
    // A vertex that lies between other phases now moves differently: an integrator must forget its
    // past.
    if (options_.custom_integrator) {
        forget_past(interface_changes(after));
    }
    for (const Edit& edit : after) {
        if (edit.kind == EditKind::move && complex_.is_alive(edit.vertex)) {
            // Its missed targets no longer count, either.
            complex_.vertices[edit.vertex.id].flags &= ~static_cast<std::uint32_t>(vertex_contact);
            forget_past(std::span(&edit.vertex.id, 1));
        }
    }
    absorbed_ = seen;
    if (journal.readers == 1) {
        journal.records.erase(journal.records.begin(),
                              journal.records.begin() + static_cast<std::ptrdiff_t>(seen));
        absorbed_ = 0;
    }
    tell(edits); // last, because a listener may throw: nothing is absorbed or told twice
}

// After each sub-step, serially. Where stages have edited the complex, vertices that did not arrive
// try again. Returns how many of these have now arrived, or need not move any more.
template <class Real>
std::uint64_t Simulation<Real>::run_stages(Real time, Real dt, std::uint64_t unreached,
                                           bool has_missed) {
    bool has_edited = false;
    gone_.clear();
    tell_what_was_done(); // edits of the sub-step come first
    for (const auto& stage : stages_) {
        to_stages_.clear();
        executor_->append_interface(to_stages_);
        stage->run({.complex = complex_,
                    .interface = to_stages_,
                    .edge_length = options_.edge_length,
                    .time = time,
                    .dt = dt,
                    .unreached = unreached,
                    .in_shares = executor_->in_shares()});
        const std::span<const Edit> edits(complex_.journal.records);
        if (absorbed_ < edits.size()) {
            has_edited = true;
            const auto gone = taken_off(complex_, edits.subspan(absorbed_));
            gone_.insert(gone_.end(), gone.begin(), gone.end());
            absorb(By::stage, time);
        }
        stage->tell();
        complex_.attributes.failure.rethrow();
    }
    if (!has_edited || !has_missed) {
        return 0;
    }
    std::ranges::sort(gone_);
    const std::uint64_t arrived = executor_->move_missed(gone_);
    complex_.attributes.failure.rethrow();
    return arrived;
}

template <class Real>
void Simulation<Real>::forget_past(std::span<const std::uint32_t> vertices) {
    if (options_.custom_integrator) {
        options_.custom_integrator->forget(complex_, vertices);
    }
}

template <class Real>
std::vector<std::uint32_t> Simulation<Real>::interface() const {
    return options_.advected_phases.empty() ? moved() : on_interface(complex_, moved());
}

template <class Real>
std::size_t Simulation<Real>::interface_size() const {
    return options_.advected_phases.empty() ? executor_->interface_size() : interface().size();
}

template <class Real>
void Simulation<Real>::watch_quality(double quality) {
    executor_->watch_quality(quality);
}

template <class Real>
std::span<const std::uint32_t> Simulation<Real>::take_poor() {
    return executor_->take_poor();
}

// The vertices that the flow moves.
template <class Real>
std::vector<std::uint32_t> Simulation<Real>::moved() const {
    std::vector<std::uint32_t> list;
    list.reserve(executor_->interface_size());
    executor_->append_interface(list);
    return list;
}

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
    // dt from the speed of the last sub-step, which is nearly always right: one call then finds
    // velocities and targets, and submeshes need not wait for each other in between.
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
        const std::uint64_t freed = run_stages(time, dt, targets.held + moved.unreached, left > 0);
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
    const auto factor = [&](Real most) {
        return std::clamp(Real(0.9) * std::sqrt(std::sqrt(tolerance / reach.error)), Real(0.1),
                          most);
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

// Where the velocity jumps, the estimate falls in proportion to dt, not with a higher power of it:
// vertices that cross the jump would move by a few tolerances per sub-step. Since a flow may be
// rough for a moment only, the step goes on for a while.
template <class Real>
bool Simulation<Real>::is_at_a_jump(const Flow<Real>& flow, Real time, Real dt,
                                    const TargetReport<Real>& targets) {
    constexpr Real share = Real(1) / 64; // of the way that the speed allows
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

template <class Real>
void Simulation<Real>::forget() {
    max_dt_ = std::numeric_limits<Real>::infinity();
    if (options_.custom_integrator) {
        forget_past(moved());
    }
}

template <class Real>
void Simulation<Real>::archive(Archive& archive) {
    expect_between_steps("Simulation::archive");
    as_a_whole(archive, [this](Archive& each) { transfer(each); });
}

template <class Real>
void Simulation<Real>::transfer(Archive& archive) {
    archive(complex_, fastest_, max_dt_, swept_);
    std::uint64_t absorbed = absorbed_;
    archive(absorbed);
    archive.expect(absorbed <= complex_.journal.records.size(),
                   "more edits read than the journal holds");
    absorbed_ = static_cast<std::size_t>(absorbed);
    executor_->archive(archive);
    for (const auto& stage : stages_) {
        stage->archive(archive);
    }
}

template class Simulation<double>;
template class Simulation<float>;

} // namespace dsc
