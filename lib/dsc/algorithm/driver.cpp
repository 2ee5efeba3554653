// SPDX-License-Identifier: MIT
#include "dsc/algorithm/driver.h"

#include "dsc/algorithm/interface_upkeep.h"
#include "dsc/base/error.h"

#include <cmath>
#include <utility>

namespace dsc {

template <class Real>
SequentialExecutor<Real>::SequentialExecutor(Complex<Real>& complex, const Options<Real>& options,
                                             Algorithm<Real> algorithm)
    : algorithm_(std::move(algorithm)), work_(complex, options) {
    // Stamps of an earlier run must not look like this one's.
    for (const auto& vertex : complex.vertices) {
        epoch_ = std::max(epoch_, vertex.stamp);
    }
    work_.epoch = ++epoch_;
    work_.interface = collect_interface(complex, options.shuffle_seed);
}

template <class Real>
void SequentialExecutor<Real>::run_upkeep() {
    for (const auto& pass : algorithm_.upkeep) {
        pass.run(work_);
    }
    // Alone on the complex, nothing is put off.
    work_.put_off_interface.clear();
}

template <class Real>
std::size_t SequentialExecutor<Real>::run_motion() {
    for (const auto& pass : algorithm_.motion) {
        pass.run(work_);
    }
    work_.put_off_active.clear();
    work_.epoch = ++epoch_;
    return work_.progressed;
}

template <class Real>
OperationCounts SequentialExecutor<Real>::take_counts() {
    return std::exchange(work_.counts, {});
}

template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options)
    : Simulation(complex, options, nullptr) {}

template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options,
                             std::unique_ptr<Executor<Real>> executor)
    : complex_(complex), options_(options), executor_(std::move(executor)) {
    check_options(options);
    if (!executor_) {
        executor_ =
            std::make_unique<SequentialExecutor<Real>>(complex, options, default_algorithm<Real>());
    }
}

template <class Real>
StepReport Simulation<Real>::step(const Velocity<Real>& velocity, Real time, Real dt) {
    if (!std::isfinite(dt) || dt < 0 || !std::isfinite(time)) {
        throw InputError("not a time step", "Simulation::step", std::to_string(dt),
                         "a finite time and a step of 0 or more");
    }
    StepReport report;
    executor_->begin_step();
    Real remaining = dt;
    try {
        while (remaining > 0 && sub_step(velocity, time, remaining, report)) {
        }
    } catch (...) {
        // The velocity, or a pass of the application: the complex is valid, only not yet there.
        executor_->movers().clear();
        executor_->end_step();
        (void)executor_->take_counts();
        throw;
    }
    executor_->end_step();
    report.operations = executor_->take_counts();
    report.interface_vertices = static_cast<std::uint32_t>(executor_->interface().size());
    return report;
}

// Velocities at the start of the sub-step; returns the largest finite speed.
template <class Real>
Real Simulation<Real>::evaluate(const Velocity<Real>& velocity, Real time, StepReport& report) {
    const auto& interface = executor_->interface();
    const std::size_t n = interface.size();
    positions_.resize(n);
    targets_.resize(n);
    first_.resize(n);
    held_.assign(n, 0);
    executor_->for_pieces(n, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            positions_[i] = complex_.position(Vertex{interface[i]});
        }
        velocity({positions_.data() + begin, end - begin}, time,
                 {first_.data() + begin, end - begin});
    });
    Real fastest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Real squared = first_[i].squaredNorm();
        if (!std::isfinite(squared)) {
            held_[i] = 1;
            first_[i].setZero();
            ++report.held;
            ++report.unreached;
        } else {
            fastest = std::max(fastest, squared);
        }
    }
    return std::sqrt(fastest);
}

template <class Real>
bool Simulation<Real>::sub_step(const Velocity<Real>& velocity, Real& time, Real& remaining,
                                StepReport& report) {
    executor_->run_upkeep();
    const Real fastest = evaluate(velocity, time, report);
    const auto& interface = executor_->interface();
    const std::size_t n = interface.size();
    const Real farthest = static_cast<Real>(options_.sub_step) * options_.edge_length;
    const Real pieces = std::ceil(remaining * fastest / farthest);
    if (!(pieces + static_cast<Real>(report.sub_steps) <=
          static_cast<Real>(options_.max_sub_steps))) {
        report.gave_up = GiveUp::too_many_sub_steps;
        report.unreached += n;
        return false;
    }
    scratch_.resize(executor_->piece_count());
    Real dt = pieces > 1 ? remaining / pieces : remaining;

    // The speed may rise within the step; then the step is halved.
    constexpr int max_halvings = 6;
    constexpr Real tolerated = 2;
    for (int halving = 0;; ++halving) {
        executor_->for_pieces(n, [&](std::size_t piece, std::size_t begin, std::size_t end) {
            IntegratorScratch<Real>& scratch = scratch_[piece];
            scratch.first.assign(first_.begin() + static_cast<std::ptrdiff_t>(begin),
                                 first_.begin() + static_cast<std::ptrdiff_t>(end));
            integrate<Real>(options_.integrator, velocity, {positions_.data() + begin, end - begin},
                            time, dt, {targets_.data() + begin, end - begin}, scratch);
        });
        Real most = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Real squared = (targets_[i] - positions_[i]).squaredNorm();
            most = std::isfinite(squared) ? std::max(most, squared) : most;
        }
        if (std::sqrt(most) <= tolerated * farthest || halving == max_halvings) {
            break;
        }
        dt *= Real(0.5);
    }

    auto& movers = executor_->movers();
    movers.clear();
    for (std::size_t i = 0; i < n; ++i) {
        const Point<Real>& target = targets_[i];
        if (held_[i] != 0 || complex_.is_locked(Vertex{interface[i]})) {
            continue;
        }
        if (!std::isfinite(target.x()) || !std::isfinite(target.y())) {
            ++report.held;
            ++report.unreached;
        } else if (target != positions_[i]) {
            movers.push_back({interface[i], target.x(), target.y()});
        }
    }
    move_all(report);
    ++report.sub_steps;
    time += dt;
    remaining = dt < remaining ? remaining - dt : Real(0);
    return true;
}

template <class Real>
void Simulation<Real>::move_all(StepReport& report) {
    int idle = 0;
    for (int pass = 0; pass < options_.max_passes; ++pass) {
        const std::size_t progressed = executor_->run_motion();
        ++report.passes;
        if (executor_->movers().empty()) {
            return;
        }
        idle = progressed == 0 ? idle + 1 : 0;
        if (idle >= options_.max_idle_passes) {
            break;
        }
    }
    report.unreached += executor_->movers().size();
    executor_->movers().clear();
}

template class SequentialExecutor<double>;
template class SequentialExecutor<float>;
template class Simulation<double>;
template class Simulation<float>;

} // namespace dsc
