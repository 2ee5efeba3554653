// SPDX-License-Identifier: MIT
// An eroded dumbbell, against areas and distances computed from its outline alone.
#include "flows/eroded_dumbbell.h"

#include "dsc/base/error.h"
#include "support/initial_testing.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

namespace dsc::scenes::eroded_dumbbell_test {
namespace {

const Dumbbell straight; // the neck closes at 0.03
// With these sizes the fillets meet in the middle, so no part of the neck is straight.
const Dumbbell waisted{.distance = 2 * rounding_offset({.distance = 9, .rounding = 0.17}).x(),
                       .rounding = 0.17};
const Dumbbell short_neck{.centre = {2, -1}, .distance = 0.4, .neck = 0.08, .rounding = 0.06};

double signed_distance(const Outline& outline, const Point<double>& p) {
    return (test::is_inside(outline, p) ? 1 : -1) * test::distance_from(outline, p);
}

// Every vertex of the outline is as far from the first one as the shape has shrunk.
TEST(ErodedDumbbell, HasItsBoundaryAtThatDistance) {
    for (const Dumbbell& d : {straight, waisted, short_neck}) {
        const Outline first = dumbbell(d, 5e-4);
        for (const double depth : {0.001, 0.02, 0.03, 0.05, 0.1}) {
            for (const Outline& outline : eroded_dumbbell(d, depth).outlines) {
                for (std::size_t i = 0; i < outline.size(); i += 97) {
                    ASSERT_NEAR(signed_distance(first, outline[i]), depth, 1e-6) << depth;
                }
            }
        }
    }
}

TEST(ErodedDumbbell, HasOutlinesOfThatArea) {
    for (const Dumbbell& d : {straight, waisted, short_neck}) {
        for (const double depth : {0.0, 0.01, 0.0299, 0.0301, 0.05, 0.149}) {
            const ExactShape shape = eroded_dumbbell(d, depth);
            EXPECT_NEAR(signed_area(shape.outlines), shape.area, shape.own_error + 1e-15) << depth;
            EXPECT_LT(shape.own_error, 1e-7);
            EXPECT_TRUE(test::is_simple(shape.outlines));
            EXPECT_EQ(shape.outlines.size(), depth < d.neck / 2 ? 1U : 2U) << depth;
        }
        EXPECT_TRUE(eroded_dumbbell(d, 0.15).outlines.empty());
        EXPECT_EQ(eroded_dumbbell(d, 0.15).area, 0);
    }
}

TEST(Dumbbell, HasTheAreaOfItsOutline) {
    EXPECT_EQ(waisted.distance / 2, rounding_offset(waisted).x());
    for (const Dumbbell& d : {straight, waisted, short_neck}) {
        const Outline outline = dumbbell(d, 1e-4);
        EXPECT_TRUE(test::is_simple(outline));
        EXPECT_LE(test::longest_edge(outline), 1e-4 * (1 + 1e-9));
        EXPECT_NEAR(signed_area(outline), dumbbell_area(d), 1e-8);
    }
    EXPECT_NEAR(test::distance_from(dumbbell(waisted, 1e-4), waisted.centre), 0.03, 1e-8);
    EXPECT_THROW((void)dumbbell({.neck = 0.3}, 0.01), InputError);
    EXPECT_THROW((void)dumbbell({.distance = 0.3}, 0.01), InputError);
    EXPECT_THROW((void)dumbbell({.rounding = 0}, 0.01), InputError);
}

} // namespace

} // namespace dsc::scenes::eroded_dumbbell_test
