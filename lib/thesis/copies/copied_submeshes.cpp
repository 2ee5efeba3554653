// SPDX-License-Identifier: MIT
#include "thesis/copies/copied_submeshes.h"

#include "thesis/copies/copying.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc {

using copying::append_triangles;
using copying::clear;

namespace {

// --- algorithm 6.1: which triangle goes where ---------------------------------------------------

template <class Real>
void find_keys(const Complex<Real>& mesh, const CountingDivision& division,
               CopiedSubmeshes<Real>& submeshes) {
    auto& keys = submeshes.keys;
    keys.clear();
    keys.reserve(mesh.triangle_count());
    for (const Triangle t : triangles(mesh)) {
        double x = 0;
        double y = 0;
        for (const std::uint32_t v : mesh.triangles[t.id].v) {
            x += static_cast<double>(mesh.vertices[v].x);
            y += static_cast<double>(mesh.vertices[v].y);
        }
        keys.push_back({division.normal_x * x + division.normal_y * y, t.id});
    }
}

// Finds where the shares end. The printed bounds of the black ones leave out k triangles after the
// first half share; the text and figure 6.2b show the intention: the red bounds, shifted by half a
// share.
void find_cuts(std::size_t triangles, const CountingDivision& division,
               std::vector<std::size_t>& cuts) {
    const std::size_t n = division.submeshes;
    const std::size_t share = triangles / n;
    const std::size_t more = triangles % n; // the first `more` shares have one triangle more
    const std::size_t shift = division.colour == RedBlack::black ? share / 2 : 0;
    cuts.assign(1, 0);
    for (std::size_t i = shift == 0 ? 1 : 0; i < n; ++i) {
        cuts.push_back(shift + i * share + std::min(i, more));
    }
    cuts.push_back(triangles);
}

// Sorts only as far as needed for the cuts first to last - 1: each element ends in its share.
template <class Key>
void sort_into_shares(std::vector<Key>& keys, const std::vector<std::size_t>& cuts,
                      std::size_t first, std::size_t last) {
    if (last - first < 2) {
        return;
    }
    const auto at = [&](std::size_t cut) {
        return keys.begin() + static_cast<std::ptrdiff_t>(cuts[cut]);
    };
    const std::size_t middle = first + (last - first) / 2;
    if (cuts[middle] < cuts[last]) {
        std::nth_element(at(first), at(middle), at(last), [](const Key& a, const Key& b) {
            return a.place != b.place ? a.place < b.place : a.triangle < b.triangle;
        });
    }
    sort_into_shares(keys, cuts, first, middle);
    sort_into_shares(keys, cuts, middle, last);
}

// N, and for each vertex whether it is on a submesh boundary.
template <class Real>
void number_simplices(const Complex<Real>& mesh, const CountingDivision& division,
                      CopiedSubmeshes<Real>& submeshes) {
    find_keys(mesh, division, submeshes);
    const auto& keys = submeshes.keys;
    const auto& cuts = submeshes.cuts;
    find_cuts(keys.size(), division, submeshes.cuts);
    sort_into_shares(submeshes.keys, cuts, 0, cuts.size() - 1);
    submeshes.number.assign(mesh.triangle_bound(), no_id);
    for (std::size_t share = 0; share + 1 < cuts.size(); ++share) {
        // The first and the last black share form one submesh (thesis, section 8.5).
        const auto number = static_cast<std::uint32_t>(share % division.submeshes);
        for (std::size_t i = cuts[share]; i < cuts[share + 1]; ++i) {
            submeshes.number[keys[i].triangle] = number;
        }
    }
    submeshes.owner.assign(mesh.vertex_bound(), no_id);
    for (std::uint32_t t = 1; t < mesh.triangle_bound(); ++t) {
        if (submeshes.number[t] == no_id) {
            continue;
        }
        for (const std::uint32_t v : mesh.triangles[t].v) {
            std::uint32_t& owner = submeshes.owner[v];
            if (owner == no_id) {
                owner = submeshes.number[t];
            } else if (owner != submeshes.number[t]) {
                owner = CopiedSubmeshes<Real>::several;
            }
        }
    }
}

// The triangles submesh by submesh, and within each by their ids in the mesh, so that neighbours in
// memory stay neighbours. Afterwards submesh i ends at cuts[i].
template <class Real>
void bucket_triangles(CopiedSubmeshes<Real>& submeshes) {
    auto& ends = submeshes.cuts;
    ends.assign(submeshes.list.size() + 1, 0);
    for (const std::uint32_t i : submeshes.number) {
        if (i != no_id) {
            ++ends[i + 1];
        }
    }
    for (std::size_t i = 1; i < ends.size(); ++i) {
        ends[i] += ends[i - 1];
    }
    submeshes.by_submesh.resize(ends.back());
    submeshes.local_triangle.assign(submeshes.number.size(), border_triangle);
    auto& begins = submeshes.begins;
    begins = ends;
    for (std::uint32_t t = 1; t < submeshes.number.size(); ++t) {
        const std::uint32_t i = submeshes.number[t];
        if (i != no_id) {
            submeshes.by_submesh[ends[i]] = t;
            submeshes.local_triangle[t] = static_cast<std::uint32_t>(++ends[i] - begins[i]);
        }
    }
}

// --- algorithm 6.1: copies ----------------------------------------------------------------------

// Inserts the vertices of the triangles. O.order: the vertices that they are copies of.
template <class Real>
void insert_vertices(const Complex<Real>& mesh, std::span<const std::uint32_t> triangles,
                     CopiedSubmeshes<Real>& submeshes, CopiedSubmesh<Real>& submesh) {
    auto& complex = submesh.complex;
    submeshes.order.clear();
    submesh.shared.clear();
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t v : mesh.triangles[t].v) {
            if (submeshes.local[v] != no_id) {
                continue;
            }
            submeshes.local[v] = complex.vertex_bound();
            submeshes.order.push_back(v);
            const auto& record = mesh.vertices[v];
            complex.vertices.push_back({record.x, record.y, no_id, record.flags, 0, no_id});
            const bool is_shared = submeshes.owner[v] == CopiedSubmeshes<Real>::several;
            submesh.shared.push_back(is_shared ? v : no_id);
        }
    }
    copying::append(complex.attributes, SimplexKind::vertex, mesh.attributes, submeshes.order);
}

template <class Real>
void insert_triangles(const Complex<Real>& mesh, std::span<const std::uint32_t> triangles,
                      CopiedSubmeshes<Real>& submeshes, CopiedSubmesh<Real>& submesh) {
    auto& complex = submesh.complex;
    submeshes.order.assign(1, border_triangle);
    for (const std::uint32_t t : triangles) {
        const TriangleRecord& record = mesh.triangles[t];
        TriangleRecord copy{{}, {}, record.phase, 0};
        const std::uint32_t id = complex.triangle_bound();
        for (std::uint32_t i = 0; i < 3; ++i) {
            copy.v[i] = submeshes.local[record.v[i]];
            complex.vertices[copy.v[i]].corner = corner_of(id, i);
            const Corner across = record.n[i];
            const std::uint32_t beyond = triangle_of(across);
            const bool is_inside =
                !is_border(across) && submeshes.number[beyond] == submeshes.number[t];
            copy.n[i] = is_inside ? corner_of(submeshes.local_triangle[beyond], index_of(across))
                                  : border_corner;
        }
        complex.triangles.push_back(copy);
        submeshes.order.push_back(t);
    }
    append_triangles(complex.attributes, mesh.attributes, submeshes.order, submeshes.corner_order);
}

// --- algorithm 6.2 ------------------------------------------------------------------------------

} // namespace

void check_division(const CountingDivision& division) {
    require(division.submeshes >= 1 && division.submeshes <= 65536, "submeshes", division.submeshes,
            "1 to 65536");
    const double norm = std::hypot(division.normal_x, division.normal_y);
    require(std::abs(norm - 1) < 1e-9, "normal", norm, "a direction of length 1");
}

template <class Real>
void create_submeshes(const Complex<Real>& mesh, const CountingDivision& division,
                      CopiedSubmeshes<Real>& submeshes) {
    check_division(division);
    submeshes.list.resize(division.submeshes);
    number_simplices(mesh, division, submeshes);
    bucket_triangles(submeshes);
    submeshes.local.assign(mesh.vertex_bound(), no_id);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < submeshes.list.size(); ++i) {
        if (!submeshes.list[i]) {
            submeshes.list[i] = std::make_unique<CopiedSubmesh<Real>>();
        }
        CopiedSubmesh<Real>& submesh = *submeshes.list[i];
        clear(submesh.complex);
        submesh.complex.ids.may_grow = false;
        submesh.complex.attributes = copying::without_entries(mesh.attributes);
        const std::size_t end = submeshes.cuts[i];
        const std::span<const std::uint32_t> triangles =
            std::span(submeshes.by_submesh).subspan(begin, end - begin);
        submesh.complex.reserve(triangles.size(), triangles.size());
        insert_vertices(mesh, triangles, submeshes, submesh);
        insert_triangles(mesh, triangles, submeshes, submesh);
        copying::count_entries(submesh.complex);
        // The next submesh inserts its own copy of a shared vertex.
        for (const std::uint32_t v : submesh.shared) {
            if (v != no_id) {
                submeshes.local[v] = no_id;
            }
        }
        begin = end;
    }
}

template <class Real>
void lend_ids(CopiedSubmesh<Real>& submesh, std::size_t vertices) {
    auto& complex = submesh.complex;
    const std::uint32_t first_vertex = complex.vertex_bound();
    const std::uint32_t first_triangle = complex.triangle_bound();
    const auto count = static_cast<std::uint32_t>(vertices);
    complex.vertices.resize(first_vertex + vertices, {0, 0, no_id, vertex_dead, 0, no_id});
    complex.triangles.resize(
        first_triangle + 2 * vertices,
        {{no_id, no_id, no_id}, {border_corner, border_corner, border_corner}, border_phase, 0});
    submesh.shared.resize(complex.vertices.size(), no_id);
    copying::count_entries(complex);
    // In descending order: ids are taken from the end of the pool, the lowest first.
    for (std::uint32_t i = count; i > 0; --i) {
        complex.ids.vertices.push_back(first_vertex + i - 1);
    }
    for (std::uint32_t i = 2 * count; i > 0; --i) {
        complex.ids.triangles.push_back(first_triangle + i - 1);
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void create_submeshes(const Complex<Real>&, const CountingDivision&,                  \
                                   CopiedSubmeshes<Real>&);                                        \
    template void lend_ids(CopiedSubmesh<Real>&, std::size_t);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
