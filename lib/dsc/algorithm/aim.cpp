// SPDX-License-Identifier: MIT
#include "dsc/algorithm/executor.h"

#include "dsc/base/room.h"

#include <cmath>

namespace dsc {

namespace {

template <class Real>
IntegratorStep<Real> step_of(Work<Real>& work) {
    Aim<Real>& aim = work.aim;
    return {work.complex, work.interface, aim.positions, aim.targets, aim.held, aim.dt};
}

// The number of the star that upkeep has kept of the next vertex in the list of the interface, if
// it is still what it was.
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
AimReport<Real>& AimReport<Real>::operator+=(const AimReport& other) {
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
void begin_aim(Work<Real>& work) {
    Aim<Real>& aim = work.aim;
    const std::size_t n = work.interface.size();
    aim.positions.resize(n);
    aim.targets.resize(n);
    aim.scratch.first.resize(n);
    have_room(aim.held, n);
    aim.held.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        aim.positions[i] = work.complex.position(Vertex{work.interface[i]});
    }
}

namespace {

// The velocities of the interface at `time`, in `work.aim`.
template <class Real>
AimReport<Real> find_velocities(Work<Real>& work, const Velocity<Real>& velocity, Real time) {
    Aim<Real>& aim = work.aim;
    const std::size_t n = work.interface.size();
    begin_aim(work);
    AimReport<Real> report;
    report.vertices = n;
    if (n == 0) {
        return report;
    }
    velocity(aim.positions, time, aim.scratch.first);
    Real fastest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Real squared = aim.scratch.first[i].squaredNorm();
        if (!std::isfinite(squared)) {
            aim.held[i] = 1;
            aim.scratch.first[i].setZero();
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
    Aim<Real>& aim = work.aim;
    if (work.interface.empty()) {
        return {};
    }
    aim.dt = dt;
    aim.scratch.worst = 0;
    Reach<Real> reach;
    if (const auto& custom = work.options.custom_integrator) {
        reach.error = custom->integrate(step_of(work), velocity, time, aim.scratch);
    } else {
        reach.error = integrate<Real>(work.options.integrator, velocity, aim.positions, time, dt,
                                      aim.targets, aim.scratch);
    }
    reach.where = Vertex{work.interface[aim.scratch.worst]};
    Real farthest = 0;
    for (std::size_t i = 0; i < aim.targets.size(); ++i) {
        const Real squared = (aim.targets[i] - aim.positions[i]).squaredNorm();
        farthest = std::isfinite(squared) ? std::max(farthest, squared) : farthest;
    }
    reach.farthest = std::sqrt(farthest);
    return reach;
}

template <class Real>
AimReport<Real> aim_along(Work<Real>& work, const Velocity<Real>& velocity, Real time, Real dt) {
    AimReport<Real> report = find_velocities(work, velocity, time);
    report.reach = find_targets(work, velocity, time, dt);
    return report;
}

template <class Real>
std::uint64_t collect_movers(Work<Real>& work) {
    const Aim<Real>& aim = work.aim;
    if (work.options.custom_integrator && !work.interface.empty()) {
        work.options.custom_integrator->accept(step_of(work));
    }
    std::uint64_t held = 0;
    std::uint32_t next_star = 0;
    for (std::size_t i = 0; i < work.interface.size(); ++i) {
        const std::uint32_t v = work.interface[i];
        const std::uint32_t star = star_of(work, v, next_star);
        const Point<Real>& target = aim.targets[i];
        if (aim.held[i] != 0 || work.complex.is_locked(Vertex{v})) {
            continue;
        }
        if (!std::isfinite(target.x()) || !std::isfinite(target.y())) {
            ++held;
        } else if (target != aim.positions[i]) {
            work.movers.push_back({v, target.x(), target.y(), star});
        }
    }
    return held;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template struct AimReport<Real>;                                                               \
    template void begin_aim(Work<Real>&);                                                          \
    template Reach<Real> find_targets(Work<Real>&, const Velocity<Real>&, Real, Real);             \
    template AimReport<Real> aim_along(Work<Real>&, const Velocity<Real>&, Real, Real);            \
    template std::uint64_t collect_movers(Work<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
