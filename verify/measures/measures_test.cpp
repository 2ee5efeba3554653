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

// A circle that is too large, in a mesh that does not matter.
struct TooLarge {
    Complex<float> mesh = initial_complex<float>({}, {}, {.edge_length = 0.5});
    ExactShape exact = exact_circle({0.5, 0.5}, 0.2);
    std::vector<Outline> outlines{circle({0.5, 0.5}, 0.21, 1e-4)};
    std::vector<Outline> polygons{circle({0.5, 0.5}, 0.21, 0.02)};
    Moment moment{.mesh = &mesh,
                  .outlines = outlines,
                  .polygons = polygons,
                  .exact = &exact,
                  .area_first = 0.1,
                  .area_exact_first = 0.2};
};

TEST(Measures, AreSelectedWithThoseThatTheyUse) {
    const auto names = [](const std::vector<Measure>& measures) {
        std::vector<std::string> all;
        for (const Measure& one : measures) {
            all.push_back(one.name);
        }
        return all;
    };
    EXPECT_EQ(names(select_measures({"sd_rel"})), (std::vector<std::string>{"sd", "sd_rel"}));
    EXPECT_EQ(names(select_measures({"perimeter", "area_drift_exact"})),
              (std::vector<std::string>{"area", "area_exact", "area_drift_exact", "perimeter"}));
    EXPECT_THROW((void)select_measures({"aera"}), InputError);
    // Each alone can be measured, so none reads a measure that it does not name.
    const TooLarge large;
    for (const Measure& one : default_measures()) {
        EXPECT_NO_THROW((void)measure(select_measures({one.name}), large.moment)) << one.name;
    }
}

TEST(Measures, OfACircleThatIsTooLarge) {
    const TooLarge large;
    const Figures f = measure(default_measures(), large.moment);
    const double area = pi * 0.21 * 0.21;
    const double sd = area - pi * 0.2 * 0.2;
    EXPECT_NEAR(number(f, "area"), area, 1e-7);
    EXPECT_EQ(number(f, "area_exact"), pi * 0.2 * 0.2);
    EXPECT_NEAR(number(f, "area_drift_exact"), 0.21 * 0.21 / (0.2 * 0.2) - 1, 1e-6);
    EXPECT_NEAR(number(f, "area_drift_first"), area / 0.1 - 1, 1e-6);
    EXPECT_NEAR(number(f, "sd"), sd, 1e-7);
    EXPECT_NEAR(number(f, "sd_rel"), sd / 0.2, 1e-6);
    EXPECT_NEAR(number(f, "hausdorff"), 0.01, 1e-7);
    EXPECT_NEAR(number(f, "perimeter"), 2 * pi * 0.21, 1e-6);
    EXPECT_EQ(number(f, "jaggedness.beyond"), 0);
    EXPECT_LT(number(f, "jaggedness.rms_deg"), 0.5);
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
        EXPECT_EQ(std::isfinite(number(f, f[i].name)), can) << f[i].name;
    }
}

// A list of one's own: a measure may rest on those before it, and may say several things.
TEST(Measures, MayRestOnEachOther) {
    const TooLarge large;
    const std::vector<Measure> list{
        {"count", "1", "of outlines", Needs::outlines,
         [](const Moment& m) { return Value(std::uint64_t{m.outlines.size()}); }},
        {"more", "1", "two of it", Needs::outlines, [](const Moment& m) {
             return Figures{{"twice", 2 * number(*m.figures, "count")}, {"word", "so"}};
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
