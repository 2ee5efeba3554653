// SPDX-License-Identifier: MIT
// Histograms of a measure over all triangles or those of one phase, and the distance of two of
// them: section 9.8 of the thesis shows such histograms as pictures.
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace dsc::scenes {

/// Bin i holds the values from edges[i] to edges[i + 1], without the upper end except in the last
/// bin.
struct Histogram {
    std::vector<double> edges;         ///< ascending, one more than there are bins
    std::vector<std::uint64_t> counts; ///< one per bin

    /// The sum of the counts. O(bins).
    [[nodiscard]] std::uint64_t total() const;
};

/// What is counted, and into which bins.
struct HistogramOptions {
    std::size_t bins = 50; ///< how many, of equal width
    /// In the measure's own unit. Values beyond an end are counted in the bin at that end.
    double low = 0;
    /// Empty: the largest value that occurs (area), 1 (quality), 60 degrees (smallest angle). Two
    /// histograms are comparable only over the same bins.
    std::optional<double> high{};
    std::optional<Phase> phase{}; ///< empty: all phases
};

/// `bins` + 1 equidistant edges. Throws InputError where there is no bin, an end is not finite, or
/// the range is too small for that many bins.
[[nodiscard]] std::vector<double> uniform_edges(double low, double high, std::size_t bins);

/// Counts values into bins. Throws InputError where the edges do not ascend or a value is NaN.
/// O(n log bins).
[[nodiscard]] Histogram make_histogram(std::span<const double> values, std::vector<double> edges);

/// The histogram of the areas of the living triangles. O(n log bins). Throws InputError as
/// `uniform_edges` does; so do the next two.
template <class Real>
[[nodiscard]] Histogram area_histogram(const Complex<Real>& complex,
                                       const HistogramOptions& options = {});
/// The same, of the quality (equation 4).
template <class Real>
[[nodiscard]] Histogram quality_histogram(const Complex<Real>& complex,
                                          const HistogramOptions& options = {});
/// The same, of the smallest angles, in degrees.
template <class Real>
[[nodiscard]] Histogram min_angle_histogram(const Complex<Real>& complex,
                                            const HistogramOptions& options = {});

/// The two-sample statistic of Kolmogorov and Smirnov over the bins: the largest difference between
/// the two cumulative distributions, from 0 (alike) to 1 (apart).
/// Throws InputError where the bins differ or one of the histograms is empty.
[[nodiscard]] double histogram_distance(const Histogram& a, const Histogram& b);

} // namespace dsc::scenes
