// SPDX-License-Identifier: MIT
// What make_complex refuses: each sentence once, and nothing that is sound.
#include "support/refusal.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dsc::make_complex_test {
namespace {

using test::Indices;

// The words of the error, or none.
std::string refusal(const std::vector<Point<double>>& points, const std::vector<Indices>& triangles,
                    const std::vector<Phase>& phases) {
    return test::refusal([&] { (void)test::build<double>(points, triangles, phases); });
}

std::string refusal(const std::vector<Point<double>>& points,
                    const std::vector<Indices>& triangles) {
    return refusal(points, triangles, std::vector<Phase>(triangles.size(), 0));
}

const std::vector<Point<double>> points{{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {0.4, 0.7}, {2, 1}};

void expect_words(const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << "'" << text << "' lacks '" << words << "'";
}

TEST(MakeComplex, TakesTrianglesOfEitherOrientation) {
    EXPECT_EQ(refusal(points, {{0, 1, 2}, {0, 1, 3}}), "");
    EXPECT_EQ(refusal(points, {{0, 2, 1}, {1, 0, 3}}), "");
}

TEST(MakeComplex, RefusesTwoTrianglesOnOneSideOfAnEdge) {
    expect_words(refusal(points, {{0, 1, 2}, {0, 1, 4}}), "two triangles overlap at an edge");
}

TEST(MakeComplex, RefusesMoreThanTwoTrianglesAtAnEdge) {
    expect_words(refusal(points, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}),
                 "an edge has more than two triangles");
}

TEST(MakeComplex, RefusesTwoFansAtAVertex) {
    expect_words(refusal({{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 1, 2}, {0, 3, 4}}),
                 "a vertex is not manifold");
}

TEST(MakeComplex, RefusesWhatIsNoTriangle) {
    expect_words(refusal(points, {{0, 1, 1}}), "a triangle is degenerate");
    expect_words(refusal({{0, 0}, {1, 1}, {2, 2}}, {{0, 1, 2}}), "a triangle is degenerate");
    expect_words(refusal(points, {{0, 1, 6}}), "a vertex index is out of range");
}

TEST(MakeComplex, RefusesNumbersThatMeanNothing) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr double beyond = std::numeric_limits<double>::infinity();
    for (const double bad : {none, beyond, -beyond}) {
        expect_words(refusal({{0, 0}, {1, bad}, {0, 1}}, {{0, 1, 2}}),
                     "a coordinate is not finite");
        expect_words(refusal({{0, 0}, {bad, 0}, {0, 1}}, {{0, 1, 2}}),
                     "a coordinate is not finite");
    }
    expect_words(refusal(points, {{0, 1, 2}}, {border_phase}), "a phase is reserved");
    expect_words(refusal(points, {{0, 1, 2}}, {}), "phases do not match triangles");
    expect_words(refusal(points, {{0, 1, 2}}, {0, 0}), "phases do not match triangles");
}

// A corner is a number of 32 bits, and a triangle has four. The triangles need not be there to be
// counted.
TEST(MakeComplex, RefusesMoreTrianglesThanThereAreCorners) {
    constexpr std::size_t most = (std::size_t{1} << 30U) - 3;
    const Indices triangle{0, 1, 2};
    const Phase phase = 0;
    expect_words(test::refusal([&] {
                     (void)make_complex<double>(points, std::span(&triangle, most + 1),
                                                std::span(&phase, most + 1));
                 }),
                 "too many triangles: got 1073741822; allowed: at most 10737418");
    const std::span<const Point<double>> many(points.data(), no_id);
    EXPECT_THROW((void)make_complex<double>(many, std::span(&triangle, 1), std::span(&phase, 1)),
                 InputError);
}

} // namespace
} // namespace dsc::make_complex_test
