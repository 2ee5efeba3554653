// SPDX-License-Identifier: MIT
// Recovered segments pass through every vertex that lies on them.
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/interface.h"
#include "dsc/initial/build/lattice.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace dsc::segments_test {
namespace {

// Segments across a triangulation that was made without them.
TEST(Segments, AreRecoveredThroughAnything) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0.02, 0.98);
        const auto lattice = initial::fit_lattice({0, 0}, {1, 1}, 0.5);
        Complex<double> complex;
        initial::write_lattice(lattice, 0, complex);
        std::vector<Corner> stack;
        const auto insert = [&](const Point<double>& p) {
            return initial::insert_point(complex, initial::locate(complex, 1, p), p, stack);
        };
        for (int i = 0; i < 120; ++i) {
            // Many points lie on one line, along which a segment may run.
            insert(i % 3 == 0 ? Point<double>(std::round(64 * share(random)) / 64, 0.5)
                              : Point<double>(share(random), share(random)));
        }
        const auto first = static_cast<std::uint32_t>(seed % 2 == 0 ? 1 : 2);
        initial::Chains chains;
        chains.push_back(
            {insert({0.01, 0.5}), insert({0.99, 0.5}), insert({0.7, 0.9 - 0.1 * first})});
        chains.push_back({insert({0.05, 0.03}), insert({0.9, 0.04}), insert({0.5, 0.07})});
        for (auto& chain : chains) {
            chain.push_back(chain.front());
        }
        const auto touched = initial::recover_segments(complex, chains);
        EXPECT_FALSE(touched.empty());
        EXPECT_GT(chains.front().size(), 20U) << "vertices on a segment become part of it";
        const auto report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        for (const auto& chain : chains) {
            EXPECT_EQ(chain.front(), chain.back());
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                const Vertex a{chain[i]};
                const Vertex b{chain[i + 1]};
                EXPECT_TRUE(complex.find_edge(a, b).is_valid());
            }
        }
    }
}

} // namespace
} // namespace dsc::segments_test
