// SPDX-License-Identifier: MIT
// Histograms, and their distance, by hand.
#include "measures/histogram.h"

#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::histogram_test {
namespace {

using namespace scenes;
using test::grid;

template <class Real>
class HistogramsOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(HistogramsOf, Reals);

TEST(Histograms, PutValuesIntoBins) {
    const std::vector<double> values{-5, 0, 0.1, 0.25, 0.4999, 0.5, 0.75, 1, 99};
    const Histogram h = make_histogram(values, uniform_edges(0, 1, 4));
    EXPECT_EQ(h.edges, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(h.counts, (std::vector<std::uint64_t>{3, 2, 1, 3}));
    EXPECT_EQ(h.total(), values.size());
    EXPECT_EQ(make_histogram(values, {0, 1}).counts, (std::vector<std::uint64_t>{9}));
}

TEST(Histograms, RefuseBadBins) {
    const std::vector<double> values{1};
    const double nan = std::nan("");
    EXPECT_THROW((void)uniform_edges(0, 1, 0), InputError);
    EXPECT_THROW((void)uniform_edges(1, 1, 3), InputError);
    EXPECT_THROW((void)uniform_edges(2, 1, 3), InputError);
    EXPECT_THROW((void)uniform_edges(nan, 1, 3), InputError);
    EXPECT_THROW((void)uniform_edges(0, INFINITY, 3), InputError);
    EXPECT_THROW((void)make_histogram(values, {0}), InputError);
    EXPECT_THROW((void)make_histogram(values, {0, 0, 1}), InputError);
    EXPECT_THROW((void)make_histogram(values, {0, nan, 1}), InputError);
    EXPECT_THROW((void)make_histogram(std::vector<double>{nan}, {0, 1}), InputError);
}

TEST(Histograms, DistanceIsTheLargestDifferenceOfDistributions) {
    const auto h = [](std::vector<std::uint64_t> counts) {
        return Histogram{uniform_edges(0, 1, counts.size()), counts};
    };
    EXPECT_EQ(histogram_distance(h({1, 2, 1}), h({2, 4, 2})), 0);
    EXPECT_EQ(histogram_distance(h({4, 0, 0}), h({0, 0, 7})), 1);
    EXPECT_DOUBLE_EQ(histogram_distance(h({1, 1, 2}), h({2, 1, 1})), 0.25);
    EXPECT_DOUBLE_EQ(histogram_distance(h({3, 0, 1}), h({1, 2, 1})), 0.5);
    EXPECT_THROW((void)histogram_distance(h({1, 2}), h({1, 2, 3})), InputError);
    EXPECT_THROW((void)histogram_distance(h({0, 0}), h({1, 2})), InputError);
}

TYPED_TEST(HistogramsOf, AMesh) {
    const auto complex = grid<TypeParam>(10, 0.15, 3, 3);
    const HistogramOptions inside{.bins = 10, .phase = 1};
    const HistogramOptions outside{.bins = 10, .phase = 0};
    for (const auto& histogram : {area_histogram<TypeParam>, quality_histogram<TypeParam>,
                                  min_angle_histogram<TypeParam>}) {
        const Histogram all = histogram(complex, {.bins = 10, .high = 60.0});
        const Histogram in = histogram(complex, {.bins = 10, .high = 60.0, .phase = 1});
        const Histogram out = histogram(complex, {.bins = 10, .high = 60.0, .phase = 0});
        EXPECT_EQ(all.total(), 200U);
        EXPECT_GT(in.total(), 20U);
        for (std::size_t i = 0; i < 10; ++i) {
            EXPECT_EQ(all.counts[i], in.counts[i] + out.counts[i]);
        }
    }
    EXPECT_EQ(quality_histogram(complex, inside).edges.back(), 1);
    EXPECT_EQ(min_angle_histogram(complex, outside).edges.back(), 60);
    const Histogram areas = area_histogram(complex);
    double largest = 0;
    for (const Triangle t : triangles(complex)) {
        largest = std::max(largest, static_cast<double>(area(complex, t)));
    }
    EXPECT_EQ(areas.edges.back(), largest);
    EXPECT_GT(areas.counts.back(), 0U);
    // The regular grid has one quality alone; the jittered one is spread out.
    const auto regular = quality_histogram(grid<TypeParam>(10), {.bins = 50});
    const auto spread = quality_histogram(complex, {.bins = 50});
    EXPECT_EQ(*std::max_element(regular.counts.begin(), regular.counts.end()), 200U);
    EXPECT_GT(histogram_distance(regular, spread), 0.3);
    EXPECT_EQ(histogram_distance(spread, spread), 0);
}

} // namespace
} // namespace dsc::histogram_test
