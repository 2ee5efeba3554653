// SPDX-License-Identifier: MIT
#include "measures/histogram.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace dsc::scenes {

std::uint64_t Histogram::total() const {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

Histogram make_histogram(std::span<const double> values, double low, double high,
                         std::size_t bins) {
    require(bins > 0, "bins of a histogram", 0, "1 or more");
    Histogram histogram;
    histogram.counts.assign(bins, 0);
    for (std::size_t i = 0; i <= bins; ++i) {
        const double fraction = static_cast<double>(i) / static_cast<double>(bins);
        histogram.edges.push_back(low * (1 - fraction) + high * fraction);
    }
    const bool is_range = std::isfinite(low) && std::isfinite(high) &&
                          std::ranges::adjacent_find(histogram.edges, std::greater_equal<>()) ==
                              histogram.edges.end();
    require(is_range, "upper end of a histogram", high,
            "finite, and above " + to_text(low) + " by more than rounding");
    for (const double value : values) {
        require(!std::isnan(value), "value in a histogram", value, "a number");
        // Only the inner edges: a value beyond an end goes to the bin at that end.
        const auto inner = histogram.edges.begin() + 1;
        const auto place = std::upper_bound(inner, histogram.edges.end() - 1, value) - inner;
        ++histogram.counts[static_cast<std::size_t>(place)];
    }
    return histogram;
}

double histogram_distance(const Histogram& a, const Histogram& b) {
    require(a.edges == b.edges, "bins of the second histogram",
            static_cast<double>(b.counts.size()), "those of the first one");
    const auto total_a = static_cast<double>(a.total());
    const auto total_b = static_cast<double>(b.total());
    require(total_a > 0 && total_b > 0, "values in a histogram", 0, "1 or more");
    std::uint64_t sum_a = 0;
    std::uint64_t sum_b = 0;
    double largest = 0;
    for (std::size_t i = 0; i < a.counts.size(); ++i) {
        sum_a += a.counts[i];
        sum_b += b.counts[i];
        largest = std::max(largest, std::abs(static_cast<double>(sum_a) / total_a -
                                             static_cast<double>(sum_b) / total_b));
    }
    return largest;
}

} // namespace dsc::scenes
