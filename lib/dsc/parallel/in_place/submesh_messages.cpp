// SPDX-License-Identifier: MIT
// What ranks tell each other after a section, submesh by submesh: the log of its edits; what passes
// change without an edit, which is flags and values of vertices; and of its lists what others read.
#include "dsc/parallel/in_place/submesh_ranks.h"
#include "dsc/parallel/ranks/edit_message.h"
#include "dsc/parallel/ranks/list_difference.h"
#include "dsc/parallel/ranks/value_message.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace dsc {

namespace {

using CountField = std::uint64_t OperationCounts::*;

constexpr std::array<CountField, 11> count_fields{
    &OperationCounts::moves,
    &OperationCounts::flips,
    &OperationCounts::interface_splits,
    &OperationCounts::interface_collapses,
    &OperationCounts::splits,
    &OperationCounts::collapses,
    &OperationCounts::smoothed,
    &OperationCounts::subdivisions,
    &OperationCounts::retriangulations,
    &OperationCounts::relabelled,
    &OperationCounts::examined,
};
static_assert(sizeof(OperationCounts) == count_fields.size() * sizeof(std::uint64_t));

// Whether the library itself writes values of vertices in its passes. Where it does not, and no
// pass of an application has said that it did, the edits tell all.
bool has_values_of_passes(const AttributeSet& attributes) {
    return std::ranges::any_of(attributes.list(), [](const auto& one) {
        return one->kind() == SimplexKind::vertex && one->name().starts_with("dsc.");
    });
}

// Stars and movements that a submesh put off: in the sections in which things move nobody reads
// anything else.
bool is_of(DeferredKind kind, bool moves) {
    return moves == (kind == DeferredKind::star || kind == DeferredKind::mover);
}

template <class Real>
void write_deferred(MessageWriter& message, const DeferredQueue<Real>& queue, bool moves) {
    const auto is_told = [moves](const auto& one) { return is_of(one.kind, moves); };
    message.count(static_cast<std::uint64_t>(std::ranges::count_if(queue.entries, is_told)));
    for (const Deferred<Real>& one : queue.entries) {
        if (is_told(one)) {
            message.raw(one.kind, one.vertex);
            message.count(static_cast<std::uint32_t>(one.route + 1)); // nowhere: 0
            if (one.kind == DeferredKind::mover) {
                message.raw(one.x, one.y);
            }
        }
    }
}

template <class Real>
void read_deferred(MessageReader& message, DeferredQueue<Real>& queue) {
    queue.clear();
    for (std::uint64_t left = message.count(); left > 0; --left) {
        Deferred<Real> one{};
        message.raw(one.kind, one.vertex);
        one.route = static_cast<std::uint32_t>(message.count()) - 1;
        if (one.kind == DeferredKind::mover) {
            message.raw(one.x, one.y);
        }
        queue.entries.push_back(one);
    }
}

void write_counts(MessageWriter& message, const OperationCounts& counts) {
    std::uint16_t some = 0;
    for (std::size_t i = 0; i < count_fields.size(); ++i) {
        some = static_cast<std::uint16_t>(some | (counts.*count_fields[i] > 0 ? 1U << i : 0U));
    }
    message.raw(some);
    for (const CountField field : count_fields) {
        if (counts.*field > 0) {
            message.count(counts.*field);
        }
    }
}

void read_counts(MessageReader& message, OperationCounts& counts) {
    const auto some = message.one<std::uint16_t>();
    for (std::size_t i = 0; i < count_fields.size(); ++i) {
        counts.*count_fields[i] = (some >> i & 1U) != 0 ? message.count() : 0;
    }
}

} // namespace

template <class Real>
void SubmeshExecutor<Real>::tell_section(std::size_t colour, Section section) {
    Shared& shared = *shared_;
    const ShareOfRank own = shared.share(colour);
    MessageWriter& message = shared.ranks.begin();
    AimReport<Real> aimed;
    try {
        for (std::size_t i = own.begin; i < own.end && section != Section::aim_again; ++i) {
            tell_part(message, *parts_[i], shared.before[i - own.begin], section, colour == 0);
        }
        if (section == Section::aim || section == Section::aim_again) {
            for (std::size_t i = own.begin; i < own.end; ++i) {
                aimed += parts_[i]->aimed;
            }
            message.raw(aimed);
        }
        if (section != Section::aim_again) {
            tell_values(message, colour, section);
        }
    } catch (...) {
        shared.ranks.leave(std::current_exception());
        throw;
    }
}

template <class Real>
void SubmeshExecutor<Real>::hear_section(MessageReader& message, std::size_t colour,
                                         Section section, const ShareOfRank& share) {
    for (std::size_t i = share.begin; i < share.end && section != Section::aim_again; ++i) {
        hear_part(message, *parts_[i], section, colour == 0);
    }
    if (section == Section::aim || section == Section::aim_again) {
        const auto aimed = message.one<AimReport<Real>>();
        for (std::size_t i = share.begin; i < share.end; ++i) {
            parts_[i]->aimed = i == share.begin ? aimed : AimReport<Real>{}; // they are summed up
        }
    }
    if (section != Section::aim_again) {
        read_values(message, complex_.attributes);
    }
}

// The flags that differ, or may do so where the edits are repeated: those of new vertices, which
// have none there at first, and of vertices that an edit has made less plain before they were seen
// to be.
template <class Real>
template <class Before>
void SubmeshExecutor<Real>::tell_flags(MessageWriter& message, const Before& before,
                                       std::span<const Edit> edits,
                                       std::span<const std::uint32_t> seen_plain) {
    auto& told = shared_->valuable;
    told.clear();
    const auto flags_of = [this](std::uint32_t v) { return complex_.vertices[v].flags; };
    const auto is_alive = [this](std::uint32_t v) { return complex_.is_alive(Vertex{v}); };
    for (const auto& [v, flags] : before.flags) {
        if (flags_of(v) != flags && is_alive(v)) {
            told.push_back(v);
        }
    }
    for (const Edit& edit : edits) {
        if (edit.kind == EditKind::split && is_alive(edit.vertex.id) &&
            flags_of(edit.vertex.id) != 0) {
            told.push_back(edit.vertex.id);
        }
    }
    std::ranges::copy_if(seen_plain, std::back_inserter(told), is_alive);
    message.count(told.size());
    for (const std::uint32_t v : told) {
        message.raw(v);
        message.count(flags_of(v));
    }
}

template <class Real>
template <class Before>
void SubmeshExecutor<Real>::tell_part(MessageWriter& message, const Part& part,
                                      const Before& before, Section section, bool is_first) {
    const Work<Real>& work = part.work;
    const IdPool& pool = *work.submesh.pool;
    const auto edits = std::span<const Edit>(work.log.records).subspan(before.records);
    if (work.submesh.region.is_whole()) {
        message.raw(complex_.vertex_bound(), complex_.triangle_bound()); // it may let them grow
    }
    write_edits<Real>(message, edits);
    write_difference(message, before.free_vertices, pool.vertices);
    write_difference(message, before.free_triangles, pool.triangles);
    tell_flags(message, before, edits, work.seen_plain);
    write_counts(message, work.log.counts);
    message.list(work.changed_interface);
    message.list(work.resized);
    if (is_first) {
        write_difference(message, before.interface, work.interface);
    }
    if (section != Section::upkeep) {
        write_deferred(message, work.deferred, section == Section::move);
    }
    if (section == Section::aim) {
        message.list(work.topology_suspects);
    } else if (section == Section::move) {
        message.count(part.moved.passes);
        message.count(part.moved.unreached);
        message.count(part.moved.held);
        message.list(work.missed);
        message.list(work.active);
    }
    if (submeshes_.profile) {
        message.raw(part.upkeep_s, part.velocities_s, part.aim_s, part.move_s);
    }
}

template <class Real>
void SubmeshExecutor<Real>::hear_part(MessageReader& message, Part& part, Section section,
                                      bool is_first) {
    Work<Real>& work = part.work;
    IdPool& pool = *work.submesh.pool;
    if (work.submesh.region.is_whole()) {
        grow_to(message);
    }
    repeat_edits(message, complex_, keeps_edits_ ? work.log : shared_->silent);
    read_difference(message, pool.vertices);
    read_difference(message, pool.triangles);
    for (std::uint64_t left = message.count(); left > 0; --left) {
        const auto v = message.one<std::uint32_t>();
        complex_.vertices.at(v).flags = static_cast<std::uint32_t>(message.count());
    }
    read_counts(message, work.log.counts);
    message.list(work.changed_interface);
    message.list(work.resized);
    if (is_first) {
        read_difference(message, work.interface);
    }
    if (section != Section::upkeep) {
        read_deferred(message, work.deferred);
    }
    if (section == Section::aim) {
        message.list(work.topology_suspects);
    } else if (section == Section::move) {
        part.moved.passes = static_cast<std::uint32_t>(message.count());
        part.moved.unreached = message.count();
        part.moved.held = message.count();
        message.list(work.missed);
        message.list(work.active);
    }
    if (submeshes_.profile) {
        message.raw(part.upkeep_s, part.velocities_s, part.aim_s, part.move_s);
    }
}

// The ids that the only submesh of another rank has taken from the complex: those beyond the end
// are new here. Free until its edits are repeated.
template <class Real>
void SubmeshExecutor<Real>::grow_to(MessageReader& message) {
    const auto vertices = message.one<std::uint32_t>();
    const auto triangles = message.one<std::uint32_t>();
    IdPool none;
    while (complex_.vertex_bound() < vertices) {
        complex_.vertices[complex_.take_vertex(none)].flags = vertex_dead;
    }
    while (complex_.triangle_bound() < triangles) {
        complex_.triangles[complex_.take_triangle(none)].v = {no_id, no_id, no_id};
    }
}

// Values that passes have written, those of new vertices, which are blended of such values, and
// those of fields that were looked up in a star.
template <class Real>
void SubmeshExecutor<Real>::tell_values(MessageWriter& message, std::size_t colour,
                                        Section section) {
    Shared& shared = *shared_;
    const ShareOfRank own = shared.share(colour);
    auto& list = shared.valuable;
    list.clear();
    bool are_told = has_values_of_passes(complex_.attributes);
    for (std::size_t i = own.begin; i < own.end; ++i) {
        Work<Real>& work = parts_[i]->work;
        are_told = are_told || !work.touched.empty();
        list.insert(list.end(), work.touched.begin(), work.touched.end());
        work.touched.clear();
    }
    if (are_told) {
        const bool has_fields = complex_.attributes.has_fields();
        for (std::size_t i = own.begin; i < own.end; ++i) {
            const auto& before = shared.before[i - own.begin];
            for (const Edit& edit :
                 std::span<const Edit>(parts_[i]->work.log.records).subspan(before.records)) {
                if (edit.kind == EditKind::split || (has_fields && edit.kind == EditKind::move)) {
                    list.push_back(edit.vertex.id);
                }
            }
            if (section == Section::move && colour == 0 &&
                options_.integrator == Integrator::centred) { // the last step of each
                list.insert(list.end(), before.interface.begin(), before.interface.end());
            }
        }
        std::ranges::sort(list);
        list.erase(std::unique(list.begin(), list.end()), list.end());
        std::erase_if(list, [&](std::uint32_t v) { return !complex_.is_alive(Vertex{v}); });
    }
    write_values(message, complex_.attributes, list);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void SubmeshExecutor<Real>::tell_section(std::size_t, Section);                       \
    template void SubmeshExecutor<Real>::hear_section(MessageReader&, std::size_t, Section,        \
                                                      const ShareOfRank&);                         \
    template void SubmeshExecutor<Real>::hear_part(MessageReader&, Part&, Section, bool);          \
    template void SubmeshExecutor<Real>::grow_to(MessageReader&);                                  \
    template void SubmeshExecutor<Real>::tell_values(MessageWriter&, std::size_t, Section);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
