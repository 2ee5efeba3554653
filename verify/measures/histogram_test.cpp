// SPDX-License-Identifier: MIT
// Histograms and their distance, against values computed by hand.
#include "measures/histogram.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::histogram_test {
namespace {

using namespace scenes;

TEST(Histograms, PutValuesIntoBins) {
    const std::vector<double> values{-5, 0, 0.1, 0.25, 0.4999, 0.5, 0.75, 1, 99};
    const Histogram h = make_histogram(values, 0, 1, 4);
    EXPECT_EQ(h.edges, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(h.counts, (std::vector<std::uint64_t>{3, 2, 1, 3}));
    EXPECT_EQ(make_histogram(values, 0, 1, 1).counts, (std::vector<std::uint64_t>{9}));
}

TEST(Histograms, DistanceIsTheLargestDifferenceOfDistributions) {
    const auto h = [](std::vector<std::uint64_t> counts) {
        return Histogram{make_histogram({}, 0, 1, counts.size()).edges, counts};
    };
    EXPECT_EQ(histogram_distance(h({1, 2, 1}), h({2, 4, 2})), 0);
    EXPECT_EQ(histogram_distance(h({4, 0, 0}), h({0, 0, 7})), 1);
    EXPECT_DOUBLE_EQ(histogram_distance(h({1, 1, 2}), h({2, 1, 1})), 0.25);
    EXPECT_DOUBLE_EQ(histogram_distance(h({3, 0, 1}), h({1, 2, 1})), 0.5);
    EXPECT_THROW((void)histogram_distance(h({1, 2}), h({1, 2, 3})), InputError);
    EXPECT_THROW((void)histogram_distance(h({0, 0}), h({1, 2})), InputError);
}

TEST(Histograms, MedianIsInterpolatedInItsBin) {
    const auto median_of = [](std::vector<std::uint64_t> counts) {
        return median({make_histogram({}, 0, 4, counts.size()).edges, counts});
    };
    EXPECT_DOUBLE_EQ(median_of({0, 4, 0, 0}), 1.5);
    EXPECT_DOUBLE_EQ(median_of({2, 0, 1, 1}), 1);
    EXPECT_DOUBLE_EQ(median_of({1, 0, 0, 4}), 3.375);
    EXPECT_THROW((void)median_of({0, 0}), InputError);
}

} // namespace
} // namespace dsc::histogram_test
