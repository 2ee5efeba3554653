// SPDX-License-Identifier: MIT
#include "dsc/parallel/partition/partition.h"

#include "dsc/base/error.h"

#include <algorithm>

namespace dsc {

void archive(Archive& archive, Region& region) {
    if (region.kind != Region::Kind::whole && region.kind != Region::Kind::box) {
        throw InputError({.what = "a partition by a function cannot be part of a checkpoint",
                          .where = "archive",
                          .value = "a region of places or labels",
                          .allowed = "slabs, blocks and cells"});
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

} // namespace dsc
