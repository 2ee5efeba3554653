// SPDX-License-Identifier: MIT
// The ids that the complex lends to its submeshes, so that each can create vertices and triangles
// independently.
#include "dsc/parallel/in_place/submesh_part.h"

namespace dsc {

namespace {

/// Ids that each submesh holds in addition to one for each of its interface vertices; edits that
/// need more are deferred to the next colour, never lost.
constexpr std::size_t spare_vertices = 64;

} // namespace

// Lends a pool to each submesh, if the present ones are of an earlier generation.
template <class Real>
void SubmeshExecutor<Real>::lend_pools() {
    if (has_pools()) {
        return;
    }
    complex_.ids.collect();
    generation_ = complex_.ids.generation;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        IdPool*& used = parts_[i]->work.submesh.pool;
        const bool is_whole = parts_[i]->work.submesh.region.is_whole();
        parts_[i]->pool = &complex_.ids.lend(i);
        used = is_whole ? &complex_.ids : parts_[i]->pool;
    }
}

template <class Real>
std::size_t SubmeshExecutor<Real>::min_vertices(const Part& part) {
    return part.work.submesh.region.is_whole() ? 0 // the whole mesh uses the complex's own ids
                                               : spare_vertices + part.work.interface.size() / 2;
}

// Reserves memory for the pools, for more submeshes as the interface grows, and for a mesh that
// grows by half: copying the arrays in a step would take as long as ten steps. Reserved memory that
// is never touched takes no physical memory. Beyond this reserve the arrays double, as vectors do.
template <class Real>
void SubmeshExecutor<Real>::make_room() {
    std::size_t lent = spare_vertices;
    for (const auto& part : parts_) {
        lent += 2 * min_vertices(*part);
    }
    const auto roomy = [lent](std::size_t bound, std::size_t each) {
        return bound + bound / 2 + 4 * each * lent;
    };
    complex_.reserve(roomy(complex_.vertex_bound(), 1), roomy(complex_.triangle_bound(), 2));
}

template <class Real>
void SubmeshExecutor<Real>::refill(Part& part) {
    IdPool& pool = *part.pool;
    const std::size_t min = min_vertices(part);
    if (pool.vertices.size() >= min && pool.triangles.size() >= 2 * min) {
        return;
    }
    // Lends twice as many as needed, so that this is rare.
    while (pool.vertices.size() < 2 * min) {
        const std::uint32_t id = complex_.take_vertex(complex_.ids);
        complex_.vertices[id].flags = vertex_dead;
        pool.vertices.push_back(id);
    }
    while (pool.triangles.size() < 4 * min) {
        const std::uint32_t id = complex_.take_triangle(complex_.ids);
        complex_.triangles[id].v = {no_id, no_id, no_id};
        pool.triangles.push_back(id);
    }
}

// Gives back ids beyond several times the number that the present work needs.
template <class Real>
void SubmeshExecutor<Real>::give_back_surplus(Part& part) {
    const std::size_t max = 4 * (spare_vertices + part.work.interface.size());
    move_ids(*part.pool, complex_.ids, max, 2 * max);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void SubmeshExecutor<Real>::lend_pools();                                             \
    template void SubmeshExecutor<Real>::give_back_surplus(Part&);                                 \
    template std::size_t SubmeshExecutor<Real>::min_vertices(const Part&);                         \
    template void SubmeshExecutor<Real>::make_room();                                              \
    template void SubmeshExecutor<Real>::refill(Part&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
