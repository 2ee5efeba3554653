// SPDX-License-Identifier: MIT
// The archive of a complex, which is declared with it but defined here because it calls the
// validator.
#include "dsc/complex/complex.h"
#include "dsc/queries/validate.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dsc {

void archive(Archive& archive, Edit& edit) {
    archive.choice(edit.kind, edit_kind_count);
    archive.choice(edit.reason, 5);
    archive(edit.on_interface, edit.corner, edit.vertex, edit.ends, edit.apexes, edit.made, edit.x,
            edit.y);
}

void archive(Archive& archive, OperationCounts& counts) {
    archive(counts.moves, counts.flips, counts.interface_splits, counts.interface_collapses,
            counts.splits, counts.collapses, counts.smoothed, counts.subdivisions,
            counts.retriangulations, counts.relabelled, counts.examined);
}

void archive(Archive& archive, FreeIds& ids) {
    const std::uint64_t lent = archive.length(ids.lent.size(), 1);
    if (archive.is_reading()) {
        ids.clear();
    }
    archive(ids.vertices, ids.triangles);
    for (std::size_t i = 0; i < lent; ++i) {
        IdPool& pool = ids.lend(i);
        archive(pool.vertices, pool.triangles);
    }
}

namespace {

// The simplices of an edit may have vanished since, but must have existed.
template <class Real>
void expect_edit(const Archive& archive, const Complex<Real>& complex, const Edit& edit) {
    const auto expect = [&](std::uint32_t id, std::uint32_t bound) {
        archive.expect(id == no_id || id < bound, "edit of a simplex that never existed");
    };
    for (const Vertex v :
         {edit.vertex, edit.ends[0], edit.ends[1], edit.apexes[0], edit.apexes[1]}) {
        expect(v.id, complex.vertex_bound());
    }
    expect(edit.corner == no_id ? no_id : triangle_of(edit.corner), complex.triangle_bound());
    if (edit.kind == EditKind::split) {
        expect(edit.made[0], complex.triangle_bound());
        expect(edit.made[1], complex.triangle_bound());
    }
}

} // namespace

template <class Real>
void expect_vertices(const Archive& archive, const Complex<Real>& complex,
                     std::span<const std::uint32_t> list) {
    const bool exist =
        std::ranges::all_of(list, [&](std::uint32_t v) { return v < complex.vertex_bound(); });
    archive.expect(exist, "vertex id out of range");
}

template <class Real>
static void transfer(Archive& archive, Complex<Real>& complex) {
    std::uint32_t size = sizeof(Real);
    archive(size);
    if (size != sizeof(Real)) {
        archive.refuse(size == sizeof(float)    ? "the complex is of float, not of double"
                       : size == sizeof(double) ? "the complex is of double, not of float"
                                                : "the complex is of an unknown scalar type");
    }
    archive.records(complex.vertices);
    archive.records(complex.triangles);
    archive.expect(!complex.triangles.empty() && complex.vertices.size() < no_id &&
                       complex.triangles.size() < triangle_limit,
                   "not a complex");
    archive(complex.ids);
    complex.attributes.archive(archive);
    archive(complex.journal.counts, complex.journal.records);
    for (const Edit& edit : complex.journal.records) {
        expect_edit(archive, complex, edit);
    }
}

template <class Real>
void archive(Archive& archive, Complex<Real>& complex) {
    if (!archive.is_reading()) {
        transfer(archive, complex);
        return;
    }
    Complex<Real> next;
    next.attributes = complex.attributes.without_entries();
    transfer(archive, next);
    if (const ValidationReport report = validate(next); !report.ok()) {
        archive.refuse("invalid complex: " + report.problem);
    }
    complex.vertices.swap(next.vertices);
    complex.triangles.swap(next.triangles);
    complex.ids = std::move(next.ids);
    complex.attributes.swap_entries(next.attributes);
    complex.journal.counts = next.journal.counts;
    complex.journal.records.swap(next.journal.records);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void archive(Archive&, Complex<Real>&);                                               \
    template void expect_vertices(const Archive&, const Complex<Real>&,                            \
                                  std::span<const std::uint32_t>);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
