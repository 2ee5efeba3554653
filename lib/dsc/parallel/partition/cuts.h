// SPDX-License-Identifier: MIT
// Halving boxes of sites.
#pragma once

#include "dsc/parallel/partition/partition.h"

namespace dsc {

/// The rules by which boxes of sites are cut.
struct CutRules {
    double band = 0;             ///< a site nearer to a cut than this is handled by two colours
    double min_width = 0;        ///< of the sites' extent, on either side of a cut
    std::uint32_t min_sites = 1; ///< on either side
    double tolerance = 0.12;     ///< a share may be off by this fraction of the whole
    double band_price = 2;       ///< cost of a site in the band, relative to one out of balance
};

/// Halves the plane and its sites until there are `cells` boxes, or until the rules allow no
/// further cut. Each cut runs where it costs least: few sites in its band, shares nearly equal.
/// Deterministic. O(n log n + n log(cells)); reorders the sites.
std::vector<Region> divide_sites(std::vector<Site>& sites, std::uint32_t cells,
                                 const CutRules& rules);

} // namespace dsc
