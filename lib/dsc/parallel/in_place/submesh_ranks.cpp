// SPDX-License-Identifier: MIT
// A section that ranks share: each runs its own submeshes, tells the others what they did, and does
// what the others tell. See submesh_messages.cpp for what is told.
#include "dsc/parallel/in_place/submesh_ranks.h"
#include "dsc/parallel/timer.h"

#include <algorithm>

namespace dsc {

template <class Real>
void SubmeshExecutor<Real>::share_by(Ranks* ranks) {
    if (ranks == nullptr || ranks->size() == 1) {
        return;
    }
    shared_ = std::make_unique<Shared>(*ranks);
}

// Cells of a first colour stand in the order of their cuts, so that neighbours mostly have the same
// rank. Those of a later colour lie in the same order.
template <class Real>
void SubmeshExecutor<Real>::share_out_parts() {
    if (!shared_) {
        return;
    }
    const std::uint32_t ranks = shared_->ranks.size();
    shared_->colours.resize(partition_.colours.size());
    std::size_t first = 0;
    for (std::size_t c = 0; c < partition_.colours.size(); ++c) {
        const std::size_t count = partition_.colours[c].regions.size();
        std::vector<std::uint64_t> work(count, 0);
        for (std::size_t i = 0; i < count && c == 0; ++i) {
            const Part& part = *parts_[i];
            work[i] = part.work.interface.size() + part.examined;
        }
        auto& colour = shared_->colours[c];
        colour.shares = share_out(work, ranks);
        for (ShareOfRank& share : colour.shares) {
            share.begin += first;
            share.end += first;
        }
        const ShareOfRank own = shared_->share(c);
        colour.own.tasks.clear();
        colour.own.tasks.add_colour(own.end - own.begin);
        first += count;
    }
    for (const auto& part : parts_) {
        part->work.notes_touched = true;
        part->work.log.readers = 1;
    }
}

// As many as have enough to do on this rank.
template <class Real>
void SubmeshExecutor<Real>::choose_threads() {
    const ShareOfRank own = shared_ ? shared_->share(0) : ShareOfRank{0, first_colour_};
    std::size_t size = shared_ ? 0 : interface_size();
    for (std::size_t i = own.begin; shared_ && i < own.end; ++i) {
        size += parts_[i]->work.interface.size();
    }
    const std::size_t pay_off = size / submeshes_.vertices_per_thread;
    useful_threads_ = static_cast<std::uint32_t>(
        std::clamp<std::size_t>(pay_off, 1, std::max<std::size_t>(own.end - own.begin, 1)));
    threads_ = std::min(useful_threads_,
                        submeshes_.adapts_threads ? choice_.threads() : submeshes_.threads);
    // Ahead of their use, for a new thread takes milliseconds to get a core of its own; but none
    // where the interface is far too short, for it would also delay the steps meanwhile.
    const std::size_t soon = (size + size / 2) / submeshes_.vertices_per_thread;
    pool_.start(static_cast<std::uint32_t>(std::min<std::size_t>(soon, submeshes_.threads)));
}

template <class Real>
void SubmeshExecutor<Real>::run_aiming(Section section, FunctionRef<void(std::size_t)> task) {
    if (shared_) {
        run_shared(0, section, task);
    } else {
        aiming_.run(pool_, threads_, submeshes_.assignment, task);
    }
}

// Between two ranks there are no flags to wait for, so they exchange after each colour.
template <class Real>
void SubmeshExecutor<Real>::run_moving(FunctionRef<void(std::size_t)> task) {
    if (!shared_) {
        moving_.run(pool_, threads_, submeshes_.assignment, task);
        return;
    }
    for (std::size_t colour = 0; colour < partition_.colours.size(); ++colour) {
        run_shared(colour, Section::move, task);
    }
}

// What is about to be found on another rank is not to be mistaken for what was found here when the
// submesh was this rank's.
template <class Real>
void SubmeshExecutor<Real>::forget_others() {
    if (!shared_) {
        return;
    }
    for (std::size_t i = 0; i < first_colour_; ++i) {
        if (!shared_->share(0).has(i)) {
            parts_[i]->work.deferred.clear();
            parts_[i]->forget_aims();
        }
    }
}

// Where other ranks have aimed from: `take_displaced` asks who has moved since.
template <class Real>
void SubmeshExecutor<Real>::place_others() {
    if (!shared_ || options_.interface.coarsening != Coarsening::area) {
        return;
    }
    for (std::size_t i = 0; i < first_colour_; ++i) {
        if (shared_->share(0).has(i)) {
            continue;
        }
        const Work<Real>& work = parts_[i]->work;
        Aim<Real>& aim = parts_[i]->work.aim;
        for (const std::uint32_t v : work.interface) {
            aim.positions.push_back(complex_.position(Vertex{v}));
        }
        const std::size_t size = work.interface.size();
        aim.targets.resize(size);
        aim.held.resize(size);
        aim.scratch.first.resize(size);
    }
}

template <class Real>
void SubmeshExecutor<Real>::run_shared(std::size_t colour, Section section,
                                       FunctionRef<void(std::size_t)> task) {
    Shared& shared = *shared_;
    const ShareOfRank own = shared.share(colour);
    RankTimes times;
    Timer timer;
    remember(colour, section);
    times.tell = timer.lap();
    std::exception_ptr failure;
    try {
        shared.colours[colour].own.run(pool_, threads_, submeshes_.assignment,
                                       [&](std::size_t i) { task(own.begin + i); });
    } catch (...) { // NOLINT: told to all ranks, and thrown by all
        failure = std::current_exception();
    }
    times.work = timer.lap();
    tell_section(colour, section);
    times.tell += timer.lap();
    const std::span<MessageReader> all = shared.ranks.exchange(failure);
    times.wait = timer.lap();
    for (std::uint32_t rank = 0; rank < all.size(); ++rank) {
        if (rank != shared.ranks.rank()) {
            hear_section(all[rank], colour, section, shared.colours[colour].shares[rank]);
        }
    }
    times.repeat = timer.lap();
    shared.ranks.add(times);
    for (const auto& part : parts_) {
        part->work.seen_plain.clear();
    }
    if (!keeps_edits_) {
        for (const auto& part : parts_) {
            part->work.log.records.clear();
        }
    }
    if (shared.ranks.failed_with()) {
        std::rethrow_exception(shared.ranks.failed_with());
    }
}

// The vertices whose flags the passes of a section may change without an edit: those of the
// interface list, and those that move.
template <class Real>
void SubmeshExecutor<Real>::remember(std::size_t colour, Section section) {
    Shared& shared = *shared_;
    const ShareOfRank own = shared.share(colour);
    if (shared.before.size() < own.end - own.begin) {
        shared.before.resize(own.end - own.begin);
    }
    for (std::size_t number = own.begin; number < own.end; ++number) {
        const Part& part = *parts_[number];
        auto& before = shared.before[number - own.begin];
        const IdPool& pool = *part.work.submesh.pool;
        before.records = part.work.log.records.size();
        before.free_vertices = pool.vertices;
        before.free_triangles = pool.triangles;
        before.interface = part.work.interface;
        before.flags.clear();
        const auto add = [&](std::uint32_t v) {
            before.flags.push_back({v, complex_.vertices[v].flags});
        };
        const auto add_mover = [&](const Deferred<Real>& one) {
            if (one.kind == DeferredKind::mover) {
                add(one.vertex);
            }
        };
        if (section == Section::aim_again) {
            continue;
        }
        if (colour == 0) {
            std::ranges::for_each(part.work.interface, add);
            std::ranges::for_each(part.arrivals.entries, add_mover);
            continue;
        }
        for (const std::uint32_t earlier : moving_.tasks.predecessors(number)) {
            for (const Deferred<Real>& one : parts_[earlier]->work.deferred.entries) {
                if (one.route == number) {
                    add_mover(one);
                }
            }
        }
    }
}

template <class Real>
bool SubmeshExecutor<Real>::any_rank(bool mine) {
    return shared_ ? shared_->ranks.any(mine) : mine;
}

// What ends a step on this rank alone, such as an error of a listener, is told to the others.
template <class Real>
void SubmeshExecutor<Real>::tell_failure() {
    const std::exception_ptr failure = std::current_exception();
    if (shared_ && failure) {
        shared_->ranks.leave(failure);
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void SubmeshExecutor<Real>::share_by(Ranks*);                                         \
    template void SubmeshExecutor<Real>::choose_threads();                                         \
    template void SubmeshExecutor<Real>::share_out_parts();                                        \
    template void SubmeshExecutor<Real>::forget_others();                                          \
    template void SubmeshExecutor<Real>::place_others();                                           \
    template void SubmeshExecutor<Real>::run_aiming(Section, FunctionRef<void(std::size_t)>);      \
    template void SubmeshExecutor<Real>::run_moving(FunctionRef<void(std::size_t)>);               \
    template void SubmeshExecutor<Real>::run_shared(std::size_t, Section,                          \
                                                    FunctionRef<void(std::size_t)>);               \
    template void SubmeshExecutor<Real>::remember(std::size_t, Section);                           \
    template bool SubmeshExecutor<Real>::any_rank(bool);                                           \
    template void SubmeshExecutor<Real>::tell_failure();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
