// SPDX-License-Identifier: MIT
// Blocks: the mesh cut in two directions [6]. With two colours the points where both families of
// cuts cross would stay locked in one or the other for ever; blocks take three, each shifted by a
// third, and no point lies near the boundaries of all three.
#pragma once

#include "dsc/parallel/partition/partition.h"

namespace dsc {

struct BlockOptions {
    std::uint32_t submeshes = 16; ///< of the first colour, about: the next square below
    double least_width = 8;       ///< in edge lengths
    std::uint32_t recut = 64;     ///< steps between two choices of the cuts
};

template <class Real>
class BlockPartitioner final : public Partitioner<Real> {
public:
    /// Throws InputError where the options make no sense.
    explicit BlockPartitioner(const BlockOptions& options);
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;

private:
    BlockOptions options_;
};

} // namespace dsc
