// SPDX-License-Identifier: MIT
#include "dsc/algorithm/executor.h"

#include "dsc/algorithm/interface_sight.h"
#include "dsc/base/error.h"
#include "dsc/base/room.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/readers.h"
#include "dsc/passes/work.h"

#include <utility>

namespace dsc {

template <class Real>
Executor<Real>::Executor(Complex<Real>& complex, const Options<Real>& options,
                         Algorithm<Real> algorithm)
    : complex_(complex), options_(options), algorithm_(std::move(algorithm)),
      whole_(complex, options_), works_{&whole_},
      sight_(std::make_unique<InterfaceSight<Real>>(in_shares_)) {
    complex.ids.collect(); // lent by an earlier executor
    // Stamps of an earlier run must not be mistaken for stamps of this run.
    for (const auto& vertex : complex.vertices) {
        epoch_ = std::max(epoch_, vertex.stamp);
    }
    whole_.epoch = new_stamp();
    whole_.remeshing = algorithm_.remeshing;
    whole_.interface = collect_moved(complex, options_);
    // Reserves a few ids, so that the first splits do not copy the whole mesh to make room.
    const std::size_t room = 64 + 2 * whole_.interface.size();
    complex.reserve(complex.vertex_bound() + room, complex.triangle_bound() + 2 * room);
}

template <class Real>
Executor<Real>::~Executor() = default;

// --- between two steps -------------------------------------------------------------------------

template <class Real>
void Executor<Real>::set_options(const Options<Real>& options) {
    const bool relists = options.advected_phases != options_.advected_phases;
    options_ = options;
    is_kept_up_ = false;
    if (relists) {
        list_interface();
    }
}

template <class Real>
void Executor<Real>::list_interface() {
    for (Work<Real>* work : works_) {
        work->interface.clear();
    }
    for (const std::uint32_t v : collect_moved(complex_, options_)) {
        home_of(v).interface.push_back(v);
    }
}

template <class Real>
void Executor<Real>::add_remeshing(const Pass<Real>& pass) {
    algorithm_.remeshing.push_back(pass);
    for (Work<Real>* work : works_) {
        work->remeshing = algorithm_.remeshing;
    }
}

template <class Real>
void Executor<Real>::keep_edits(bool keep) {
    for (Work<Real>* work : works_) {
        work->log.readers = keep ? 1 : 0;
    }
}

template <class Real>
void Executor<Real>::watch_quality(double quality) {
    // The margin is larger than the rounding error of either precision.
    const double positive = std::max(quality, 0.0);
    for (Work<Real>* work : works_) {
        work->watched_quality = positive * positive * 1.01 + 1e-5;
    }
}

template <class Real>
void Executor<Real>::resize(std::span<const std::uint32_t> list) {
    append(whole_.resized, list);
}

template <class Real>
void Executor<Real>::absorb(std::span<const Edit> edits) {
    const std::span<const Edit> after = edits_after_renumbering(edits);
    if (after.size() != edits.size()) {
        for (Work<Real>* work : works_) {
            work->active.clear();
            work->resized.clear(); // all sizes are measured again
            work->deferred.clear();
        }
        clear_stamps(complex_);
        list_interface();
        whole_.poor.push_back(no_id);
    }
    is_kept_up_ = false;
    change_interface(interface_changes(after));
    wake(whole_, after);
}

// --- a step ------------------------------------------------------------------------------------

template <class Real>
std::uint32_t Executor<Real>::new_stamp() {
    return next_stamp(complex_, epoch_);
}

template <class Real>
void Executor<Real>::begin_step() {
    if (options_.shuffle_seed != 0) {
        shuffle_interface(whole_.interface, options_.shuffle_seed + steps_);
    }
    ++steps_;
}

template <class Real>
void Executor<Real>::keep_up_whole() {
    for (const auto& pass : algorithm_.remeshing) {
        run_pass(whole_, pass);
    }
    whole_.deferred.clear();
}

template <class Real>
TargetReport<Real> Executor<Real>::compute_targets(const Flow<Real>& flow, Real time, Real dt) {
    progress_ = Progress::under_way;
    // If the flow threw after remeshing, the repeated sub-step does not remesh again, because a
    // second remeshing might change more.
    if (!is_kept_up_ || whole_.time != time || whole_.dt != dt) {
        whole_.time = time;
        whole_.dt = dt;
        is_kept_up_ = false;
        keep_up_whole();
        is_kept_up_ = true;
    }
    const std::size_t end = whole_.interface.size();
    const TargetReport<Real> report =
        sight_->compute_targets(whole_, std::span(&end, 1), flow, time, dt);
    progress_ = Progress::has_targets;
    return report;
}

template <class Real>
Reach<Real> Executor<Real>::recompute_targets(const Flow<Real>& flow, Real time, Real dt) {
    return sight_->recompute_targets(flow, time, dt);
}

template <class Real>
MoveReport Executor<Real>::move() {
    const std::uint64_t held = begin_movement();
    MoveReport report = move_whole();
    report.held += held;
    report.unreached += held;
    end_movement();
    return report;
}

template <class Real>
MoveReport Executor<Real>::move_whole() {
    MoveReport report;
    report.passes = run_motion(whole_, algorithm_.motion, epoch_);
    report.unreached = give_up_moving_vertices(whole_);
    whole_.deferred.clear();
    return report;
}

template <class Real>
std::uint64_t Executor<Real>::begin_movement() {
    progress_ = Progress::under_way;
    is_kept_up_ = false;
    whole_.moving_vertices.clear();
    return collect_moving_vertices(whole_);
}

template <class Real>
void Executor<Real>::end_movement() {
    collect_edits();
    collect_changes();
    progress_ = Progress::none;
}

// The edits of the stages have been absorbed, so their stars are active.
template <class Real>
std::uint64_t Executor<Real>::move_missed(std::span<const std::uint32_t> gone) {
    progress_ = Progress::under_way;
    const std::size_t missed = whole_.moving_vertices.size();
    std::erase_if(whole_.moving_vertices, [&](const MovingVertex<Real>& moving_vertex) {
        return std::ranges::binary_search(gone, moving_vertex.vertex) ||
               !is_moved(complex_, options_, Vertex{moving_vertex.vertex});
    });
    if (!whole_.moving_vertices.empty()) {
        (void)run_motion(whole_, algorithm_.motion, epoch_);
        whole_.deferred.clear();
        // Their misses have been counted, except where a stage has cleared the count.
        for (const auto& moving_vertex : whole_.moving_vertices) {
            auto& flags = complex_.vertices[moving_vertex.vertex].flags;
            flags &= ~static_cast<std::uint32_t>(vertex_on_way);
            flags |= (flags & vertex_contact) == 0 ? std::uint32_t{vertex_missed} : 0U;
        }
    }
    const std::size_t left = whole_.moving_vertices.size();
    end_movement();
    return missed - left;
}

template <class Real>
void Executor<Real>::end_step() {
    whole_.moving_vertices.clear();
    if (progress_ == Progress::under_way && !is_kept_up_) { // a pass or its functions threw
        list_interface();
    }
    progress_ = Progress::none;
}

// --- lists and logs ----------------------------------------------------------------------------

template <class Real>
std::size_t Executor<Real>::interface_size() const {
    std::size_t size = 0;
    for (const Work<Real>* work : works_) {
        size += work->interface.size();
    }
    return size;
}

template <class Real>
void Executor<Real>::append_interface(std::vector<std::uint32_t>& list) const {
    for (const Work<Real>* work : works_) {
        append(list, work->interface);
    }
}

template <class Real>
void Executor<Real>::change_interface(std::span<const std::uint32_t> changed) {
    if (changed.empty()) {
        return;
    }
    for (Work<Real>* work : works_) {
        take_off(work->interface, changed);
    }
    for (const std::uint32_t v : changed) {
        if (is_moved(complex_, options_, Vertex{v})) {
            home_of(v).interface.push_back(v);
        }
    }
}

template <class Real>
void Executor<Real>::collect_changes() {
    std::vector<std::uint32_t>& changed = whole_.changed;
    changed.clear();
    for (Work<Real>* work : works_) {
        append(changed, work->changed_interface);
        work->changed_interface.clear();
    }
    if (changed.empty() || works_.size() == 1) { // the work has updated its own list
        return;
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    change_interface(changed);
}

template <class Real>
void Executor<Real>::collect_edits() {
    for (Work<Real>* work : works_) {
        append(poor_, work->poor);
        work->poor.clear();
    }
    if (poor_.size() > complex_.triangle_bound()) { // examining all stars costs less
        poor_.assign(1, no_id);
    }
    if (whole_.log.readers == 0) {
        return;
    }
    for (Work<Real>* work : works_) {
        if (edits_.empty()) {
            edits_.swap(work->log.records);
        } else {
            append(edits_, work->log.records);
            work->log.records.clear();
        }
    }
}

template <class Real>
std::span<const Edit> Executor<Real>::take_edits() {
    taken_.clear();
    collect_edits();
    taken_.swap(edits_);
    return taken_;
}

// Stars that are still active have been changed by a stage, by a pass of an application, or by a
// sub-step that gave up.
template <class Real>
std::span<const std::uint32_t> Executor<Real>::take_poor() {
    collect_edits();
    taken_poor_.clear();
    taken_poor_.swap(poor_);
    for (const Work<Real>* work : works_) {
        append(taken_poor_, work->active);
    }
    return taken_poor_;
}

template <class Real>
OperationCounts Executor<Real>::take_counts() {
    OperationCounts total;
    for (Work<Real>* work : works_) {
        total += std::exchange(work->log.counts, {});
    }
    return total;
}

template <class Real>
void Executor<Real>::archive(Archive& archive) {
    archive(whole_, epoch_, steps_, is_kept_up_);
    if (archive.is_reading()) { // another mesh, in which no star has been examined
        poor_.assign(1, no_id);
    }
}

template class Executor<double>;
template class Executor<float>;

} // namespace dsc
