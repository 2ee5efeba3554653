// SPDX-License-Identifier: MIT
// A step: the tasks of the submeshes, their deferred work, and the serial work at the end.
#include "dsc/algorithm/executor.h"
#include "dsc/base/room.h"
#include "dsc/base/timer.h"
#include "dsc/parallel/in_place/submesh_part.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/readers.h"
#include "dsc/passes/work.h"

#include <algorithm>

namespace dsc {

// --- tasks -------------------------------------------------------------------------------------

// Routes the work deferred since the last call.
template <class Real>
void SubmeshExecutor<Real>::route(Part& part) {
    Work<Real>& work = part.work;
    std::size_t hint = 0;
    auto& [entries, routed] = work.deferred;
    for (; routed < entries.size(); ++routed) {
        Deferred<Real>& one = entries[routed];
        const Point<double> place = place_of(one.vertex);
        // A vertex that has left the region may be outside the submeshes that wait for this one.
        if (part.next == nullptr || !work.submesh.region.owns(one.vertex, place.x(), place.y())) {
            continue;
        }
        hint = part.next->locate(one.vertex, place.x(), place.y(), hint);
        if (hint < part.next->regions.size()) {
            one.route = static_cast<std::uint32_t>(part.next_first + hint);
        }
    }
}

// Begins a sub-step of the submesh: defers interface vertices that are no longer in its region.
template <class Real>
void SubmeshExecutor<Real>::begin_part(Part& part) {
    part.work.deferred.clear();
    part.targets_s = 0;
    const Region& region = part.work.submesh.region;
    std::erase_if(part.work.interface, [&](std::uint32_t v) {
        const Point<double> place = place_of(v);
        if (region.owns(v, place.x(), place.y())) {
            return false;
        }
        part.work.deferred.listing(v);
        return true;
    });
}

// One pass of remeshing; after the last one, velocities and targets.
template <class Real>
void SubmeshExecutor<Real>::targets_part(Part& part, std::size_t pass, const Flow<Real>& flow,
                                         Real time, Real dt) {
    Timer timer(parallel_.profile);
    Work<Real>& work = part.work;
    if (pass == 0) {
        begin_part(part);
        work.dt = dt;
    }
    if (pass < algorithm_.remeshing.size()) {
        run_pass(work, algorithm_.remeshing[pass]);
    }
    if (pass + 1 >= algorithm_.remeshing.size()) {
        if (flow.needs_all()) {
            part.targets = {};
            part.drop_targets(); // targets are found later, for the whole interface at once
        } else {
            part.targets = targets_along(work, *flow.velocity(), time, dt);
        }
    }
    part.targets_s += timer.lap();
}

// Takes over a deferred star or moving vertex; deferred remeshing and listing were done between the
// two sections.
template <class Real>
void SubmeshExecutor<Real>::accept(Work<Real>& work, const Deferred<Real>& one) {
    if (one.kind == DeferredKind::moving_vertex) {
        work.moving_vertices.push_back(one.moving_vertex());
    } else if (one.kind == DeferredKind::star && complex_.is_alive(Vertex{one.vertex})) {
        work.activate(one.vertex);
    }
}

// Takes over work deferred to this task, by a task that it waited for or between the sections.
template <class Real>
void SubmeshExecutor<Real>::accept_routed(Work<Real>& work, const DeferredQueue<Real>& queue,
                                          std::size_t task) {
    for (const Deferred<Real>& one : queue.entries) {
        if (one.route == task) {
            accept(work, one);
        }
    }
}

template <class Real>
void SubmeshExecutor<Real>::move_part(std::size_t task) {
    Timer timer(parallel_.profile);
    Part& part = *parts_[task];
    Work<Real>& work = part.work;
    const bool is_first = task < first_colour_;
    part.moved = {};
    work.moving_vertices.clear();
    if (is_first) {
        part.moved.held = collect_moving_vertices(work);
        accept_routed(work, whole_.deferred, task);
    } else {
        work.deferred.clear();
        for (const std::uint32_t earlier : moving_.tasks.predecessors(task)) {
            accept_routed(work, parts_[earlier]->work.deferred, task);
        }
    }
    std::uint32_t epoch = work.epoch;
    if (is_first || !work.moving_vertices.empty() || !work.active.empty()) {
        part.moved.passes = run_motion(work, algorithm_.motion, epoch);
    }
    // A vertex that is blocked here may find room once others have moved, unless it is in contact,
    // or the submesh is the whole mesh.
    if (!work.submesh.region.is_whole()) {
        std::erase_if(work.moving_vertices, [&](const auto& moving_vertex) {
            const bool may_find_room = !is_in_contact(complex_.vertices[moving_vertex.vertex]);
            if (may_find_room) {
                work.deferred.moving_vertex(moving_vertex);
            }
            return may_find_room;
        });
    }
    part.moved.unreached = give_up_moving_vertices(work);
    route(part);
    part.move_s = timer.lap();
}

// --- the step ----------------------------------------------------------------------------------

template <class Real>
TargetReport<Real> SubmeshExecutor<Real>::compute_targets(const Flow<Real>& flow, Real time,
                                                          Real dt) {
    if (parts_.empty()) {
        return Executor<Real>::compute_targets(flow, time, dt);
    }
    Timer timer(parallel_.profile);
    progress_ = Progress::under_way;
    whole_.time = time;
    whole_.dt = dt;
    lend_pools(); // a stage may have given the complex other ids
    std::size_t number = 0;
    for (const Colour& colour : partition_.colours) {
        const std::uint32_t epoch = next_epochs();
        for (std::size_t i = 0; i < colour.regions.size(); ++i, ++number) {
            refill(*parts_[number]);
            parts_[number]->work.epoch = epoch;
            parts_[number]->work.time = time;
        }
    }
    const double set_up = timer.lap();
    // A pass may move vertices that the next one reads across a boundary, so each has its own
    // section.
    const std::size_t sections = std::max<std::size_t>(algorithm_.remeshing.size(), 1);
    std::size_t pass = 0;
    const auto task = [&](std::size_t i) { targets_part(*parts_[i], pass, flow, time, dt); };
    for (; pass < sections; ++pass) {
        targets_schedule_.run(pool_, threads_, parallel_.assignment, std::cref(task));
    }
    const double wall = timer.lap();
    this->collect_edits();
    TargetReport<Real> report;
    for (std::size_t i = 0; i < first_colour_; ++i) {
        report += parts_[i]->targets;
    }
    report += hand_over(flow, time, dt);
    this->collect_edits();
    if (flow.needs_all()) {
        report = compute_targets_together(flow, time, dt);
    }
    if (parallel_.profile) {
        SubStepProfile& profile = profile_.emplace_back();
        profile.set_up = set_up;
        profile.targets_wall = wall;
        profile.hand_over = timer.lap();
        for (std::size_t i = 0; i < first_colour_; ++i) {
            profile.targets.push_back(parts_[i]->targets_s);
        }
    }
    progress_ = Progress::has_targets;
    return report;
}

// Handles vertices that no submesh may remesh, and those that have left their submesh; they are
// few. Vertices that are new to a submesh get their targets here as well, and are listed there when
// the sub-step is over.
template <class Real>
TargetReport<Real> SubmeshExecutor<Real>::hand_over(const Flow<Real>& flow, Real time, Real dt) {
    whole_.interface.clear();
    whole_.stars.clear();
    listed_.clear();
    for (std::size_t i = 0; i < first_colour_; ++i) {
        for (const Deferred<Real>& one : parts_[i]->work.deferred.entries) {
            if (one.kind == DeferredKind::remeshing) {
                listed_.push_back(one.vertex);
            } else if (one.kind == DeferredKind::listing &&
                       std::ranges::count(home_of(one.vertex).changed_interface, one.vertex) == 0) {
                whole_.interface.push_back(
                    one.vertex); // not yet listed in its new submesh by a pass
            }
        }
    }
    if (listed_.empty() && whole_.interface.empty()) {
        return {};
    }
    std::ranges::sort(listed_);
    listed_.erase(std::unique(listed_.begin(), listed_.end()), listed_.end());
    append(whole_.interface, listed_);
    listed_places_.clear();
    for (const std::uint32_t v : listed_) {
        listed_places_.push_back(place_of(v));
    }
    whole_.epoch = this->new_stamp();
    this->keep_up_whole();
    // Listed vertices that still exist stay listed; the others are new to a submesh. If the vertex
    // with a listed id is at another position, it is a new vertex that reuses the id. Other
    // vertices changed by a pass of an application are already listed in the whole.
    std::vector<std::uint32_t>& there = whole_.interface_next; // scratch of remeshing
    assign(there, whole_.interface);
    std::ranges::sort(there);
    std::vector<std::uint32_t>& gone = whole_.changed; // scratch of run_pass
    assign(gone, whole_.changed_interface);
    std::erase_if(gone, [this](std::uint32_t v) { return std::ranges::binary_search(listed_, v); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < listed_.size(); ++i) {
        const std::uint32_t v = listed_[i];
        if (std::ranges::binary_search(there, v) && place_of(v) == listed_places_[i]) {
            listed_[kept++] = v;
        } else {
            gone.push_back(v);
        }
    }
    listed_.resize(kept);
    std::ranges::sort(gone);
    unlist(gone);
    std::erase_if(whole_.interface,
                  [this](std::uint32_t v) { return std::ranges::binary_search(listed_, v); });
    return flow.needs_all() ? TargetReport<Real>{}
                            : targets_along(whole_, *flow.velocity(), time, dt);
}

// Removes vertices (ascending) from the lists that have them, together with their targets. O(n log
// n) in the interface vertices, unless `vertices` is empty.
template <class Real>
void SubmeshExecutor<Real>::unlist(std::span<const std::uint32_t> vertices) {
    for (std::size_t i = 0; i < first_colour_ && !vertices.empty(); ++i) {
        Work<Real>& work = parts_[i]->work;
        kept_.clear();
        for (std::size_t k = 0; k < work.interface.size(); ++k) {
            if (!std::ranges::binary_search(vertices, work.interface[k])) {
                kept_.push_back(k);
            }
        }
        const auto keep = [this](auto&... lists) {
            const auto keep_in = [this](auto& list) {
                for (std::size_t k = 0; k < kept_.size(); ++k) {
                    list[k] = list[kept_[k]];
                }
                list.resize(kept_.size());
            };
            (keep_in(lists), ...);
        };
        keep(work.interface);
        if (!work.trajectory.positions.empty()) {
            keep(work.trajectory.positions, work.trajectory.targets, work.trajectory.held,
                 work.trajectory.scratch.first);
        }
    }
}

template <class Real>
Reach<Real> SubmeshExecutor<Real>::recompute_targets(const Flow<Real>& flow, Real time, Real dt) {
    if (parts_.empty()) {
        return Executor<Real>::recompute_targets(flow, time, dt);
    }
    if (flow.needs_all()) {
        const Reach<Real> reach = this->sight_->recompute_targets(flow, time, dt);
        distribute_targets();
        return reach;
    }
    const Velocity<Real>& velocity = *flow.velocity();
    const auto task = [&](std::size_t i) {
        Part& part = *parts_[i];
        part.targets.reach = find_targets(part.work, velocity, time, dt);
    };
    targets_schedule_.run(pool_, threads_, parallel_.assignment, std::cref(task));
    Reach<Real> reach = find_targets(whole_, velocity, time, dt);
    for (std::size_t i = 0; i < first_colour_; ++i) {
        reach += parts_[i]->targets.reach;
    }
    return reach;
}

template <class Real>
MoveReport SubmeshExecutor<Real>::move() {
    if (parts_.empty()) {
        return Executor<Real>::move();
    }
    Timer timer(parallel_.profile);
    MoveReport report;
    report.held = this->begin_movement();
    route_to_owners();
    distribute_resized(); // also if sizes are uniform, because they may have become uniform just
                          // now
    const double hand_over = timer.lap();
    moving_.run(pool_, threads_, parallel_.assignment,
                [this](std::size_t task) { move_part(task); });
    const double wall = timer.lap();
    this->collect_edits();
    for (const auto& part : parts_) {
        report += part->moved;
    }
    clean_up(report);
    report.unreached += report.held;
    this->end_movement();
    if (parallel_.profile) {
        SubStepProfile& profile = profile_.back();
        profile.hand_over += hand_over;
        profile.move_wall = wall;
        profile.clean_up = timer.lap();
        for (const auto& part : parts_) {
            profile.move.push_back(part->move_s);
        }
    }
    return report;
}

// Processes serially what every colour deferred.
template <class Real>
void SubmeshExecutor<Real>::clean_up(MoveReport& report) {
    for (const Deferred<Real>& one : whole_.deferred.entries) {
        if (one.kind == DeferredKind::listing) {
            parts_[one.route]->work.interface.push_back(one.vertex);
        }
    }
    whole_.deferred.clear();
    whole_.epoch = this->new_stamp();
    const std::size_t last_colour = parts_.size() - partition_.colours.back().regions.size();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const bool is_last = i >= last_colour;
        for (const Deferred<Real>& one : parts_[i]->work.deferred.entries) {
            if (is_last || one.route == Deferred<Real>::nowhere) {
                accept(whole_, one);
            }
        }
    }
    if (!whole_.moving_vertices.empty() || !whole_.active.empty()) {
        const MoveReport rest = this->move_whole();
        report.passes = std::max(report.passes, rest.passes);
        report.unreached += rest.unreached;
    }
    // Keeps the vertices that did not arrive, because a stage may unblock them after the movement.
    for (const auto& part : parts_) {
        std::vector<MovingVertex<Real>>& missed = part->work.moving_vertices;
        append(whole_.moving_vertices, missed);
        missed.clear();
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template TargetReport<Real> SubmeshExecutor<Real>::compute_targets(const Flow<Real>&, Real,    \
                                                                       Real);                      \
    template Reach<Real> SubmeshExecutor<Real>::recompute_targets(const Flow<Real>&, Real, Real);  \
    template MoveReport SubmeshExecutor<Real>::move();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
