// SPDX-License-Identifier: MIT
// What the executor carries from one step to the next: the partition, when it was made, and each
// submesh with its list, its active set and the ids that it holds.
#include "dsc/base/error.h"
#include "dsc/parallel/in_place/submesh_part.h"

#include <algorithm>

namespace dsc {

void archive(Archive& archive, Region& region) {
    if (region.kind != Region::Kind::whole && region.kind != Region::Kind::box) {
        throw InputError({.what = "a partition by a function cannot be part of a checkpoint",
                          .where = "archive",
                          .value = "a region of places or labels",
                          .allowed = "boxes, such as cells"});
    }
    archive.choice(region.kind, 2);
    archive(region.normal_x, region.normal_y, region.low, region.high, region.side_low,
            region.side_high, region.label);
}

void archive(Archive& archive, Colour& colour) { archive(colour.regions); }

void archive(Archive& archive, Partition& partition) {
    archive(partition.colours);
    const bool is_whole =
        !partition.colours.empty() &&
        std::ranges::none_of(partition.colours, [](const Colour& c) { return c.regions.empty(); });
    archive.expect(is_whole, "holds a partition without submeshes");
}

template <class Real>
void SubmeshExecutor<Real>::archive(Archive& archive) {
    Executor<Real>::archive(archive);
    archive(partition_, status_);
    partitioner_->archive(archive);
    if (archive.is_reading()) {
        parts_.clear(); // the complex that the ids of their pools belonged to is gone
        make_parts(Recut::all);
        connect();
    }
    for (const auto& part : parts_) {
        archive(part->work, part->pool, part->examined);
    }
    if (archive.is_reading()) {
        expect_pools(archive);
    }
}

// Ids that submeshes hold are free, and each is held by one of them: what `validate` does not know.
template <class Real>
void SubmeshExecutor<Real>::expect_pools(const Archive& archive) const {
    std::vector<std::uint8_t> is_taken_vertex(complex_.vertex_bound(), 0);
    std::vector<std::uint8_t> is_taken_triangle(complex_.triangle_bound(), 0);
    is_taken_triangle[border_triangle] = 1;
    const auto take = [&](const std::vector<std::uint32_t>& ids, auto& is_taken, auto is_alive) {
        for (const std::uint32_t id : ids) {
            archive.expect(id < is_taken.size() && is_taken[id] == 0 && !is_alive(id),
                           "lends an id twice, or one that is in use");
            is_taken[id] = 1;
        }
    };
    const auto take_pool = [&](const IdPool& pool) {
        take(pool.vertices, is_taken_vertex,
             [&](std::uint32_t id) { return complex_.is_alive(Vertex{id}); });
        take(pool.triangles, is_taken_triangle,
             [&](std::uint32_t id) { return complex_.is_alive(Triangle{id}); });
    };
    take_pool(complex_.ids);
    for (const auto& part : parts_) {
        take_pool(part->pool);
    }
}

template void SubmeshExecutor<double>::archive(Archive&);
template void SubmeshExecutor<float>::archive(Archive&);

} // namespace dsc
