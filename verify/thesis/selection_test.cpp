// SPDX-License-Identifier: MIT
// Selection strategies (thesis, section 8.8).
#include "thesis/algorithm/selection.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace dsc::selection_test {
namespace {

template <class Simplex>
std::vector<Simplex> handles(std::size_t count) {
    std::vector<Simplex> list;
    for (std::uint32_t i = 0; i < count; ++i) {
        list.push_back({i});
    }
    return list;
}

template <class Simplex>
class Selecting : public testing::Test {};
using Simplices = testing::Types<Vertex, Edge, Triangle>;
TYPED_TEST_SUITE(Selecting, Simplices);

TYPED_TEST(Selecting, AgreesWithASortedListWhateverTheOrder) {
    std::mt19937 random(8);
    for (int round = 0; round < 50; ++round) {
        auto list = handles<TypeParam>(100);
        std::vector<double> value(100);
        for (double& v : value) {
            v = static_cast<double>(random() % 20);
        } // many ties
        const QualityFunction<TypeParam> quality = [&](TypeParam s) { return value[s.id]; };
        auto expected = list;
        std::stable_sort(expected.begin(), expected.end(),
                         [&](TypeParam a, TypeParam b) { return value[a.id] < value[b.id]; });
        std::shuffle(list.begin(), list.end(), random);
        for (const std::size_t n : {0U, 1U, 17U, 99U, 100U, 1000U}) {
            const auto end = expected.begin() + static_cast<long>(std::min<std::size_t>(n, 100));
            EXPECT_EQ(n_worst<TypeParam>(n)(list, quality),
                      std::vector<TypeParam>(expected.begin(), end));
        }
        for (const double threshold : {-1.0, 0.0, 5.0, 7.5, 20.0}) {
            const auto end = std::find_if(expected.begin(), expected.end(),
                                          [&](TypeParam s) { return value[s.id] >= threshold; });
            EXPECT_EQ(below<TypeParam>(threshold)(list, quality),
                      std::vector<TypeParam>(expected.begin(), end));
        }
    }
}

TYPED_TEST(Selecting, NaNComesFirst) {
    const auto list = handles<TypeParam>(5);
    const QualityFunction<TypeParam> quality = [](TypeParam s) {
        return s.id % 2 == 1 ? std::nan("") : static_cast<double>(s.id);
    };
    const std::vector<TypeParam> expected{{1}, {3}, {0}};
    EXPECT_EQ(n_worst<TypeParam>(3)(list, quality), expected);
    EXPECT_EQ(below<TypeParam>(1)(list, quality), expected);
}

TYPED_TEST(Selecting, HasNextAndGetNext) {
    const auto list = handles<TypeParam>(6);
    const QualityFunction<TypeParam> quality = [](TypeParam s) { return -1.0 * s.id; };
    Selection<TypeParam> selection(list, quality, n_worst<TypeParam>(3));
    EXPECT_EQ(selection.size(), 3U);
    std::vector<std::uint32_t> ids;
    while (selection.has_next()) {
        ids.push_back(selection.get_next().id);
    }
    EXPECT_EQ(ids, (std::vector<std::uint32_t>{5, 4, 3}));
    EXPECT_THROW(selection.get_next(), InvariantError);
}

} // namespace
} // namespace dsc::selection_test
