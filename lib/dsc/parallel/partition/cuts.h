// SPDX-License-Identifier: MIT
// Where to cut: into slabs of equal share or width, and through boxes of sites.
#pragma once

#include "dsc/parallel/partition/partition.h"

namespace dsc {

/// Cuts along a direction: slab i is [cuts[i], cuts[i + 1]); the outer cuts are infinite.
struct Cuts {
    std::vector<double> red;   ///< of the first colour
    std::vector<double> black; ///< in the middle of the red slabs, by the same measure
};

/// Cuts such that each slab holds the same share of the weight, none thinner than `least_width`.
/// Reorders the positions, each a pair of place and weight. O(n log n).
Cuts cuts_of_equal_share(std::vector<std::pair<double, float>>& positions, std::uint32_t slabs,
                         double least_width);

/// Cuts of equal width over [low, high].
Cuts cuts_of_equal_width(double low, double high, std::uint32_t slabs, double least_width);

/// The unit vector along which points scatter most (first principal component). O(n).
template <class Real>
Point<double> principal_direction(const Complex<Real>& complex,
                                  std::span<const std::uint32_t> vertices);

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

} // namespace dsc
