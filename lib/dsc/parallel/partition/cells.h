// SPDX-License-Identifier: MIT
// Cells that follow the interface: the plane is halved repeatedly, each time where few interface
// vertices lie, until each cell has its share of them. What lies near the cuts goes to cells of a
// second colour, cut in the same way from these vertices alone, so that its cuts run where the
// first colour left nothing; what lies near the cuts of both goes to a third. The work is at the
// interface, and so are the cells, whereas slabs over the whole mesh (thesis, section 6.3) are
// mostly empty.
#pragma once

#include "dsc/parallel/partition/partition.h"

namespace dsc {

/// How cells are cut.
struct CellOptions {
    /// Cells of the first colour; 0: as many as pay off, by the length of the interface. Fewer if
    /// they would be too small.
    std::uint32_t submeshes = 0;
    std::uint32_t least_vertices = 20; ///< smaller cells are not worth their boundaries
    double least_width = 6;            ///< in edge lengths
    double band = 4;          ///< in edge lengths: vertices nearer to a cut go to the second colour
    std::uint32_t recut = 32; ///< steps between two divisions of the first colour
    std::uint32_t recut_later = 16; ///< and of the later ones
};

/// A place where there is work.
struct Site {
    double x; ///< in units of the domain
    double y;
    float weight; ///< its share of the work, in any unit
};

/// How boxes of sites are cut.
struct CutRules {
    double band = 0;               ///< a site nearer to a cut than this is done by two colours
    double least_width = 0;        ///< of the sites' extent, on either side of a cut
    std::uint32_t least_sites = 1; ///< on either side
    double tolerance = 0.12;       ///< a share may be off by this fraction of the whole
    double band_price = 2; ///< cost of a site in the band, compared with one that is off balance
};

/// Halves the plane and its sites until there are `cells` boxes, or until the rules allow no
/// further cut. Each cut runs where it costs least: few sites in its band, shares nearly equal.
/// Deterministic. O(n log n + n log(cells)); reorders the sites.
std::vector<Region> divide_sites(std::vector<Site>& sites, std::uint32_t cells,
                                 const CutRules& rules);

/// Cells of equal shares of the interface's work.
template <class Real>
class CellPartitioner final : public Partitioner<Real> {
public:
    /// Throws InputError if the options make no sense.
    explicit CellPartitioner(const CellOptions& options);
    /// The first colour every `recut` steps, the later ones every `recut_later`.
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;

private:
    CellOptions options_;
    std::vector<Site> sites_;
};

} // namespace dsc
