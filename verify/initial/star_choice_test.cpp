// SPDX-License-Identifier: MIT
// What the improvement of the first mesh decides at a single star, against the plainest way to the
// same answer; and that each part does nothing where there is nothing to do.
#include "dsc/complex/gather.h"
#include "dsc/geometry/triangle.h"
#include "dsc/initial/build/interface.h"
#include "dsc/initial/build/star_quality.h"
#include "dsc/initial/improve/improvement.h"
#include "dsc/initial/improve/refinement.h"
#include "dsc/queries/validate.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

namespace dsc::initial::star_choice_test {
namespace {

Ring<double> ring_of(const Complex<double>& complex, std::uint32_t vertex) {
    Ring<double> ring;
    EXPECT_TRUE(gather(complex, Region{}, vertex, ring));
    return ring;
}

TEST(StarFits, OnlyWhereEachTriangleStaysPositive) {
    const auto complex = test::hexagon<double>();
    const auto ring = ring_of(complex, 0);
    EXPECT_TRUE(fits<double>(ring, {0, 0}));
    EXPECT_TRUE(fits<double>(ring, {0.8, 0.1}));
    EXPECT_FALSE(fits<double>(ring, {2, 0}));
    EXPECT_FALSE(fits<double>(ring, {1, 0})); // on the link
    EXPECT_FALSE(fits<double>(ring, {0, -1}));
}

// The quality of the worst triangle after the vertex has been drawn to the end of spoke k; 0 if one
// turns over or a spoke is too long.
double after_collapse(const Ring<double>& ring, std::uint32_t k, double longest) {
    const auto link = [&](std::uint32_t i) {
        return Point<double>(ring.link_x(i), ring.link_y(i));
    };
    const std::uint32_t count = ring.link_size();
    const Point<double> target = link(k);
    double worst = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        const std::uint32_t from = i;
        const std::uint32_t to = (i + 1) % count;
        if (from == k || to == k) {
            continue;
        }
        const bool is_long =
            std::max((link(from) - target).norm(), (link(to) - target).norm()) > longest;
        const bool turns = area<double>(target, link(from), link(to)) <= 0;
        worst =
            is_long || turns ? 0 : std::min(worst, quality<double>(target, link(from), link(to)));
    }
    return worst;
}

void expect_best(const Complex<double>& complex, double longest) {
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        const auto ring = ring_of(complex, v);
        double best = 0;
        for (std::uint32_t k = 0; k < ring.link_size(); ++k) {
            const double worst = after_collapse(ring, k, longest);
            if ((ring.closed || k == 0 || k == ring.size) && std::isfinite(worst)) {
                best = std::max(best, worst);
            }
        }
        const CollapseChoice choice = best_collapse(ring, longest);
        EXPECT_NEAR(choice.quality, best, 1e-12) << v;
        EXPECT_EQ(choice.spoke == no_id, best == 0) << v;
        if (choice.spoke != no_id) {
            EXPECT_NEAR(after_collapse(ring, choice.spoke, longest), best, 1e-12) << v;
        }
    }
}

TEST(StarCollapse, ChoosesTheBestNeighbourOfAll) {
    for (unsigned seed = 1; seed < 20; ++seed) {
        const auto complex = test::grid<double>(5, 0.19, seed);
        expect_best(complex, std::numeric_limits<double>::infinity());
        expect_best(complex, 1.6);
    }
}

TEST(Improvement, DoesNothingWhereThereIsNothing) {
    auto complex = test::grid<double>(4);
    const std::uint64_t before = mesh_hash(complex);
    EXPECT_EQ(split_long(complex, std::span<const std::uint32_t>{}, 0.1), 0U);
    EXPECT_EQ(refine(complex, std::span<const std::uint32_t>{}, {}), 0U);
    clear_lattice(complex, fit_lattice({0, 0}, {4, 4}, 1), std::span<const Path>{}, 1);
    improve(complex, std::span<const std::uint32_t>{}, 1, 4, {});
    EXPECT_EQ(mesh_hash(complex), before);
}

TEST(Zone, EndsWhereTheMeshIsAsCoarseAsAskedFor) {
    auto complex = test::grid<double>(40);
    const std::array<std::uint32_t, 1> corner{0};
    const auto zone = find_zone(complex, std::span<const std::uint32_t>(corner), 1.0);
    EXPECT_GT(zone.size(), 1U);
    EXPECT_LT(zone.size(), complex.vertex_count() / 10);
}

} // namespace
} // namespace dsc::initial::star_choice_test
