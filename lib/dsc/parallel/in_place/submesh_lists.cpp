// SPDX-License-Identifier: MIT
// Keeps each vertex of the interface, and each star that has to be visited, in the list of the
// submesh that owns it.
#include "dsc/base/room.h"
#include "dsc/parallel/in_place/submesh_part.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/work.h"

namespace dsc {

// The submesh of the first colour that owns a vertex; submesh 0 if an application's partition has a
// gap there.
template <class Real>
std::size_t SubmeshExecutor<Real>::owner_of(std::uint32_t vertex, std::size_t hint) const {
    const Point<double> place = place_of(vertex);
    const std::size_t at = partition_.colours.front().locate(vertex, place.x(), place.y(), hint);
    return at < first_colour_ ? at : 0;
}

template <class Real>
Work<Real>& SubmeshExecutor<Real>::home_of(std::uint32_t vertex) {
    return parts_.empty() ? whole_ : parts_[owner_of(vertex)]->work;
}

// Distributes the vertices to be visited because targets changed to the submeshes that own them
// now: an id may have been reused elsewhere since, and only its owner may write its stamp. O(their
// number), since consecutive vertices are nearly always in the same submesh.
template <class Real>
void SubmeshExecutor<Real>::distribute_resized() {
    std::vector<std::uint32_t>& list = whole_.resized; // not in use while the mesh is divided
    for (const auto& part : parts_) {
        append(list, part->work.resized);
        part->work.resized.clear();
    }
    std::size_t at = 0;
    for (const std::uint32_t v : list) {
        if (complex_.is_alive(Vertex{v})) {
            at = owner_of(v, at);
            parts_[at]->work.resized.push_back(v);
        }
    }
    list.clear();
}

// Routes interface vertices that are in no list, and those that have entered another submesh, to
// their owners. They have targets already, move in the owner's task, and are listed there when the
// sub-step is over.
template <class Real>
void SubmeshExecutor<Real>::route_to_owners() {
    const auto to_owner = [this](Deferred<Real> one) {
        one.route = static_cast<std::uint32_t>(owner_of(one.vertex));
        whole_.deferred.entries.push_back(one);
    };
    for (const MovingVertex<Real>& moving_vertex : whole_.moving_vertices) {
        to_owner({.vertex = moving_vertex.vertex,
                  .x = moving_vertex.x,
                  .y = moving_vertex.y,
                  .kind = DeferredKind::moving_vertex});
    }
    for (const std::uint32_t v : whole_.interface) {
        to_owner({.vertex = v, .kind = DeferredKind::listing});
    }
    whole_.moving_vertices.clear();
    whole_.interface.clear();
}

// After an unfinished sub-step: stars that it did not visit are visited in the next one, and moving
// vertices stay where they are.
template <class Real>
void SubmeshExecutor<Real>::put_back() {
    std::vector<std::uint32_t>& later = whole_.resized; // for the submesh that will own them
    for (Work<Real>* work : works_) {
        append(later, work->active);
        for (const Deferred<Real>& one : work->deferred.entries) {
            if (one.kind == DeferredKind::star) {
                later.push_back(one.vertex);
            }
        }
        work->active.clear();
        work->deferred.clear();
        work->moving_vertices.clear();
    }
    append(whole_.poor, later);
    if (progress_ == Progress::has_targets) { // every vertex of the interface is in a list
        for (const std::uint32_t v : whole_.interface) {
            home_of(v).interface.push_back(v);
        }
        whole_.interface.clear();
        this->collect_changes();
    } else {
        for (Work<Real>* work : works_) {
            work->changed_interface.clear();
        }
        this->list_interface();
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::size_t SubmeshExecutor<Real>::owner_of(std::uint32_t, std::size_t) const;        \
    template Work<Real>& SubmeshExecutor<Real>::home_of(std::uint32_t);                            \
    template void SubmeshExecutor<Real>::distribute_resized();                                     \
    template void SubmeshExecutor<Real>::route_to_owners();                                        \
    template void SubmeshExecutor<Real>::put_back();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
