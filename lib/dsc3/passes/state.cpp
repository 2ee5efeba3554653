// SPDX-License-Identifier: MIT
#include "dsc3/passes/state.h"

#include <algorithm>
#include <iterator>

namespace dsc3 {

namespace {

// Grows by half as much again.
template <class Value>
void grow_to(std::vector<Value>& list, std::size_t size) {
    if (list.size() < size) {
        list.resize(size + size / 2 + 64);
    }
}

} // namespace

void PassState::grow() {
    grow_to(targets, complex.vertex_bound());
    grow_to(moving, complex.vertex_bound());
    grow_to(moves, complex.vertex_bound());
    grow_to(tet_stamps, complex.tet_bound());
    threads.resize(team.size());
    for (ThreadScratch& thread : threads) {
        grow_to(thread.places, complex.vertex_bound());
    }
}

void PassState::collect_from_submeshes() {
    if (submeshes == nullptr) {
        return;
    }
    submeshes->hand_over(work);
    for (SubmeshWorker& worker : submeshes->workers()) {
        move_all(unimproved, worker.unimproved);
    }
}

void PassState::update_ends() {
    ends_on_sides = std::any_of(interface.begin(), interface.end(),
                                [&](std::uint32_t v) { return complex.is_boundary(Vertex{v}); });
}

void PassState::update_interface() {
    auto& added = work.rewiring.interface;
    const auto has_left = [&](std::uint32_t v) { return !complex.is_interface(Vertex{v}); };
    std::erase_if(interface, has_left);
    std::erase_if(added, has_left);
    if (!added.empty()) {
        std::sort(added.begin(), added.end());
        added.erase(std::unique(added.begin(), added.end()), added.end());
        merged.clear();
        std::set_union(interface.begin(), interface.end(), added.begin(), added.end(),
                       std::back_inserter(merged));
        interface.swap(merged);
        added.clear();
    }
    update_ends();
}

void PassState::find_interface() {
    interface.clear();
    work.rewiring.interface.clear();
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.is_interface(Vertex{v})) {
            interface.push_back(v);
        }
    }
    update_ends();
}

void PassState::renumber() {
    const std::vector<std::uint32_t> ids = renumber_tets(complex);
    std::erase_if(unfit,
                  [&](std::uint32_t& t) { return (t = t < ids.size() ? ids[t] : no_id) == no_id; });
}

void PassState::drop_stale_late() {
    std::erase_if(late, [&](const LateVertex& one) {
        return !complex.is_interface(Vertex{one.vertex}) || one.place != complex.at(one.vertex);
    });
}

void PassState::collect_unfit(Real quality) {
    for (const std::uint32_t t : work.rewiring.changed) {
        if (complex.is_alive(Tet{t}) && quality_of(complex, t) < quality) {
            unfit.push_back(t);
        }
    }
    work.rewiring.changed.clear();
}

} // namespace dsc3
