// SPDX-License-Identifier: MIT
// The mesh cut in two directions (thesis, section 6). With two colours, the points where a cut of
// one family crosses one of the other would always be locked by one colour or the other; blocks
// take three colours, each shifted by a third, and no point lies near the boundaries of all three.
#pragma once

#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"

namespace dsc {

/// How blocks are cut.
struct BlockOptions {
    std::uint32_t submeshes = 16; ///< of the first colour; rounded down to a square number
    double min_width = 8;         ///< in edge lengths
    std::uint32_t recut = 64;     ///< steps between two choices of the cuts
};

/// Blocks of equal width in both directions, over the extent of the interface.
template <class Real>
class BlockPartitioner final : public Partitioner<Real> {
public:
    /// Throws InputError if an option is out of range.
    explicit BlockPartitioner(const BlockOptions& options);
    /// All colours every `recut` steps.
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;

private:
    BlockOptions options_;
};

/// Blocks: `Parallel{.division = &blocks_division}`.
extern const Division blocks_division;

} // namespace dsc
