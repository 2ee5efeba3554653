// SPDX-License-Identifier: MIT
// Edits in both directions: what the submeshes did, for listeners; and what the application did
// between two steps, for the submeshes.
#include "dsc/parallel/in_place/submesh_part.h"
#include "dsc/passes/interface/carried.h"
#include "dsc/passes/readers.h"

#include <algorithm>
#include <utility>

namespace dsc {

template <class Real>
void SubmeshExecutor<Real>::set_options(const Options<Real>& options) {
    const bool relists = options.carried_phases != options_.carried_phases;
    options_ = options;
    if (relists) {
        for (const auto& part : parts_) {
            part->work.interface.clear();
        }
        hand_out(collect_moved(complex_, options_));
    }
    find_past();
}

template <class Real>
void SubmeshExecutor<Real>::find_past() {
    whole_.find_past();
    for (const auto& part : parts_) {
        part->work.find_past();
    }
    if (joined_) {
        joined_->work.find_past();
    }
}

template <class Real>
void SubmeshExecutor<Real>::keep_edits(bool keep) {
    keeps_edits_ = keep;
    whole_.log.readers = keep ? 1 : 0;
    for (const auto& part : parts_) {
        part->work.log.readers = keep ? 1 : 0;
    }
}

// To be called between the sections of a sub-step. The submeshes of one section do not touch what
// others own, and each submesh of a later colour runs after those that it waited for, so their
// edits can be replayed submesh by submesh.
template <class Real>
void SubmeshExecutor<Real>::collect_edits() {
    if (!keeps_edits_) {
        return;
    }
    for (const auto& part : parts_) {
        append_edits(part->work.log, edits_);
    }
    append_edits(whole_.log, edits_);
}

template <class Real>
std::vector<Edit> SubmeshExecutor<Real>::take_edits() {
    collect_edits();
    return std::exchange(edits_, {});
}

// The edits of the stages have been absorbed: their stars are active.
template <class Real>
std::uint64_t SubmeshExecutor<Real>::move_missed(std::span<const std::uint32_t> gone) {
    stage_ = Stage::under_way;
    for (const auto& part : parts_) {
        const std::vector<Mover<Real>>& missed = part->work.missed;
        whole_.missed.insert(whole_.missed.end(), missed.begin(), missed.end());
    }
    std::uint32_t epoch = whole_.epoch;
    const std::uint64_t arrived = move_missed_of(whole_, algorithm_.motion, gone, epoch);
    collect_edits();
    collect_changes();
    stage_ = Stage::none;
    return arrived;
}

// Passes of an application may have changed the interface in a part listed by another submesh.
template <class Real>
void SubmeshExecutor<Real>::collect_changes() {
    std::vector<std::uint32_t>& changed = whole_.changed;
    changed.clear();
    const auto take = [&](Work<Real>& work) {
        changed.insert(changed.end(), work.changed_interface.begin(), work.changed_interface.end());
        work.changed_interface.clear();
    };
    for (const auto& part : parts_) {
        take(part->work);
    }
    take(whole_);
    if (changed.empty()) {
        return;
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (std::size_t i = first_colour_; i < parts_.size(); ++i) {
        parts_[i]->work.interface.clear();
    }
    whole_.interface.clear();
    change_interface(changed);
}

template <class Real>
void SubmeshExecutor<Real>::change_interface(std::span<const std::uint32_t> changed) {
    for (std::size_t i = 0; i < first_colour_; ++i) {
        take_off(parts_[i]->work.interface, changed);
    }
    take_off(whole_.interface, changed);
    for (const std::uint32_t v : changed) {
        if (is_moved(complex_, options_, Vertex{v})) {
            (parts_.empty() ? whole_ : owner_of(v).work).interface.push_back(v);
        }
    }
}

// After a renumbering, the ids that the submeshes hold belong to other simplices. O(mesh).
template <class Real>
void SubmeshExecutor<Real>::forget_ids() {
    for (const auto& part : parts_) {
        part->pool.vertices.clear();
        part->pool.triangles.clear();
        part->work.deferred.clear();
        part->work.active.clear();
        part->work.resized.clear();
        part->work.interface.clear();
    }
    whole_.active.clear();
    whole_.resized.clear();
    whole_.interface.clear();
    clear_stamps(complex_);
    find_past();
    std::vector<std::uint32_t> list = collect_moved(complex_, options_);
    if (parts_.empty()) {
        whole_.interface = std::move(list);
    } else {
        hand_out(std::move(list));
    }
}

template <class Real>
void SubmeshExecutor<Real>::absorb(std::span<const Edit> edits) {
    const auto after = edits_after_renumbering(edits);
    if (after.size() != edits.size()) {
        forget_ids();
    }
    if (const auto changed = interface_changes(after); !changed.empty()) {
        change_interface(changed);
    }
    // They are looked at after the submeshes have done their part.
    whole_.epoch = next_epochs();
    wake(whole_, after);
}

// Handed out to the submeshes before they move.
template <class Real>
void SubmeshExecutor<Real>::resize(std::span<const std::uint32_t> list) {
    whole_.resized.insert(whole_.resized.end(), list.begin(), list.end());
}

// Vertices to be looked at because targets changed there: to the submeshes that own them by now. An
// id may be in use elsewhere since it was noted, and its stamp is not to be written from there
// then. O(their number): they are in the order of stars, so that the submesh of one is nearly
// always that of the next.
template <class Real>
void SubmeshExecutor<Real>::hand_out_resized() {
    std::vector<std::uint32_t>& list = whole_.resized; // no submesh, so that it may collect
    for (const auto& part : parts_) {
        list.insert(list.end(), part->work.resized.begin(), part->work.resized.end());
        part->work.resized.clear();
    }
    const Colour& colour = partition_.colours.front();
    std::size_t at = 0;
    for (const std::uint32_t v : list) {
        if (!complex_.is_alive(Vertex{v})) {
            continue;
        }
        const Point<double> place = place_of(v);
        if (!parts_[at]->work.submesh.region.owns(v, place.x(), place.y())) {
            const std::size_t found = colour.locate(v, place.x(), place.y());
            at = found < first_colour_ ? found : 0;
        }
        parts_[at]->work.resized.push_back(v);
    }
    list.clear();
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void SubmeshExecutor<Real>::set_options(const Options<Real>&);                        \
    template void SubmeshExecutor<Real>::resize(std::span<const std::uint32_t>);                   \
    template void SubmeshExecutor<Real>::hand_out_resized();                                       \
    template void SubmeshExecutor<Real>::keep_edits(bool);                                         \
    template void SubmeshExecutor<Real>::collect_edits();                                          \
    template void SubmeshExecutor<Real>::collect_changes();                                        \
    template std::vector<Edit> SubmeshExecutor<Real>::take_edits();                                \
    template std::uint64_t SubmeshExecutor<Real>::move_missed(std::span<const std::uint32_t>);     \
    template void SubmeshExecutor<Real>::absorb(std::span<const Edit>);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
