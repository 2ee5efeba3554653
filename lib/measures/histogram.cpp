// SPDX-License-Identifier: MIT
#include "measures/histogram.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

namespace dsc::scenes {

namespace {

template <class Real, class Measure>
std::vector<double> collect(const Complex<Real>& complex, std::optional<Phase> phase,
                            Measure measure) {
    std::vector<double> values;
    for (const Triangle t : triangles(complex)) {
        if (!phase || complex.phase(t) == *phase) {
            values.push_back(static_cast<double>(measure(t)));
        }
    }
    return values;
}

} // namespace

std::uint64_t Histogram::total() const {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::vector<double> uniform_edges(double low, double high, std::size_t bins) {
    if (bins == 0) {
        throw InputError(
            {.what = "no bins", .where = "uniform_edges", .value = "0", .allowed = "1 or more"});
    }
    std::vector<double> edges;
    edges.reserve(bins + 1);
    for (std::size_t i = 0; i <= bins; ++i) {
        const double fraction = static_cast<double>(i) / static_cast<double>(bins);
        edges.push_back(low * (1 - fraction) + high * fraction);
    }
    if (!std::isfinite(low) || !std::isfinite(high) ||
        std::adjacent_find(edges.begin(), edges.end(), std::greater_equal<>()) != edges.end()) {
        throw InputError({.what = "no range for " + std::to_string(bins) + " bins",
                          .where = "uniform_edges",
                          .value = std::to_string(low) + " to " + std::to_string(high),
                          .allowed = "finite ends, the second larger"});
    }
    return edges;
}

Histogram make_histogram(std::span<const double> values, std::vector<double> edges) {
    const bool ascending = std::adjacent_find(edges.begin(), edges.end(), [](double a, double b) {
                               return !(a < b);
                           }) == edges.end();
    if (edges.size() < 2 || !ascending) {
        throw InputError({.what = "edges do not ascend",
                          .where = "make_histogram",
                          .value = std::to_string(edges.size()) + " edges",
                          .allowed = "two or more, each larger than the one before"});
    }
    Histogram histogram{std::move(edges), {}};
    const std::size_t bins = histogram.edges.size() - 1;
    histogram.counts.assign(bins, 0);
    for (const double value : values) {
        if (std::isnan(value)) {
            throw InputError({.what = "a value is not a number",
                              .where = "make_histogram",
                              .value = "nan",
                              .allowed = "numbers"});
        }
        // Only the inner edges: a value beyond an end goes to the bin at that end.
        const auto inner = histogram.edges.begin() + 1;
        const auto place = std::upper_bound(inner, histogram.edges.end() - 1, value) - inner;
        ++histogram.counts[static_cast<std::size_t>(place)];
    }
    return histogram;
}

template <class Real>
Histogram area_histogram(const Complex<Real>& complex, const HistogramOptions& options) {
    const auto values =
        collect(complex, options.phase, [&](Triangle t) { return area(complex, t); });
    double high = 0;
    if (options.high) {
        high = *options.high;
    } else if (!values.empty()) {
        high = *std::max_element(values.begin(), values.end());
    }
    return make_histogram(values, uniform_edges(options.low, high, options.bins));
}

template <class Real>
Histogram quality_histogram(const Complex<Real>& complex, const HistogramOptions& options) {
    return make_histogram(
        collect(complex, options.phase, [&](Triangle t) { return quality(complex, t); }),
        uniform_edges(options.low, options.high.value_or(1), options.bins));
}

template <class Real>
Histogram min_angle_histogram(const Complex<Real>& complex, const HistogramOptions& options) {
    return make_histogram(
        collect(complex, options.phase, [&](Triangle t) { return min_angle_deg(complex, t); }),
        uniform_edges(options.low, options.high.value_or(60), options.bins));
}

double histogram_distance(const Histogram& a, const Histogram& b) {
    if (a.edges != b.edges) {
        throw InputError({.what = "the bins differ",
                          .where = "histogram_distance",
                          .value = std::to_string(a.counts.size()) + " and " +
                                   std::to_string(b.counts.size()) + " bins",
                          .allowed = "two histograms over the same edges"});
    }
    const auto total_a = static_cast<double>(a.total());
    const auto total_b = static_cast<double>(b.total());
    if (!(total_a > 0) || !(total_b > 0)) {
        throw InputError(
            {.what = "a histogram is empty",
             .where = "histogram_distance",
             .value = std::to_string(a.total()) + " and " + std::to_string(b.total()) + " values",
             .allowed = "one or more in each"});
    }
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

#define DSC_INSTANTIATE(Real)                                                                      \
    template Histogram area_histogram(const Complex<Real>&, const HistogramOptions&);              \
    template Histogram quality_histogram(const Complex<Real>&, const HistogramOptions&);           \
    template Histogram min_angle_histogram(const Complex<Real>&, const HistogramOptions&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
