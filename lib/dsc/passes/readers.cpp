// SPDX-License-Identifier: MIT
#include "dsc/passes/readers.h"

#include "dsc/base/room.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/gather.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/work.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <iterator>

namespace dsc {

namespace {

template <class Real>
void wake_vertex(Work<Real>& work, Vertex v) {
    if (work.complex.is_alive(v)) {
        work.activate(v.id);
    }
}

// The vertex and its link, counter-clockwise. Link vertices of another submesh are deferred: their
// own submesh may be stamping them at this moment.
template <class Real>
void wake_star(Work<Real>& work, Vertex v) {
    wake_vertex(work, v);
    if (work.complex.is_alive(v) && gather(work.complex, work.submesh.region, v.id, work.star)) {
        for (std::uint32_t i = 0; i < work.star.link_size(); ++i) {
            const std::uint32_t w = work.star.link[i];
            if (work.star.owned || owns(work.complex, work.submesh.region, w)) {
                work.activate(w);
            } else {
                work.deferred.star(w);
            }
        }
    }
}

template <class Real>
void wake_triangle(Work<Real>& work, Triangle t) {
    if (work.complex.is_alive(t)) {
        for (const Vertex v : work.complex.vertices_of(t)) {
            work.activate(v.id);
        }
    }
}

template <class Real>
void wake_edit(Work<Real>& work, const Edit& edit) {
    switch (edit.kind) {
    case EditKind::collapse: wake_star(work, edit.ends[1]); break;
    case EditKind::move: wake_star(work, edit.vertex); break;
    case EditKind::relabel:
    case EditKind::retriangulate: wake_triangle(work, Triangle{triangle_of(edit.corner)}); break;
    case EditKind::renumber:
    case EditKind::rebuild: break;
    case EditKind::flip:
    case EditKind::split:
    case EditKind::insert_vertex:
    case EditKind::remove_vertex:
    case EditKind::insert_triangle:
    case EditKind::remove_triangle:
        for (const Vertex v :
             {edit.vertex, edit.ends[0], edit.ends[1], edit.apexes[0], edit.apexes[1]}) {
            wake_vertex(work, v);
        }
        break;
    }
}

// Removes vertices that the pass has deleted from `moving_vertices`, which refers to them by ids
// that may be in use again. O(edits + moving vertices * log edits).
template <class Real>
void forget_vanished(Work<Real>& work, std::span<const Edit> edits) {
    std::vector<std::uint32_t>& gone = work.changed;
    gone.clear();
    for (const Edit& edit : edits) {
        if (edit.kind == EditKind::collapse || edit.kind == EditKind::remove_vertex) {
            gone.push_back(edit.vertex.id);
        }
    }
    std::ranges::sort(gone);
    std::erase_if(work.moving_vertices, [&](const MovingVertex<Real>& moving_vertex) {
        return std::ranges::binary_search(gone, moving_vertex.vertex);
    });
}

} // namespace

std::span<const Edit> edits_after_renumbering(std::span<const Edit> edits) {
    for (std::size_t i = edits.size(); i > 0; --i) {
        const EditKind kind = edits[i - 1].kind;
        if (kind == EditKind::renumber || kind == EditKind::rebuild) {
            return edits.subspan(i);
        }
    }
    return edits;
}

template <class Real>
void wake(Work<Real>& work, std::span<const Edit> edits) {
    for (const Edit& edit : edits) {
        wake_edit(work, edit);
    }
}

std::vector<std::uint32_t> interface_changes(std::span<const Edit> edits) {
    std::vector<std::uint32_t> changed;
    find_interface_changes(edits, changed);
    return changed;
}

std::vector<std::uint32_t> without_target(std::span<const Edit> edits) {
    std::vector<std::uint32_t> found;
    for (const Edit& edit : edits) {
        if (edit.kind == EditKind::collapse || edit.kind == EditKind::remove_vertex ||
            edit.kind == EditKind::move) {
            found.push_back(edit.vertex.id);
        }
    }
    return found;
}

void find_interface_changes(std::span<const Edit> edits, std::vector<std::uint32_t>& changed) {
    changed.clear();
    const auto add = [&](std::initializer_list<Vertex> vertices) {
        for (const Vertex v : vertices) {
            if (v.is_valid()) {
                changed.push_back(v.id);
            }
        }
    };
    for (const Edit& edit : edits) {
        switch (edit.kind) {
        case EditKind::split:
            // The new vertex may have the id of a former interface vertex.
            add({edit.vertex});
            break;
        case EditKind::collapse: add({edit.ends[0], edit.ends[1]}); break;
        case EditKind::insert_vertex:
        case EditKind::remove_vertex: add({edit.vertex}); break;
        // The triangle may have other vertices by now; the record has those at the time of the
        // edit.
        case EditKind::relabel:
        case EditKind::insert_triangle:
        case EditKind::remove_triangle: add({edit.ends[0], edit.ends[1], edit.apexes[0]}); break;
        case EditKind::flip:
        case EditKind::move:
        case EditKind::retriangulate:
        case EditKind::renumber:
        case EditKind::rebuild: break;
        }
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
}

void take_off(std::vector<std::uint32_t>& list, std::span<const std::uint32_t> changed) {
    std::erase_if(list, [&](std::uint32_t v) { return std::ranges::binary_search(changed, v); });
}

template <class Real>
bool is_on_interface(const Complex<Real>& complex, std::uint32_t vertex) {
    return complex.is_alive(Vertex{vertex}) && complex.vertices[vertex].corner != no_id &&
           is_interface(complex, Vertex{vertex});
}

template <class Real>
std::vector<std::uint32_t> on_interface(const Complex<Real>& complex,
                                        std::span<const std::uint32_t> changed) {
    std::vector<std::uint32_t> on;
    std::ranges::copy_if(changed, std::back_inserter(on),
                         [&](std::uint32_t v) { return is_on_interface(complex, v); });
    return on;
}

template <class Real>
void run_pass(Work<Real>& work, const Pass<Real>& pass) {
    const bool advects = !work.options.advected_phases.empty();
    if (pass.attends && !advects) {
        pass.run(work);
        return;
    }
    const LogReader reading(work.log);
    pass.run(work);
    if (reading.edits().empty()) {
        return;
    }
    if (!pass.attends) {
        wake(work, reading.edits());
        forget_vanished(work, reading.edits());
    }
    std::vector<std::uint32_t>& changed = work.changed;
    find_interface_changes(reading.edits(), changed);
    if (changed.empty()) {
        return;
    }
    take_off(work.interface, changed);
    for (const std::uint32_t v : changed) {
        if (is_moved(work.complex, work.options, Vertex{v})) {
            work.interface.push_back(v);
        }
    }
    append(work.changed_interface, changed);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void wake(Work<Real>&, std::span<const Edit>);                                        \
    template bool is_on_interface(const Complex<Real>&, std::uint32_t);                            \
    template std::vector<std::uint32_t> on_interface(const Complex<Real>&,                         \
                                                     std::span<const std::uint32_t>);              \
    template void run_pass(Work<Real>&, const Pass<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
