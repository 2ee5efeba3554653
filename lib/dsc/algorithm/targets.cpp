// SPDX-License-Identifier: MIT
#include "dsc/algorithm/sub_step.h"

#include "dsc/base/room.h"
#include "dsc/motion/time_ahead.h"
#include "dsc/passes/work.h"

#include <cmath>

namespace dsc {

namespace {

template <class Real>
IntegratorStep<Real> step_of(Work<Real>& work) {
    Trajectory<Real>& trajectory = work.trajectory;
    return {work.complex,       work.interface,  trajectory.positions,
            trajectory.targets, trajectory.held, trajectory.dt};
}

// The number of the cached star of v, the next vertex in the interface list; no_id if there is
// none, or it has changed.
template <class Real>
std::uint32_t star_of(const Work<Real>& work, std::uint32_t v, std::uint32_t& next) {
    if (next == work.stars.size() || work.stars[next].vertex != v) {
        return no_id;
    }
    const std::uint32_t star = next++;
    return work.stars[star].is_unchanged(work.complex) ? star : no_id;
}

} // namespace

template <class Real>
TargetReport<Real>& TargetReport<Real>::operator+=(const TargetReport& other) {
    if (other.fastest > fastest) {
        fastest = other.fastest;
        where = other.where;
    }
    reach += other.reach;
    held += other.held;
    vertices += other.vertices;
    return *this;
}

template <class Real>
void begin_targets(Work<Real>& work) {
    Trajectory<Real>& trajectory = work.trajectory;
    const std::size_t n = work.interface.size();
    trajectory.positions.resize(n);
    trajectory.targets.resize(n);
    trajectory.scratch.first.resize(n);
    have_room(trajectory.held, n);
    trajectory.held.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        trajectory.positions[i] = work.complex.position(Vertex{work.interface[i]});
    }
}

namespace {

// The velocities of the interface at `time`, in `work.trajectory`.
template <class Real>
TargetReport<Real> find_velocities(Work<Real>& work, const Velocity<Real>& velocity, Real time) {
    Trajectory<Real>& trajectory = work.trajectory;
    const std::size_t n = work.interface.size();
    begin_targets(work);
    TargetReport<Real> report;
    report.vertices = n;
    if (n == 0) {
        return report;
    }
    velocity(trajectory.positions, time, trajectory.scratch.first);
    Real fastest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Real squared = trajectory.scratch.first[i].squaredNorm();
        if (!std::isfinite(squared)) {
            trajectory.held[i] = 1;
            trajectory.scratch.first[i].setZero();
            ++report.held;
        } else if (squared > fastest) {
            fastest = squared;
            report.where = Vertex{work.interface[i]};
        }
    }
    report.fastest = std::sqrt(fastest);
    return report;
}

} // namespace

template <class Real>
Reach<Real> find_targets(Work<Real>& work, const Velocity<Real>& velocity, Real time, Real dt) {
    Trajectory<Real>& trajectory = work.trajectory;
    if (work.interface.empty()) {
        return {};
    }
    trajectory.dt = dt;
    trajectory.scratch.worst = 0;
    Reach<Real> reach;
    if (const auto& custom = work.options.custom_integrator) {
        reach.error = custom->integrate(step_of(work), velocity, time, trajectory.scratch);
    } else {
        reach.error = integrate<Real>(work.options.integrator, velocity, trajectory.positions, time,
                                      dt, trajectory.targets, trajectory.scratch);
    }
    reach.where = Vertex{work.interface[trajectory.scratch.worst]};
    Real farthest = 0;
    for (std::size_t i = 0; i < trajectory.targets.size(); ++i) {
        const Real squared = (trajectory.targets[i] - trajectory.positions[i]).squaredNorm();
        farthest = std::isfinite(squared) ? std::max(farthest, squared) : farthest;
    }
    reach.farthest = std::sqrt(farthest);
    return reach;
}

template <class Real>
TargetReport<Real> targets_along(Work<Real>& work, const Velocity<Real>& velocity, Real time,
                                 Real dt) {
    TargetReport<Real> report = find_velocities(work, velocity, time);
    report.reach = find_targets(work, velocity, time, dt);
    return report;
}

namespace {

// A vertex that is ahead moves for the rest of the sub-step.
template <class Real>
void wait(TimeAhead<Real>& ahead, Real dt, const Point<Real>& position, Point<Real>& target) {
    ahead.share = Real(1);
    if (ahead.time != 0) {
        ahead.share = std::max(1 - ahead.time / dt, Real(0));
        ahead.time = std::max(ahead.time - dt, Real(0));
        target = position + ahead.share * (target - position);
    }
}

} // namespace

template <class Real>
std::uint64_t collect_moving_vertices(Work<Real>& work) {
    const Trajectory<Real>& trajectory = work.trajectory;
    if (work.options.custom_integrator && !work.interface.empty()) {
        work.options.custom_integrator->accept(step_of(work));
    }
    VertexAttribute<TimeAhead<Real>>* const ahead = find_times_ahead(work.complex);
    std::uint64_t held = 0;
    std::uint32_t next_star = 0;
    for (std::size_t i = 0; i < work.interface.size(); ++i) {
        const std::uint32_t v = work.interface[i];
        const std::uint32_t star = star_of(work, v, next_star);
        Point<Real> target = trajectory.targets[i];
        if (ahead != nullptr) {
            wait((*ahead)[Vertex{v}], trajectory.dt, trajectory.positions[i], target);
        }
        if (trajectory.held[i] != 0 || work.complex.is_locked(Vertex{v})) {
            continue;
        }
        if (!std::isfinite(target.x()) || !std::isfinite(target.y())) {
            ++held;
        } else if (target != trajectory.positions[i]) {
            work.moving_vertices.push_back({v, target.x(), target.y(), star});
        }
    }
    return held;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template struct TargetReport<Real>;                                                            \
    template void begin_targets(Work<Real>&);                                                      \
    template Reach<Real> find_targets(Work<Real>&, const Velocity<Real>&, Real, Real);             \
    template TargetReport<Real> targets_along(Work<Real>&, const Velocity<Real>&, Real, Real);     \
    template std::uint64_t collect_moving_vertices(Work<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
