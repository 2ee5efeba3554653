// SPDX-License-Identifier: MIT
#include "dsc/algorithm/interface_sight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsc {

template <class Real>
void InterfaceSight<Real>::look(Work<Real>& work, std::span<const std::size_t> ends,
                                RunRanges run_ranges) {
    work_ = &work;
    ends_.assign(ends.begin(), ends.end());
    run_ranges_ = std::move(run_ranges);
    graph_.resize(work.interface.size(), ends.size());
    const std::span<const std::uint32_t> list = work.interface;
    const auto number = [&](std::size_t range) {
        const std::size_t begin = begin_of(range);
        graph_.number(work.complex, list.subspan(begin, ends_[range] - begin), begin);
    };
    const auto connect = [&](std::size_t range) {
        graph_.connect(work.complex, range, begin_of(range), ends_[range]);
    };
    run_ranges_(std::cref(number)); // by reference: no allocation
    run_ranges_(std::cref(connect));
    graph_.join();
}

template <class Real>
void InterfaceSight<Real>::look(Work<Real>& work) {
    const std::size_t end = work.interface.size();
    look(work, std::span<const std::size_t>(&end, 1), [](const auto& run) { run(0); });
}

template <class Real>
Velocity<Real> InterfaceSight<Real>::velocity(const InterfaceFlow<Real>& flow) {
    flow_ = &flow;
    return [this](std::span<const Point<Real>> positions, Real time,
                  std::span<Point<Real>> velocities) { evaluate(positions, time, velocities); };
}

template <class Real>
bool InterfaceSight<Real>::stays(std::size_t i) const {
    return work_->aim.held[i] != 0 || work_->complex.is_locked(Vertex{work_->interface[i]});
}

template <class Real>
void InterfaceSight<Real>::evaluate(std::span<const Point<Real>> positions, Real time,
                                    std::span<Point<Real>> velocities) {
    stage_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const bool is_seen_moved = !stays(i) && positions[i].allFinite();
        stage_[i] = is_seen_moved ? positions[i] : work_->aim.positions[i];
    }
    std::ranges::fill(velocities, Point<Real>(0, 0));
    const InterfaceView<Real> view = graph_.view(work_->complex, stage_);
    const auto ask = [&](std::size_t range) {
        if (begin_of(range) < ends_[range]) {
            (*flow_)(view, begin_of(range), ends_[range], time, velocities);
        }
    };
    run_ranges_(std::cref(ask));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (stays(i)) {
            velocities[i].setZero();
        }
    }
}

template <class Real>
AimReport<Real> InterfaceSight<Real>::aim(const Flow<Real>& flow, Real time, Real dt) {
    AimReport<Real> report;
    if (flow.motion() == nullptr) {
        const Velocity<Real> seen = velocity(*flow.seeing());
        report = find_velocities(*work_, seen, time);
        report.reach = find_targets(*work_, seen, time, dt);
        return report;
    }
    Aim<Real>& aim = work_->aim;
    const std::vector<std::uint32_t>& list = work_->interface;
    aim.positions.resize(list.size());
    aim.targets.resize(list.size());
    aim.scratch.first.resize(list.size());
    aim.held.assign(list.size(), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        aim.positions[i] = work_->complex.position(Vertex{list[i]});
    }
    report.vertices = list.size();
    report.reach = displace(*flow.motion(), time, dt);
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!aim.targets[i].allFinite()) {
            aim.held[i] = 1;
            aim.targets[i] = aim.positions[i];
            ++report.held;
        }
    }
    report.fastest = report.reach.farthest / dt;
    return report;
}

template <class Real>
Reach<Real> InterfaceSight<Real>::aim_again(const Flow<Real>& flow, Real time, Real dt) {
    return flow.motion() == nullptr ? find_targets(*work_, velocity(*flow.seeing()), time, dt)
                                    : displace(*flow.motion(), time, dt);
}

template <class Real>
Reach<Real> InterfaceSight<Real>::displace(const InterfaceMotion<Real>& motion, Real time,
                                           Real dt) {
    Aim<Real>& aim = work_->aim;
    aim.dt = dt;
    std::vector<Point<Real>>& displacements = aim.scratch.first;
    std::ranges::fill(displacements, Point<Real>(0, 0));
    if (!displacements.empty()) {
        motion(graph_.view(work_->complex, aim.positions), time, dt, displacements);
    }
    Real farthest = 0;
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        aim.targets[i] = aim.positions[i];
        if (!stays(i)) {
            aim.targets[i] += displacements[i];
            const Real squared = displacements[i].squaredNorm();
            farthest = std::isfinite(squared) ? std::max(farthest, squared) : farthest;
        }
    }
    return {.farthest = std::sqrt(farthest)};
}

template class InterfaceSight<double>;
template class InterfaceSight<float>;

} // namespace dsc
