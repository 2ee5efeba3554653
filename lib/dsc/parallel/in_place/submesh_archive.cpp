// SPDX-License-Identifier: MIT
// What the executor carries from one step to the next: the partition, when it was made, and each
// submesh with its list, its active set and the ids that it holds.
#include "dsc/parallel/in_place/submesh_part.h"
#include "dsc/parallel/partition/partition.h"
#include "dsc/passes/algorithm.h"

namespace dsc {

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
