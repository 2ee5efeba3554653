// SPDX-License-Identifier: MIT
// The ids that the complex lends to its submeshes, so that each can make vertices and triangles
// without asking the others.
#include "dsc/parallel/in_place/submesh_part.h"

namespace dsc {

namespace {

/// Ids that each submesh holds in addition to one for each of its interface vertices; what does not
/// fit is put off to the next colour, never lost.
constexpr std::size_t spare_vertices = 64;

} // namespace

template <class Real>
void SubmeshExecutor<Real>::give_back(IdPool& pool, std::size_t vertices, std::size_t triangles) {
    const auto give = [](std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to,
                         std::size_t keep) {
        while (from.size() > keep) {
            to.push_back(from.back());
            from.pop_back();
        }
    };
    give(pool.vertices, complex_.ids.vertices, vertices);
    give(pool.triangles, complex_.ids.triangles, triangles);
}

template <class Real>
std::size_t SubmeshExecutor<Real>::least_vertices(const Part& part) {
    return part.work.submesh.region.is_whole() ? 0 // it uses those of the complex
                                               : spare_vertices + part.work.interface.size() / 2;
}

// Room for what the pools are about to take, for what they take when a longer interface has more
// submeshes, and for a mesh that grows by half: to copy the arrays in a step would take as long as
// ten steps. Room that is never used is never touched, and takes no memory. Beyond that the arrays
// double, as vectors do.
template <class Real>
void SubmeshExecutor<Real>::make_room() {
    std::size_t lent = spare_vertices;
    for (const auto& part : parts_) {
        lent += 2 * least_vertices(*part);
    }
    const auto roomy = [lent](std::size_t bound, std::size_t each) {
        return bound + bound / 2 + 4 * each * lent;
    };
    complex_.reserve(roomy(complex_.vertex_bound(), 1), roomy(complex_.triangle_bound(), 2));
}

template <class Real>
void SubmeshExecutor<Real>::refill(Part& part) {
    IdPool& pool = part.pool;
    const std::size_t least = least_vertices(part);
    if (pool.vertices.size() >= least && pool.triangles.size() >= 2 * least) {
        return;
    }
    // Twice as many, so that this is rare.
    while (pool.vertices.size() < 2 * least) {
        const std::uint32_t id = complex_.take_vertex(complex_.ids);
        complex_.vertices[id].flags = vertex_dead;
        pool.vertices.push_back(id);
    }
    while (pool.triangles.size() < 4 * least) {
        const std::uint32_t id = complex_.take_triangle(complex_.ids);
        complex_.triangles[id].v = {no_id, no_id, no_id};
        pool.triangles.push_back(id);
    }
}

// As many as it would need if it took on several times its work.
template <class Real>
void SubmeshExecutor<Real>::give_back_surplus(Part& part) {
    const std::size_t most = 4 * (spare_vertices + part.work.interface.size());
    give_back(part.pool, most, 2 * most);
}

template <class Real>
void SubmeshExecutor<Real>::count_lent() {
    complex_.lent_vertices = 0;
    complex_.lent_triangles = 0;
    for (const auto& part : parts_) {
        complex_.lent_vertices += static_cast<std::uint32_t>(part->pool.vertices.size());
        complex_.lent_triangles += static_cast<std::uint32_t>(part->pool.triangles.size());
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void SubmeshExecutor<Real>::give_back(IdPool&, std::size_t, std::size_t);             \
    template void SubmeshExecutor<Real>::give_back_surplus(Part&);                                 \
    template std::size_t SubmeshExecutor<Real>::least_vertices(const Part&);                       \
    template void SubmeshExecutor<Real>::make_room();                                              \
    template void SubmeshExecutor<Real>::refill(Part&);                                            \
    template void SubmeshExecutor<Real>::count_lent();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
