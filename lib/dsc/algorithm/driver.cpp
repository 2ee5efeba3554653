// SPDX-License-Identifier: MIT
#include "dsc/algorithm/driver.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsc {

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
std::vector<std::uint32_t> Simulation<Real>::interface() const {
    std::vector<std::uint32_t> list;
    list.reserve(executor_->interface_size());
    executor_->append_interface(list);
    return list;
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
        executor_->end_step();
        (void)executor_->take_counts();
        throw;
    }
    executor_->end_step();
    report.operations = executor_->take_counts();
    report.interface_vertices = static_cast<std::uint32_t>(executor_->interface_size());
    return report;
}

// How many sub-steps the rest of a step takes at this speed.
template <class Real>
Real Simulation<Real>::pieces_of(Real remaining, Real fastest) const {
    const Real farthest = static_cast<Real>(options_.sub_step) * options_.edge_length;
    return std::ceil(remaining * fastest / farthest);
}

// Who asks for too many sub-steps. O(interface vertices), once.
template <class Real>
void Simulation<Real>::find_fastest(const Velocity<Real>& velocity, Real time,
                                    StepReport& report) const {
    const std::vector<std::uint32_t> list = interface();
    std::vector<Point<Real>> positions;
    for (const std::uint32_t v : list) {
        positions.push_back(complex_.position(Vertex{v}));
    }
    std::vector<Point<Real>> velocities(list.size());
    velocity(positions, time, velocities);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const double speed = velocities[i].template cast<double>().norm();
        if (std::isfinite(speed) && speed > report.speed) {
            report.speed = speed;
            report.where = Vertex{list[i]};
        }
    }
}

template <class Real>
bool Simulation<Real>::sub_step(const Velocity<Real>& velocity, Real& time, Real& remaining,
                                StepReport& report) {
    const auto dt_of = [&](Real pieces) { return pieces > 1 ? remaining / pieces : remaining; };
    // Aimed with the speed of the sub-step before, which is nearly always right: the velocities and
    // the targets are then found in one go, and submeshes need not wait for each other in between.
    Real dt = dt_of(pieces_of(remaining, fastest_));
    AimReport<Real> aim = executor_->aim(velocity, time, dt);
    fastest_ = aim.fastest;
    report.held += aim.held;
    report.unreached += aim.held;
    const Real pieces = pieces_of(remaining, aim.fastest);
    if (!(pieces + static_cast<Real>(report.sub_steps) <=
          static_cast<Real>(options_.max_sub_steps))) {
        report.gave_up = GiveUp::too_many_sub_steps;
        find_fastest(velocity, time, report);
        report.unreached += aim.vertices;
        return false;
    }
    if (dt_of(pieces) != dt) {
        dt = dt_of(pieces);
        aim.farthest = executor_->aim_again(velocity, time, dt);
    }

    // The speed may rise within the step; then the step is halved.
    constexpr int max_halvings = 6;
    constexpr Real tolerated = 2;
    const Real farthest = tolerated * static_cast<Real>(options_.sub_step) * options_.edge_length;
    for (int halving = 0; aim.farthest > farthest && halving < max_halvings; ++halving) {
        dt *= Real(0.5);
        aim.farthest = executor_->aim_again(velocity, time, dt);
    }

    const MoveReport moved = executor_->move();
    report.held += moved.held;
    report.unreached += moved.unreached;
    report.passes += moved.passes;
    ++report.sub_steps;
    time += dt;
    remaining = dt < remaining ? remaining - dt : Real(0);
    return true;
}

template class Simulation<double>;
template class Simulation<float>;

} // namespace dsc
