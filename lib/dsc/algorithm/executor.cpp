// SPDX-License-Identifier: MIT
#include "dsc/algorithm/executor.h"

#include "dsc/base/error.h"
#include "dsc/passes/interface/carried.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/readers.h"
#include "dsc/passes/work_archive.h"

#include <algorithm>
#include <utility>

namespace dsc {

MoveReport& MoveReport::operator+=(const MoveReport& other) {
    passes = std::max(passes, other.passes);
    unreached += other.unreached;
    held += other.held;
    return *this;
}

template <class Real>
void clear_stamps(Complex<Real>& complex) {
    for (auto& vertex : complex.vertices) {
        vertex.stamp = 0;
    }
}

template <class Real>
std::uint32_t next_stamp(Complex<Real>& complex, std::uint32_t& last) {
    if (++last == 0) {
        clear_stamps(complex);
        last = 1;
    }
    return last;
}

template <class Real>
std::uint32_t run_motion(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                         std::uint32_t& next_epoch) {
    std::uint32_t done = 0;
    int idle = 0;
    while (static_cast<int>(done) < work.options.max_passes) {
        work.progressed = 0;
        work.arrived = 0;
        for (const auto& pass : passes) {
            run_pass(work, pass);
        }
        work.epoch = next_stamp(work.complex, next_epoch);
        ++done;
        const bool has_arrived = std::ranges::all_of(work.movers, [&](const auto& mover) {
            return is_in_contact(work.complex.vertices[mover.vertex]);
        });
        if (has_arrived) {
            break;
        }
        idle = work.progressed == 0 ? idle + 1 : 0;
        if (idle >= work.options.max_idle_passes) {
            break;
        }
    }
    return done;
}

template <class Real>
std::uint64_t give_up_movers(Work<Real>& work) {
    // One that has vanished on its way has nowhere to arrive.
    std::erase_if(work.movers, [&](const Mover<Real>& mover) {
        return !work.complex.is_alive(Vertex{mover.vertex});
    });
    for (const auto& mover : work.movers) {
        auto& flags = work.complex.vertices[mover.vertex].flags;
        flags &= ~static_cast<std::uint32_t>(vertex_on_way);
        flags += (flags & vertex_contact) == vertex_contact ? 0U : std::uint32_t{vertex_missed};
    }
    const std::uint64_t given_up = work.movers.size();
    work.missed.swap(work.movers);
    work.movers.clear();
    return given_up;
}

template <class Real>
std::uint64_t move_missed_of(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                             std::span<const std::uint32_t> gone, std::uint32_t& next_epoch) {
    const std::size_t missed = work.missed.size();
    std::erase_if(work.missed, [&](const Mover<Real>& mover) {
        return std::ranges::binary_search(gone, mover.vertex) ||
               !is_moved(work.complex, work.options, Vertex{mover.vertex});
    });
    if (work.missed.empty()) {
        return missed;
    }
    work.movers.swap(work.missed);
    (void)run_motion(work, passes, next_epoch);
    work.deferred.clear(); // alone on the complex, nothing is postponed
    // That they missed has been noted.
    for (const auto& mover : work.movers) {
        work.complex.vertices[mover.vertex].flags &= ~static_cast<std::uint32_t>(vertex_on_way);
    }
    const std::size_t left = work.movers.size();
    work.movers.clear();
    work.missed.clear();
    return missed - left;
}

template <class Real>
AimReport<Real> aim_whole(Work<Real>& work, const std::vector<Pass<Real>>& upkeep,
                          InterfaceSight<Real>& sight, const Flow<Real>& flow, Real time, Real dt) {
    work.time = time;
    work.dt = dt;
    for (const auto& pass : upkeep) {
        run_pass(work, pass);
    }
    // Alone on the complex, nothing is postponed.
    work.deferred.clear();
    if (const Velocity<Real>* velocity = flow.velocity()) {
        AimReport<Real> report = find_velocities(work, *velocity, time);
        report.reach = find_targets(work, *velocity, time, dt);
        return report;
    }
    sight.look(work);
    return sight.aim(flow, time, dt);
}

template <class Real>
Reach<Real> aim_whole_again(Work<Real>& work, InterfaceSight<Real>& sight, const Flow<Real>& flow,
                            Real time, Real dt) {
    return flow.velocity() != nullptr ? find_targets(work, *flow.velocity(), time, dt)
                                      : sight.aim_again(flow, time, dt);
}

template <class Real>
void absorb_edits(Work<Real>& work, std::span<const Edit> edits) {
    Complex<Real>& complex = work.complex;
    const std::span<const Edit> after = edits_after_renumbering(edits);
    if (after.size() != edits.size()) {
        work.active.clear();
        work.resized.clear(); // all is measured anew
        work.interface = collect_moved(complex, work.options);
        clear_stamps(complex);
        work.find_past();
    }
    const std::vector<std::uint32_t> changed = interface_changes(after);
    take_off(work.interface, changed);
    const std::vector<std::uint32_t> on = moved_among(complex, work.options, changed);
    work.interface.insert(work.interface.end(), on.begin(), on.end());
    wake(work, after);
}

void append_edits(EditLog& log, std::vector<Edit>& edits) {
    edits.insert(edits.end(), log.records.begin(), log.records.end());
    log.records.clear();
}

template <class Real>
SequentialExecutor<Real>::SequentialExecutor(Complex<Real>& complex, const Options<Real>& options,
                                             Algorithm<Real> algorithm)
    : options_(options), algorithm_(std::move(algorithm)), work_(complex, options_) {
    // Stamps of an earlier run must not be mistaken for those of this one.
    for (const auto& vertex : complex.vertices) {
        epoch_ = std::max(epoch_, vertex.stamp);
    }
    work_.epoch = next_stamp(complex, epoch_);
    work_.interface = collect_moved(complex, options);
    // The first splits should not copy the whole mesh to make room for a few ids.
    const std::size_t room = 64 + 2 * work_.interface.size();
    complex.reserve(complex.vertex_bound() + room, complex.triangle_bound() + 2 * room);
}

template <class Real>
void SequentialExecutor<Real>::set_options(const Options<Real>& options) {
    const bool relists = options.carried_phases != options_.carried_phases;
    options_ = options;
    work_.find_past();
    if (relists) {
        work_.interface = collect_moved(work_.complex, options_);
    }
}

template <class Real>
std::vector<Edit> SequentialExecutor<Real>::take_edits() {
    std::vector<Edit> edits;
    append_edits(work_.log, edits);
    return edits;
}

template <class Real>
void SequentialExecutor<Real>::begin_step() {
    if (work_.options.shuffle_seed != 0) {
        shuffle_interface(work_.interface, work_.options.shuffle_seed + steps_);
    }
    ++steps_;
    work_.changed_interface.clear(); // there is no other list that would read it
}

template <class Real>
AimReport<Real> SequentialExecutor<Real>::aim(const Flow<Real>& flow, Real time, Real dt) {
    return aim_whole(work_, algorithm_.upkeep, sight_, flow, time, dt);
}

template <class Real>
Reach<Real> SequentialExecutor<Real>::aim_again(const Flow<Real>& flow, Real time, Real dt) {
    return aim_whole_again(work_, sight_, flow, time, dt);
}

template <class Real>
MoveReport SequentialExecutor<Real>::move() {
    MoveReport report;
    work_.movers.clear();
    report.held = collect_movers(work_);
    report.passes = run_motion(work_, algorithm_.motion, epoch_);
    report.unreached = give_up_movers(work_) + report.held;
    work_.deferred.clear();
    return report;
}

template <class Real>
void SequentialExecutor<Real>::end_step() {
    work_.movers.clear();
}

template <class Real>
void SequentialExecutor<Real>::append_interface(std::vector<std::uint32_t>& list) const {
    list.insert(list.end(), work_.interface.begin(), work_.interface.end());
}

template <class Real>
OperationCounts SequentialExecutor<Real>::take_counts() {
    return std::exchange(work_.log.counts, {});
}

template <class Real>
void SequentialExecutor<Real>::archive(Archive& archive) {
    archive(work_, epoch_, steps_);
}

template <class Real>
void Executor<Real>::archive(Archive& /*archive*/) {
    throw InputError({.what = "this executor keeps no checkpoints",
                      .where = "Executor::archive",
                      .value = "an executor of the application",
                      .allowed = "one that overrides it, or one of the library"});
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::uint32_t run_motion(Work<Real>&, const std::vector<Pass<Real>>&,                 \
                                      std::uint32_t&);                                             \
    template std::uint32_t next_stamp(Complex<Real>&, std::uint32_t&);                             \
    template void clear_stamps(Complex<Real>&);                                                    \
    template std::uint64_t give_up_movers(Work<Real>&);                                            \
    template std::uint64_t move_missed_of(Work<Real>&, const std::vector<Pass<Real>>&,             \
                                          std::span<const std::uint32_t>, std::uint32_t&);         \
    template AimReport<Real> aim_whole(Work<Real>&, const std::vector<Pass<Real>>&,                \
                                       InterfaceSight<Real>&, const Flow<Real>&, Real, Real);      \
    template Reach<Real> aim_whole_again(Work<Real>&, InterfaceSight<Real>&, const Flow<Real>&,    \
                                         Real, Real);                                              \
    template void absorb_edits(Work<Real>&, std::span<const Edit>);                                \
    template void Executor<Real>::archive(Archive&);                                               \
    template class SequentialExecutor<Real>;
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
