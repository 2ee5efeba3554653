// SPDX-License-Identifier: MIT
// Archives the state that the executor keeps between steps: the partition, the time when it was
// made, and each submesh with its list and active set.
#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/parallel/in_place/submesh_part.h"

#include <algorithm>

namespace dsc {

void archive(Archive& archive, Region& region) {
    if (region.kind != Region::Kind::whole && region.kind != Region::Kind::box) {
        throw InputError(
            {.what = "cannot archive a partition whose regions are given by a function",
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
    archive.expect(is_whole, "partition without submeshes");
}

template <class Real>
void SubmeshExecutor<Real>::archive(Archive& archive) {
    Executor<Real>::archive(archive);
    archive(partition_, status_);
    partitioner_->archive(archive);
    bool lends = has_pools(); // the ids themselves are part of the complex
    archive(lends);
    if (archive.is_reading()) {
        parts_.clear(); // the ids lent to them belong to the complex that was replaced
        generation_ = lends ? complex_.ids.generation : 0;
        make_parts(Recut::all);
        connect();
    }
    for (const auto& part : parts_) {
        archive(part->work, part->examined);
    }
}

template void SubmeshExecutor<double>::archive(Archive&);
template void SubmeshExecutor<float>::archive(Archive&);

} // namespace dsc
