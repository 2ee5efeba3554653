// SPDX-License-Identifier: MIT
// The refusals of make_complex: each message once, and no valid mesh is refused.
#include "support/refusal.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dsc::make_complex_test {
namespace {

using test::Indices;
using Points = std::vector<Point<double>>;

const Points points{{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {0.4, 0.7}, {2, 1}};

void expect_words(const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << "'" << text << "' lacks '" << words << "'";
}

TEST(MakeComplex, TakesTrianglesOfEitherOrientation) {
    EXPECT_NO_THROW(test::build<double>(points, {{0, 1, 2}, {0, 1, 3}}, {0, 0}));
    EXPECT_NO_THROW(test::build<double>(points, {{0, 2, 1}, {1, 0, 3}}, {0, 0}));
}

// Turns of 11.4 and of 14.3 degrees, and corners.
TEST(MakeComplex, MarksSharpTurnsOfTheBoundary) {
    for (const auto& [height, is_sharp] : {std::pair(0.1, false), std::pair(0.125, true)}) {
        const auto complex = test::build<double>({{0, 0}, {1, -height}, {2, 0}, {1, 1}},
                                                 {{0, 1, 3}, {1, 2, 3}}, {0, 0});
        for (const std::uint32_t v : {0U, 1U, 2U, 3U}) {
            EXPECT_EQ(complex.is_boundary_feature(Vertex{v}), v != 1 || is_sharp) << v;
        }
    }
}

TEST(MakeComplex, RefusesWhatMakesNoSense) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr double beyond = std::numeric_limits<double>::infinity();
    struct Row {
        const char* words;
        std::vector<Indices> triangles;
        std::vector<Phase> phases;
        Points at = points;
    };
    const std::vector<Row> rows{
        {"two triangles overlap at an edge", {{0, 1, 2}, {0, 1, 4}}, {0, 0}},
        {"an edge has more than two triangles", {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, {0, 0, 0}},
        {"a vertex is not manifold",
         {{0, 1, 2}, {0, 3, 4}},
         {0, 0},
         {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}},
        {"the triangles overlap",
         {{0, 1, 2}, {3, 4, 5}},
         {0, 0},
         {{0, 0}, {1, 0}, {0, 1}, {0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}}},
        {"a triangle is degenerate", {{0, 1, 1}}, {0}},
        {"a triangle is degenerate", {{0, 1, 2}}, {0}, {{0, 0}, {1, 1}, {2, 2}}},
        {"a vertex index is out of range", {{0, 1, 6}}, {0}},
        {"a coordinate is not finite", {{0, 1, 2}}, {0}, {{0, 0}, {1, none}, {0, 1}}},
        {"a coordinate is not finite", {{0, 1, 2}}, {0}, {{0, 0}, {-beyond, 0}, {0, 1}}},
        {"a phase is reserved", {{0, 1, 2}}, {border_phase}},
        {"phases do not match triangles", {{0, 1, 2}}, {}},
        {"phases do not match triangles", {{0, 1, 2}}, {0, 0}}};
    for (const Row& row : rows) {
        expect_words(
            test::refusal([&] { (void)test::build<double>(row.at, row.triangles, row.phases); }),
            row.words);
    }
}

// A corner is stored in 32 bits, four numbers for each triangle, which limits the number of
// triangles. The span's size alone is checked, so no such array is needed.
TEST(MakeComplex, RefusesMoreTrianglesThanThereAreCorners) {
    constexpr std::size_t largest = (std::size_t{1} << 30U) - 3;
    const Indices triangle{0, 1, 2};
    const Phase phase = 0;
    expect_words(test::refusal([&] {
                     (void)make_complex<double>(points, std::span(&triangle, largest + 1),
                                                std::span(&phase, largest + 1));
                 }),
                 "too many triangles: got 1073741822; allowed: at most 10737418");
    const std::span<const Point<double>> many(points.data(), no_id);
    EXPECT_THROW((void)make_complex<double>(many, std::span(&triangle, 1), std::span(&phase, 1)),
                 InputError);
}

} // namespace
} // namespace dsc::make_complex_test
