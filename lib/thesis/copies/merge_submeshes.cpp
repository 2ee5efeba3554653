// SPDX-License-Identifier: MIT
#include "thesis/copies/copied_submeshes.h"

#include "thesis/copies/copying.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"

#include <algorithm>

namespace dsc {

using copying::append_triangles;
using copying::clear;

namespace {

// A list that has to grow gets room for an eighth more: the meshes of most steps are about as large
// as before, and few of them the largest so far.
void assign_with_room(std::vector<std::uint32_t>& list, std::size_t size, std::uint32_t value) {
    if (list.capacity() < size) {
        list.reserve(size + size / 8);
    }
    list.assign(size, value);
}

template <class Real>
void merge_vertices(CopiedSubmeshes<Real>& submeshes, CopiedSubmesh<Real>& submesh) {
    Complex<Real>& fresh = submeshes.fresh;
    const Complex<Real>& complex = submesh.complex;
    assign_with_room(submesh.merged, complex.vertex_bound(), no_id);
    submeshes.order.clear();
    for (const Vertex v : vertices(complex)) {
        const auto& record = complex.vertices[v.id];
        if (record.corner == no_id) {
            continue;
        }
        const std::uint32_t original = submesh.shared[v.id];
        // A shared vertex is inserted by the first of its submeshes, since they are handled in
        // order.
        if (original != no_id && submeshes.merged[original] != no_id) {
            submesh.merged[v.id] = submeshes.merged[original];
            continue;
        }
        const std::uint32_t id = fresh.vertex_bound();
        submesh.merged[v.id] = id;
        if (original != no_id) {
            submeshes.merged[original] = id;
        }
        fresh.vertices.push_back({record.x, record.y, no_id, record.flags, 0, no_id});
        submeshes.order.push_back(v.id);
    }
    copying::append(fresh.attributes, SimplexKind::vertex, complex.attributes, submeshes.order);
}

// An edge at the border of a submesh lies on the domain boundary, or another submesh is beyond it:
// then both ends are shared, and a second triangle with them follows.
template <class Real>
void note_seam(CopiedSubmeshes<Real>& submeshes, const CopiedSubmesh<Real>& submesh, Corner corner,
               Corner merged) {
    const std::uint32_t a = submesh.complex.vertex(next(corner));
    const std::uint32_t b = submesh.complex.vertex(prev(corner));
    if (submesh.shared[a] == no_id || submesh.shared[b] == no_id) {
        return;
    }
    const auto [low, high] = std::minmax(submesh.merged[a], submesh.merged[b]);
    submeshes.seams.push_back({(static_cast<std::uint64_t>(low) << 32U) | high, merged});
}

template <class Real>
void merge_triangles(CopiedSubmeshes<Real>& submeshes, CopiedSubmesh<Real>& submesh) {
    Complex<Real>& fresh = submeshes.fresh;
    const Complex<Real>& complex = submesh.complex;
    assign_with_room(submesh.merged_triangles, complex.triangle_bound(), border_triangle);
    submeshes.order.clear();
    std::uint32_t id = fresh.triangle_bound();
    for (const Triangle t : triangles(complex)) {
        submesh.merged_triangles[t.id] = id++;
        submeshes.order.push_back(t.id);
    }
    for (const std::uint32_t t : submeshes.order) {
        const TriangleRecord& record = complex.triangles[t];
        TriangleRecord copy{{}, {}, record.phase, 0};
        const std::uint32_t merged = fresh.triangle_bound();
        for (std::uint32_t i = 0; i < 3; ++i) {
            copy.v[i] = submesh.merged[record.v[i]];
            fresh.vertices[copy.v[i]].corner = corner_of(merged, i);
            const Corner across = record.n[i];
            copy.n[i] = is_border(across) ? border_corner
                                          : corner_of(submesh.merged_triangles[triangle_of(across)],
                                                      index_of(across));
            if (is_border(across)) {
                note_seam(submeshes, submesh, corner_of(t, i), corner_of(merged, i));
            }
        }
        fresh.triangles.push_back(copy);
    }
    append_triangles(fresh.attributes, complex.attributes, submeshes.order, submeshes.corner_order);
}

// Sorting the half-edges at the submesh boundaries pairs those of the same edge; one without a
// partner is on the boundary of the domain, between two shared vertices.
template <class Real>
void close_seams(CopiedSubmeshes<Real>& submeshes) {
    auto& seams = submeshes.seams;
    auto& triangles = submeshes.fresh.triangles;
    std::sort(seams.begin(), seams.end(), [](const auto& a, const auto& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.corner < b.corner;
    });
    for (std::size_t i = 0; i + 1 < seams.size(); ++i) {
        const Corner a = seams[i].corner;
        const Corner b = seams[i + 1].corner;
        if (seams[i].ends != seams[i + 1].ends) {
            continue;
        }
        if (i + 2 < seams.size() && seams[i + 2].ends == seams[i].ends) {
            throw InvariantError(
                "merge_submeshes: an edge of two submeshes has more than two triangles");
        }
        triangles[triangle_of(a)].n[index_of(a)] = b;
        triangles[triangle_of(b)].n[index_of(b)] = a;
        ++i;
    }
}

} // namespace

template <class Real>
void merge_submeshes(CopiedSubmeshes<Real>& submeshes, Complex<Real>& mesh) {
    Complex<Real>& fresh = submeshes.fresh;
    clear(fresh);
    fresh.attributes = copying::without_entries(mesh.attributes);
    submeshes.order.assign(1, border_triangle);
    append_triangles(fresh.attributes, mesh.attributes, submeshes.order, submeshes.corner_order);
    submeshes.merged.assign(submeshes.owner.size(), no_id);
    submeshes.seams.clear();
    for (const auto& submesh : submeshes.list) {
        merge_vertices(submeshes, *submesh);
        merge_triangles(submeshes, *submesh);
    }
    close_seams(submeshes);
    // K <- K': from here on nothing throws.
    mesh.vertices.swap(fresh.vertices);
    mesh.triangles.swap(fresh.triangles);
    for (std::size_t i = 0; i < mesh.attributes.list().size(); ++i) {
        mesh.attributes.list()[i]->swap_entries(*fresh.attributes.list()[i]);
    }
    copying::count_entries(mesh);
    mesh.ids.vertices.clear();
    mesh.ids.triangles.clear();
}

template void merge_submeshes(CopiedSubmeshes<double>&, Complex<double>&);
template void merge_submeshes(CopiedSubmeshes<float>&, Complex<float>&);

} // namespace dsc
