// SPDX-License-Identifier: MIT
// The list of measures at one moment, against closed forms.
#include "dsc/base/error.h"
#include "dsc/initial/initial_complex.h"
#include "flows/exact.h"
#include "measures/measures.h"
#include "measures/mesh_quality.h"
#include "shapes/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::scenes::measures_test {
namespace {

using std::numbers::pi;

// A circle that is larger than the exact one; the mesh does not matter.
struct TooLarge {
    Complex<float> mesh = initial_complex<float>({}, {}, {.edge_length = 0.5});
    ExactShape exact = exact_circle({0.5, 0.5}, 0.2);
    std::vector<Outline> outlines{circle({0.5, 0.5}, 0.21, 1e-4)};
    std::vector<Outline> polygons{circle({0.5, 0.5}, 0.21, 0.02)};
    Moment moment{.mesh = &mesh,
                  .outlines = outlines,
                  .polygons = polygons,
                  .exact = &exact,
                  .area_exact_first = 0.2};
};

TEST(Measures, OfACircleThatIsTooLarge) {
    const TooLarge large;
    const Figures f = measure(default_measures(), large.moment);
    const double area = pi * 0.21 * 0.21;
    const double sd = area - pi * 0.2 * 0.2;
    EXPECT_NEAR(number(f, "area"), area, 1e-7);
    EXPECT_EQ(number(f, "area_exact"), pi * 0.2 * 0.2);
    EXPECT_NEAR(number(f, "sd"), sd, 1e-7);
    EXPECT_NEAR(number(f, "sd_rel"), sd / 0.2, 1e-6);
    EXPECT_NEAR(number(f, "hausdorff"), 0.01, 1e-7);
    EXPECT_LE(number(f, "jaggedness.largest_excess_deg"), 0);
    EXPECT_EQ(number(f, "exact_error"), large.exact.own_error);
    EXPECT_EQ(number(f, "min_quality"), measure_quality(large.mesh).min_quality);
    EXPECT_EQ(number(f, "min_angle_deg"), measure_quality(large.mesh).min_angle_deg);
    EXPECT_EQ(number(f, "median_angle_deg"), measure_quality(large.mesh).median_angle_deg);
}

TEST(Measures, OfAShapeThatIsGone) {
    TooLarge gone;
    gone.moment.outlines = {};
    gone.moment.polygons = {};
    const Figures f = measure(default_measures(), gone.moment);
    EXPECT_EQ(number(f, "area"), 0.0);
    EXPECT_NEAR(number(f, "sd"), gone.exact.area, 1e-9);
    EXPECT_EQ(number(f, "hausdorff"), INFINITY);
}

TEST(Measures, WithoutAnExactShapeSayNothingOfIt) {
    TooLarge large;
    large.moment.exact = nullptr;
    const Figures f = measure(default_measures(), large.moment);
    ASSERT_EQ(f.size(), default_measures().size());
    for (std::size_t i = 0; i < f.size(); ++i) {
        const bool can = default_measures()[i].needs != Needs::exact_shape;
        EXPECT_EQ(f[i].name, default_measures()[i].name);
        const auto* value = std::get_if<double>(&f[i].value);
        EXPECT_EQ(value != nullptr && std::isfinite(*value), can) << f[i].name;
    }
}

// A list of measures by an application: a measure may use earlier ones, and may have several
// figures.
TEST(Measures, MayRestOnEachOther) {
    const TooLarge large;
    const std::vector<Measure> list{
        {"count", "1", "of outlines", Needs::outlines,
         [](const Moment& m) { return static_cast<double>(m.outlines.size()); }},
        {"more", "1", "two of it", Needs::outlines, [](const Moment& m) {
             return Figures{{"twice", 2 * number(*m.figures, "count")}, {"thrice", 3.0}};
         }}};
    const Figures f = measure(list, large.moment);
    EXPECT_EQ(number(f, "count"), 1.0);
    EXPECT_EQ(number(f, "more.twice"), 2.0);
    for (const char* name : {"", "cou", "more", "more.", "more.word", "count.twice", "twice"}) {
        EXPECT_THROW((void)number(f, name), InputError) << name;
    }
}

} // namespace

} // namespace dsc::scenes::measures_test
