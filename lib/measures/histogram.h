// SPDX-License-Identifier: MIT
// Histograms of a measure over triangles, as in section 9.8 of the thesis, and the distance of two
// histograms.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dsc::scenes {

/// Bin i holds the values from edges[i] to edges[i + 1], without the upper end except in the last
/// bin.
struct Histogram {
    std::vector<double> edges;         ///< ascending, one more than there are bins
    std::vector<std::uint64_t> counts; ///< one per bin
};

/// Counts values into bins of equal width; those beyond an end are counted in the bin at that end.
/// O(n log bins).
[[nodiscard]] Histogram make_histogram(std::span<const double> values, double low, double high,
                                       std::size_t bins);

/// The two-sample statistic of Kolmogorov and Smirnov over the bins: the largest difference between
/// the two cumulative distributions, from 0 (equal) to 1 (disjoint). Throws InputError where the
/// bins differ or one of the histograms is empty.
[[nodiscard]] double histogram_distance(const Histogram& a, const Histogram& b);

/// The median of the binned values, interpolated linearly in its bin. Throws InputError if the
/// histogram is empty.
[[nodiscard]] double median(const Histogram& histogram);

} // namespace dsc::scenes
