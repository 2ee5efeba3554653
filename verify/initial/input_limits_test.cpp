// SPDX-License-Identifier: MIT
// Input at the very limit of what is allowed, and outlines that begin anywhere.
#include "dsc/base/error.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/initial/input/input_check.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace dsc::input_limits_test {
namespace {

TEST(InputLimits, AnOutlineMayBeginAtAnyOfItsVerticesAndGoEitherWay) {
    std::vector<Point<double>> points{{3, 5}, {1, 1}, {0, 0}, {1, -1}, {4, -1}};
    double doubled = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& p = points[i];
        const auto& q = points[(i + 1) % points.size()];
        doubled += p.x() * q.y() - p.y() * q.x();
    }
    for (int way = 0; way < 2; ++way, std::reverse(points.begin(), points.end())) {
        for (std::size_t first = 0; first < points.size(); ++first) {
            const std::vector<Shape> shapes{{points, 1}};
            const auto complex =
                initial_complex<double>({{-1, -2}, {6, 6}}, shapes, {.edge_length = 1});
            EXPECT_TRUE(validate(complex).ok());
            EXPECT_NEAR(phase_area(complex, 1), doubled / 2, 1e-12) << way << ' ' << first;
            std::rotate(points.begin(), points.begin() + 1, points.end());
        }
    }
}

TEST(InputLimits, TheLeastEdgeLengthsAreAllowed) {
    const double h = initial::least_initial_edge_length;
    EXPECT_TRUE(
        validate(initial_complex<double>({{0, 0}, {4 * h, 4 * h}}, {}, {.edge_length = h})).ok());
    EXPECT_THROW(
        (void)initial_complex<double>({{0, 0}, {4 * h, 4 * h}}, {}, {.edge_length = h / 2}),
        InputError);
    const double steps = initial::least_steps * std::numeric_limits<double>::epsilon();
    const Rectangle far{{1 - 4 * steps, 1 - 4 * steps}, {1, 1}};
    EXPECT_TRUE(validate(initial_complex<double>(far, {}, {.edge_length = steps})).ok());
    EXPECT_THROW((void)initial_complex<double>(far, {}, {.edge_length = steps * 0.99}), InputError);
}

void expect_refused(const Curve& curve, const std::string& words) {
    const std::vector<Curve> curves{curve};
    const std::string sentence =
        test::refusal([&] { (void)initial_complex<float>({}, curves, {.edge_length = 0.1}); });
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
}

TEST(InputLimits, CurvesAreRefusedFromTheirFirstPointOn) {
    expect_refused({{{0, 0.5}, {0, 0.5}, {1, 0.5}}, 1, 0}, "the edge has no length");
    expect_refused({{{0.3, 0.5}, {0.3 + 1e-12, 0.5}, {1, 0.5}}, 1, 0}, "collide");
    // Finite, but not in the scalar of the complex.
    expect_refused({{{0, 0.5}, {0.5, 1e39}, {1, 0.5}}, 1, 0}, "not finite");
}

} // namespace
} // namespace dsc::input_limits_test
