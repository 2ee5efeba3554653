// SPDX-License-Identifier: MIT
#include "measures/histogram.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dsc::scenes {

Histogram make_histogram(std::span<const double> values, double low, double high,
                         std::size_t bins) {
    Histogram histogram;
    histogram.counts.assign(bins, 0);
    for (std::size_t i = 0; i <= bins; ++i) {
        const double fraction = static_cast<double>(i) / static_cast<double>(bins);
        histogram.edges.push_back(low * (1 - fraction) + high * fraction);
    }
    for (const double value : values) {
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
    const double total_a = std::accumulate(a.counts.begin(), a.counts.end(), 0.0);
    const double total_b = std::accumulate(b.counts.begin(), b.counts.end(), 0.0);
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

double median(const Histogram& histogram) {
    const double total = std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0.0);
    require(total > 0, "values in a histogram", 0, "1 or more");
    double rest = total / 2;
    std::size_t bin = 0;
    while (static_cast<double>(histogram.counts[bin]) < rest) {
        rest -= static_cast<double>(histogram.counts[bin++]);
    }
    const double low = histogram.edges[bin];
    return low +
           (histogram.edges[bin + 1] - low) * rest / static_cast<double>(histogram.counts[bin]);
}

} // namespace dsc::scenes
