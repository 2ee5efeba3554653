// SPDX-License-Identifier: MIT
// Quantities computed on all lanes of a star at once equal those of each single triangle and edge.
#include "dsc/complex/gather.h"
#include "dsc/quality/measures.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace dsc::star_quality_test {
namespace {

double squared_quality(const Point<double>& a, const Point<double>& b, const Point<double>& c) {
    const double its = quality<double>(a, b, c);
    return its * std::abs(its);
}

// Calls `look` for every star of some jittered grids, including the boundary. The star object is
// reused, and a large star comes before a small one, an open one before a closed one.
template <class Look>
void for_stars(Look look) {
    Star<double> star;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        auto complex = test::grid<double>(7, 0.19, seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> slide(-0.3, 0.3);
        for (std::uint32_t k = 1; k < 7; ++k) { // also moves vertices along the sides
            for (const std::uint32_t v : {k, 56 + k}) {
                complex.set_position(Vertex{v},
                                     complex.position(Vertex{v}) + Point<double>(slide(random), 0));
            }
            for (const std::uint32_t v : {8 * k, 8 * k + 7}) {
                complex.set_position(Vertex{v},
                                     complex.position(Vertex{v}) + Point<double>(0, slide(random)));
            }
        }
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            ASSERT_TRUE(gather(complex, Region{}, v, star));
            look(complex, star);
        }
    }
}

TEST(RingQuality, OfAStarIsThatOfItsWorstTriangle) {
    for_stars([](const Complex<double>&, const Star<double>& star) {
        const Point<double> centre(star.x0, star.y0);
        double worst = 1;
        double longest = 0;
        double shortest = 1e9;
        for (std::uint32_t i = 0; i < star.link_size(); ++i) {
            const Point<double> at(star.link_x(i), star.link_y(i));
            longest = std::max(longest, squared_distance<double>(centre, at));
            shortest = std::min(shortest, squared_distance<double>(centre, at));
            if (i < star.size) {
                const Point<double> beyond(star.x_next[i], star.y_next[i]);
                worst = std::min(worst, squared_quality(centre, at, beyond));
            }
        }
        const StarReport<double> report = examine(star);
        EXPECT_NEAR(report.quality, worst, 1e-12);
        EXPECT_NEAR(worst_quality_squared(star, star.x0, star.y0), worst, 1e-12);
        EXPECT_EQ(report.longest, longest);
        EXPECT_EQ(report.shortest, shortest);
    });
}

TEST(RingQuality, AfterACollapseIsThatOfTheTrianglesThatRemain) {
    for_stars([](const Complex<double>&, const Star<double>& star) {
        if (!star.closed || star.size < 4) {
            return;
        }
        for (std::uint32_t i = 0; i < star.size; ++i) {
            const Point<double> target(star.x[i], star.y[i]);
            double worst = 1e9;
            for (std::uint32_t j = 0; j < star.size; ++j) {
                const std::uint32_t beyond = (j + 1) % star.size;
                if (j != i && beyond != i) {
                    worst = std::min(worst, squared_quality(target, {star.x[j], star.y[j]},
                                                            {star.x[beyond], star.y[beyond]}));
                }
            }
            EXPECT_NEAR(worst_quality_squared_after_collapse(star, i), worst, 1e-12);
        }
    });
}

TEST(RingQuality, AStarThatPassesTheDelaunayTestHasNoMargin) {
    const auto complex = test::hexagon<double>();
    Star<double> star;
    ASSERT_TRUE(gather(complex, Region{}, 0, star));
    IncidentEdgeMargins<double> margins;
    EXPECT_EQ(examine(star, margins).delaunay, 0);
    for (std::uint32_t i = 0; i < star.size; ++i) {
        EXPECT_GT(margins[i], 0);
    }
}

template <class Real>
class RingQualityTyped : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(RingQualityTyped, Reals);

// Where products overflow, the exact predicate must decide; positions that are not finite are
// refused.
TYPED_TEST(RingQualityTyped, NothingIsCertainFarAwayOrWhereNoNumbersAre) {
    using Real = TypeParam;
    using Limits = std::numeric_limits<Real>;
    const auto complex = test::hexagon<Real>();
    Star<Real> star;
    ASSERT_TRUE(gather(complex, Region{}, 0, star));
    EXPECT_TRUE(certainly_positive(star, Real(0.1), Real(0.2)));
    const Real nan = Limits::quiet_NaN();
    const Real infinity = Limits::infinity();
    const Real overflows = std::sqrt(Limits::max()) * 2;
    for (const Real bad : {nan, infinity, -infinity, overflows, -overflows, Limits::max()}) {
        EXPECT_FALSE(certainly_positive(star, bad, Real(0.2))) << bad;
        EXPECT_FALSE(certainly_positive(star, Real(0.1), bad)) << bad;
        EXPECT_FALSE(certainly_positive(star, bad, bad)) << bad;
        EXPECT_FALSE(certainly_positive(star, bad, -bad)) << bad;
    }
}

} // namespace
} // namespace dsc::star_quality_test
