// SPDX-License-Identifier: MIT
#include "dsc/algorithm/interface_sight.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/room.h"
#include "dsc/base/types.h"
#include "dsc/complex/circulate.h"
#include "dsc/motion/time_ahead.h"
#include "dsc/passes/work.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

/// The way of a vertex that is ahead depends on where the flow sees it: after so many rounds that
/// place hardly changes any more.
constexpr int rounds_of_leads = 3;

/// Whether `one`, rather than `other`, is on the left of a curve between these two phases.
constexpr bool is_left(Phase one, Phase other) {
    return other == border_phase || (one != border_phase && one > other);
}

/// The flags of a view that come from the vertex record.
constexpr std::uint8_t own_flags(std::uint32_t record) {
    const unsigned corner = (record & vertex_feature) != 0 ? unsigned{interface_feature} : 0U;
    const unsigned locked = (record & vertex_locked) != 0 ? unsigned{interface_locked} : 0U;
    return static_cast<std::uint8_t>(corner | locked);
}

} // namespace

template <class Real>
void InterfaceGraph<Real>::resize(std::size_t vertices, std::size_t ranges) {
    vertices_.resize(vertices);
    previous_.resize(vertices);
    next_.resize(vertices);
    left_.resize(vertices);
    right_.resize(vertices);
    flags_.resize(vertices);
    found_.resize(ranges);
}

template <class Real>
void InterfaceGraph<Real>::number(Complex<Real>& complex, std::span<const std::uint32_t> list,
                                  std::size_t begin) {
    for (std::size_t k = 0; k < list.size(); ++k) {
        vertices_[begin + k] = Vertex{list[k]};
        complex.vertices[list[k]].slot = static_cast<std::uint32_t>(begin + k);
    }
}

template <class Real>
void InterfaceGraph<Real>::connect(const Complex<Real>& complex, std::size_t range,
                                   std::size_t begin, std::size_t end,
                                   std::span<const CachedStar> stars) {
    Junctions& found = found_[range];
    found.indices.clear();
    found.begin.clear();
    found.arms.clear();
    const auto number_of = [&](const CachedStar& star) {
        return complex.vertices[star.vertex].slot;
    };
    auto star = std::ranges::lower_bound(stars, begin, {}, number_of);
    for (std::size_t i = begin; i < end; ++i) {
        const bool has_star = star != stars.end() && star->vertex == vertices_[i].id;
        if (!has_star || !connect_cached(complex, i, *star)) {
            connect_one(complex, i, found);
        }
        star += has_star ? 1 : 0;
    }
}

template <class Real>
bool InterfaceGraph<Real>::has_number(const Complex<Real>& complex, std::uint32_t v) const {
    const std::uint32_t slot = complex.vertices[v].slot;
    return slot < vertices_.size() && vertices_[slot] == Vertex{v};
}

// Connects an ordinary vertex of a curve by its cached star, without a walk. Returns false if the
// vertex is not ordinary, or the star has changed.
template <class Real>
bool InterfaceGraph<Real>::connect_cached(const Complex<Real>& complex, std::size_t i,
                                          const CachedStar& star) {
    const std::uint32_t first = star.link[star.incident.first];
    const std::uint32_t second = star.link[star.incident.second];
    if (star.incident.count != 2 || !star.is_unchanged(complex) || !has_number(complex, first) ||
        !has_number(complex, second)) {
        return false;
    }
    const bool first_is_next = is_left(star.left, star.right);
    next_[i] = complex.vertices[first_is_next ? first : second].slot;
    previous_[i] = complex.vertices[first_is_next ? second : first].slot;
    left_[i] = first_is_next ? star.left : star.right;
    right_[i] = first_is_next ? star.right : star.left;
    flags_[i] = own_flags(complex.vertices[star.vertex].flags);
    return true;
}

// Collects the arms of a vertex at the end of its range's list; they stay there if the vertex is a
// junction.
template <class Real>
void InterfaceGraph<Real>::connect_one(const Complex<Real>& complex, std::size_t i,
                                       Junctions& found) {
    const Vertex vertex = vertices_[i];
    auto& arms = found.arms;
    const std::size_t first = arms.size();
    std::size_t incident = 0;
    const auto add = [&](std::uint32_t to, Phase left, Phase right) {
        ++incident;
        if (has_number(complex, to)) {
            arms.push_back({complex.vertices[to].slot, left, right});
        }
    };
    bool is_on_boundary = false;
    for_each_corner(complex, vertex, [&](Corner c) {
        const Phase after = complex.phase_at(c);
        const Phase before = complex.phase_at(complex.twin(prev(c)));
        if (is_interface_pair(after, before)) {
            add(complex.vertex(next(c)), after, before);
        }
        // The last incident edge of an open star.
        if (is_border(complex.twin(next(c)))) {
            is_on_boundary = true;
            if (is_interface_pair(after, border_phase)) {
                add(complex.vertex(prev(c)), border_phase, after);
            }
        }
    });
    unsigned flags = own_flags(complex.vertices[vertex.id].flags);
    flags |= is_on_boundary ? unsigned{interface_boundary} : 0U;
    if (incident == 2 && arms.size() - first == 2 && arms[first].left == arms[first + 1].right &&
        arms[first].right == arms[first + 1].left) {
        const bool first_is_next = is_left(arms[first].left, arms[first].right);
        const InterfaceArm& ahead = arms[first_is_next ? first : first + 1];
        previous_[i] = arms[first_is_next ? first + 1 : first].neighbour;
        next_[i] = ahead.neighbour;
        left_[i] = ahead.left;
        right_[i] = ahead.right;
        arms.resize(first);
    } else {
        previous_[i] = no_id;
        next_[i] = no_id;
        left_[i] = border_phase;
        right_[i] = border_phase;
        flags |= interface_junction;
        found.indices.push_back(static_cast<std::uint32_t>(i));
        found.begin.push_back(static_cast<std::uint32_t>(first));
    }
    flags_[i] = static_cast<std::uint8_t>(flags);
}

template <class Real>
void InterfaceGraph<Real>::join() {
    junctions_.indices.clear();
    junctions_.begin.clear();
    junctions_.arms.clear();
    for (const Junctions& found : found_) {
        const auto before = static_cast<std::uint32_t>(junctions_.arms.size());
        for (std::size_t k = 0; k < found.indices.size(); ++k) {
            junctions_.indices.push_back(found.indices[k]);
            junctions_.begin.push_back(before + found.begin[k]);
        }
        append(junctions_.arms, found.arms);
    }
    junctions_.begin.push_back(static_cast<std::uint32_t>(junctions_.arms.size()));
}

template <class Real>
InterfaceView<Real> InterfaceGraph<Real>::view(const Complex<Real>& complex,
                                               std::span<const Point<Real>> positions,
                                               const InShares& in_shares) const {
    return {.complex = complex,
            .vertices = vertices_,
            .positions = positions,
            .previous = previous_,
            .next = next_,
            .left = left_,
            .right = right_,
            .flags = flags_,
            .junctions = junctions_.indices,
            .arm_begin = junctions_.begin,
            .arms = junctions_.arms,
            .in_shares = in_shares};
}

template <class Real>
void InterfaceSight<Real>::look(std::span<const std::size_t> ends) {
    Work<Real>& work = *work_;
    ends_.assign(ends.begin(), ends.end());
    graph_.resize(work.interface.size(), ends.size());
    const std::span<const std::uint32_t> list = work.interface;
    const auto number = [&](std::size_t range) {
        const std::size_t begin = begin_of(range);
        graph_.number(work.complex, list.subspan(begin, ends_[range] - begin), begin);
    };
    const auto connect = [&](std::size_t range) {
        graph_.connect(work.complex, range, begin_of(range), ends_[range], work.stars);
    };
    in_shares_(ends_.size(), std::cref(number)); // by reference: no allocation
    in_shares_(ends_.size(), std::cref(connect));
    graph_.join();
}

template <class Real>
Velocity<Real> InterfaceSight<Real>::velocity(const InterfaceFlow<Real>& flow) {
    flow_ = &flow;
    return [this](std::span<const Point<Real>> positions, Real time,
                  std::span<Point<Real>> velocities) { evaluate(positions, time, velocities); };
}

template <class Real>
bool InterfaceSight<Real>::stays(std::size_t i) const {
    return work_->trajectory.held[i] != 0 || work_->complex.is_locked(Vertex{work_->interface[i]});
}

template <class Real>
void InterfaceSight<Real>::find_leads(const InterfaceFlow<Real>& flow, Real time) {
    Work<Real>& work = *work_;
    leads_.clear();
    const VertexAttribute<TimeAhead<Real>>* const ahead = find_times_ahead(work.complex);
    if (ahead == nullptr) {
        return;
    }
    for (std::size_t i = 0; i < work.interface.size(); ++i) {
        const Vertex v{work.interface[i]};
        if ((*ahead)[v].time != 0 && !work.complex.is_locked(v)) {
            leads_.push_back({.i = i, .time = (*ahead)[v].time});
        }
    }
    if (leads_.empty()) {
        return;
    }
    begin_targets(work);
    stage_ = work.trajectory.positions;
    std::vector<Point<Real>>& velocities = work.trajectory.scratch.first;
    const InterfaceView<Real> view = graph_.view(work.complex, stage_, in_shares_);
    for (int round = 0; round < rounds_of_leads; ++round) {
        for (const Lead& lead : leads_) {
            velocities[lead.i].setZero();
            flow(view, lead.i, lead.i + 1, time, velocities);
        }
        for (Lead& lead : leads_) {
            const Point<Real> way = lead.time * velocities[lead.i];
            if (way.allFinite()) {
                lead.way = way;
                stage_[lead.i] = work.trajectory.positions[lead.i] - way;
            }
        }
    }
}

template <class Real>
void InterfaceSight<Real>::evaluate(std::span<const Point<Real>> positions, Real time,
                                    std::span<Point<Real>> velocities) {
    stage_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const bool is_seen_moved = !stays(i) && positions[i].allFinite();
        stage_[i] = is_seen_moved ? positions[i] : work_->trajectory.positions[i];
    }
    for (const Lead& lead : leads_) {
        if (!stays(lead.i)) {
            stage_[lead.i] -= lead.way;
        }
    }
    std::ranges::fill(velocities, Point<Real>(0, 0));
    const InterfaceView<Real> view = graph_.view(work_->complex, stage_, in_shares_);
    const auto ask = [&](std::size_t range) {
        if (begin_of(range) < ends_[range]) {
            (*flow_)(view, begin_of(range), ends_[range], time, velocities);
        }
    };
    in_shares_(ends_.size(), std::cref(ask));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (stays(i)) {
            velocities[i].setZero();
        }
    }
}

template <class Real>
TargetReport<Real>
InterfaceSight<Real>::compute_targets(Work<Real>& work, std::span<const std::size_t> ends,
                                      const Flow<Real>& flow, Real time, Real dt) {
    work_ = &work;
    if (flow.velocity() != nullptr) {
        return targets_along(work, *flow.velocity(), time, dt);
    }
    look(ends);
    if (flow.motion() == nullptr) {
        find_leads(*flow.seeing(), time);
        return targets_along(work, velocity(*flow.seeing()), time, dt);
    }
    TargetReport<Real> report;
    Trajectory<Real>& trajectory = work_->trajectory;
    const std::vector<std::uint32_t>& list = work_->interface;
    begin_targets(*work_);
    report.vertices = list.size();
    report.reach = displace(*flow.motion(), time, dt);
    Real farthest = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!trajectory.targets[i].allFinite()) {
            trajectory.held[i] = 1;
            trajectory.targets[i] = trajectory.positions[i];
            ++report.held;
        } else if (const Real way = (trajectory.targets[i] - trajectory.positions[i]).norm();
                   way > farthest) {
            farthest = way;
            report.where = Vertex{list[i]};
        }
    }
    report.fastest = report.reach.farthest / dt;
    return report;
}

template <class Real>
Reach<Real> InterfaceSight<Real>::recompute_targets(const Flow<Real>& flow, Real time, Real dt) {
    if (flow.velocity() != nullptr) {
        return find_targets(*work_, *flow.velocity(), time, dt);
    }
    return flow.motion() == nullptr ? find_targets(*work_, velocity(*flow.seeing()), time, dt)
                                    : displace(*flow.motion(), time, dt);
}

template <class Real>
Reach<Real> InterfaceSight<Real>::displace(const InterfaceMotion<Real>& motion, Real time,
                                           Real dt) {
    Trajectory<Real>& trajectory = work_->trajectory;
    trajectory.dt = dt;
    std::vector<Point<Real>>& displacements = trajectory.scratch.first;
    std::ranges::fill(displacements, Point<Real>(0, 0));
    if (!displacements.empty()) {
        motion(graph_.view(work_->complex, trajectory.positions, in_shares_), time, dt,
               displacements);
    }
    Real farthest = 0;
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        trajectory.targets[i] = trajectory.positions[i];
        if (!stays(i)) {
            trajectory.targets[i] += displacements[i];
            const Real squared = displacements[i].squaredNorm();
            farthest = std::isfinite(squared) ? std::max(farthest, squared) : farthest;
        }
    }
    return {.farthest = std::sqrt(farthest)};
}

template class InterfaceGraph<double>;
template class InterfaceGraph<float>;
template class InterfaceSight<double>;
template class InterfaceSight<float>;

} // namespace dsc
