// SPDX-License-Identifier: MIT
#include "dsc3/complex/complex.h"
#include "dsc3/queries/validate.h"

#include <algorithm>

namespace dsc3 {

namespace {

// Copies records without padding as they are in memory. This is safe for Eigen's points, although
// the compiler cannot know it.
template <class Record>
void transfer_records(dsc::Archive& archive, std::vector<Record>& list) {
    const std::uint64_t count = archive.length(list.size(), sizeof(Record));
    if (archive.is_reading()) {
        list.resize(count);
    }
    if (count > 0) {
        archive.raw(list.data(), count * sizeof(Record));
    }
}

// Checks that each dead id is listed once: `validate` only counts them.
template <class IsDead>
void expect_free(const dsc::Archive& archive, std::vector<std::uint32_t> ids, IsDead is_dead) {
    std::sort(ids.begin(), ids.end());
    archive.expect(std::adjacent_find(ids.begin(), ids.end()) == ids.end() &&
                       std::all_of(ids.begin(), ids.end(), is_dead),
                   "lists an id as free that is in use, or lists it twice");
}

void transfer(dsc::Archive& archive, Complex& complex) {
    transfer_records(archive, complex.vertices);
    transfer_records(archive, complex.tets);
    archive(complex.phases, complex.free_vertices, complex.free_tets);
    archive.expect(!complex.tets.empty() && complex.tets.size() <= dsc::triangle_limit &&
                       complex.vertices.size() < no_id,
                   "holds no complex");
    complex.attributes.archive(archive);
}

} // namespace

void archive(dsc::Archive& archive, Complex& complex) {
    if (!archive.is_reading()) {
        transfer(archive, complex);
        return;
    }
    Complex next;
    next.attributes = complex.attributes.without_entries();
    transfer(archive, next);
    expect_free(archive, next.free_vertices, [&](std::uint32_t v) {
        return v < next.vertices.size() && (next.vertices[v].flags & vertex_dead) != 0;
    });
    expect_free(archive, next.free_tets, [&](std::uint32_t t) {
        return t != border_tet && t < next.tets.size() && next.tets[t].v[0] == no_id;
    });
    if (const ValidationReport report = validate(next); !report.ok()) {
        archive.refuse("holds no valid complex: " + report.problem);
    }
    complex.vertices.swap(next.vertices);
    complex.tets.swap(next.tets);
    complex.phases.swap(next.phases);
    complex.free_vertices.swap(next.free_vertices);
    complex.free_tets.swap(next.free_tets);
    complex.attributes.swap_entries(next.attributes);
    ++complex.version;
}

} // namespace dsc3
