// SPDX-License-Identifier: MIT
// Cells that follow the interface: the plane is halved again and again, each time where few
// interface vertices lie, until each cell has its share of them. What lies near the cuts goes to
// cells of a second colour, cut in the same way from these vertices alone, so that its cuts run
// where the first colour has nothing left over. The work is at the interface, and so are the cells:
// slabs over the whole mesh [6.3] leave most of theirs empty.
#pragma once

#include "dsc/parallel/partition.h"

namespace dsc {

struct CellOptions {
    /// Cells of the first colour; 0: as many as there are `vertices_per_cell`. Fewer where they
    /// would be too small.
    std::uint32_t submeshes = 0;
    std::uint32_t vertices_per_cell = 40; ///< interface vertices, where `submeshes` is 0
    std::uint32_t least_vertices = 20;    ///< smaller cells do not pay for their boundaries
    double least_width = 6;               ///< in edge lengths
    double band = 4;                      ///< in edge lengths: nearer to a cut is the second colour's
    std::uint32_t recut = 64;             ///< steps between two divisions of the first colour
    std::uint32_t recut_later = 8;        ///< and of the second
};

/// A box of the plane, and the vertices in it.
struct CellTree {
    struct Site {
        double x;
        double y;
        float weight;
    };
    /// Halves `box` and its sites until there are `cells` of them, or they get too small; appends
    /// the boxes. Cuts where the fewest sites lie within `band` of the cut, for shares that are
    /// nearly equal. O(n log n) for each level; reorders the sites.
    static void divide(std::span<Site> sites, const Region& box, std::uint32_t cells, double band,
                       double least_width, std::uint32_t least_sites,
                       std::vector<Region>& boxes);
};

template <class Real>
class CellPartitioner final : public Partitioner<Real> {
public:
    /// Throws InputError where the options make no sense.
    explicit CellPartitioner(const CellOptions& options);
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;

private:
    CellOptions options_;
    std::vector<CellTree::Site> sites_;
};

} // namespace dsc
