// SPDX-License-Identifier: MIT
// A partition as bytes.
#pragma once

#include "dsc/parallel/partition/partition.h"

namespace dsc {

/// Throws InputError for a region that an application's function or a list of labels defines: there
/// are no bytes for either.
void archive(Archive& archive, Region& region);
void archive(Archive& archive, Partition& partition);

inline void archive(Archive& archive, Colour& colour) { archive(colour.regions); }
inline void archive(Archive& archive, PartitionStatus& status) {
    std::uint64_t vertices = status.interface_vertices;
    archive(status.step, status.steps_since_all, vertices);
    status.interface_vertices = static_cast<std::size_t>(vertices);
}

} // namespace dsc
