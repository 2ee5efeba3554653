// SPDX-License-Identifier: MIT
// Lines from files of points, GeoJSON and SVG paths.
#include "scenes/file/outlines/pieces.h"

#include "dsc/base/error.h"
#include "shapes/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::scenes::outline_sources_test {
namespace {

using std::numbers::pi;

std::vector<Piece> path(const std::string& d, double tolerance = 1e-3, double edge_length = 100) {
    return read_svg_path(d, tolerance, edge_length, "d");
}

TEST(SvgPath, HasLinesAbsoluteAndRelative) {
    const Outline square{{1, 2}, {4, 2}, {4, 5}, {1, 5}};
    for (const char* d : {
             "M 1 2 L 4 2 L 4 5 L 1 5 Z",
             "M1,2 4,2 4,5 1,5z",
             "M1 2H4V5H1Z",
             "m1 2h3v3h-3z",
             "m1 2 3 0 0 3-3 0z",
             "M1 2l3 0l0 3l-3 0L1 2Z",
             "M 1e0 .2e1 L 4.0 2 L 4 5 L 1 5 L 1 2",
         }) {
        const auto pieces = path(d);
        ASSERT_EQ(pieces.size(), 1U) << d;
        EXPECT_EQ(pieces[0].points, square) << d;
        EXPECT_TRUE(pieces[0].is_closed) << d;
    }
    EXPECT_FALSE(path("M 0 0 L 1 0 L 1 1")[0].is_closed);
}

TEST(SvgPath, BeginsAgainAfterAMoveOrAClosure) {
    const auto pieces = path("M0 0h3v3h-3z m1 1h1v1h-1z l9 9 1 0z M7 7L8 8");
    ASSERT_EQ(pieces.size(), 4U);
    EXPECT_EQ(pieces[1].points.front(), Point<double>(1, 1));
    EXPECT_EQ(pieces[2].points.front(), Point<double>(1, 1)) << "where the last one began";
    EXPECT_EQ(pieces[2].points.at(1), Point<double>(10, 10));
    EXPECT_FALSE(pieces[3].is_closed);
}

TEST(Pieces, AreHolesInsideAnOddNumberOfOthers) {
    const auto pieces = path("M0 0h9v9h-9z M1 1h7v7h-7z M2 2h5v5h-5z M20 0h9v9h-9z");
    EXPECT_EQ(nesting(pieces), (std::vector<int>{0, 1, 0, 0}));
}

// How far the points, and the middles of their edges, are from the circle.
double off_circle(const Piece& piece, const Point<double>& centre, double radius) {
    double off = 0;
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
        const Point<double>& a = piece.points[i];
        const Point<double> middle = 0.5 * (a + piece.points[i + 1]);
        off = std::max({off, std::abs((a - centre).norm() - radius),
                        std::abs((middle - centre).norm() - radius)});
    }
    return off;
}

TEST(SvgPath, HasArcsOfEachKind) {
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        // The four arcs from (1, 0) to (0, 1) with radius 1: about two centres, short and long.
        struct Kind {
            const char* flags;
            Point<double> centre;
            double sweep;
        };
        for (const auto& [flags, centre, sweep] : {
                 Kind{"0 1", {0, 0}, pi / 2},
                 Kind{"0 0", {1, 1}, pi / 2},
                 Kind{"1 1", {1, 1}, 3 * pi / 2},
                 Kind{"1 0", {0, 0}, 3 * pi / 2},
             }) {
            const auto pieces = path("M 1 0 A 1 1 0 " + std::string(flags) + " 0 1", tolerance);
            ASSERT_EQ(pieces.size(), 1U);
            EXPECT_LE(off_circle(pieces[0], centre, 1), 1.01 * tolerance) << flags;
            double length = 0;
            for (std::size_t i = 1; i < pieces[0].points.size(); ++i) {
                length += (pieces[0].points[i] - pieces[0].points[i - 1]).norm();
            }
            EXPECT_NEAR(length, sweep, 20 * tolerance) << flags;
            EXPECT_EQ(pieces[0].points.back(), Point<double>(0, 1));
        }
    }
    // Flags without separators; a radius that is too small is made larger; none is a line.
    EXPECT_LE(off_circle(path("M1 0a1 1 0 01-1 1")[0], {0, 0}, 1), 1e-3);
    EXPECT_LE(off_circle(path("M-2 0A1 1 0 0 1 2 0")[0], {0, 0}, 2), 1e-3);
    EXPECT_EQ(path("M0 0A0 1 0 0 1 2 0")[0].points.size(), 2U);
}

TEST(SvgPath, HasTurnedEllipses) {
    // Half-axes 2 and 1, the longer one upright.
    const auto pieces = path("M 0 2 A 2 1 90 0 1 0 -2 A 2 1 90 0 1 0 2 Z", 1e-5);
    ASSERT_EQ(pieces.size(), 1U);
    for (const auto& p : pieces[0].points) {
        EXPECT_NEAR(std::pow(p.x(), 2) + std::pow(p.y() / 2, 2), 1, 1e-9);
    }
    EXPECT_NEAR(std::abs(signed_area(pieces[0].points)), 2 * pi, 1e-3);
}

TEST(SvgPath, HasCurvesWithinTheTolerance) {
    // Both are y = x^2 from -1 to 1, as a quadratic and as a cubic curve.
    for (const char* d : {"M -1 1 Q 0 -1 1 1",
                          "M -1 1 C -0.3333333333333333 "
                          "-0.3333333333333333 0.3333333333333333 "
                          "-0.3333333333333333 1 1",
                          "m -1 1 q 1 -2 2 0"}) {
        for (const double tolerance : {1e-2, 1e-4}) {
            const auto points = path(d, tolerance)[0].points;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const Point<double> middle = 0.5 * (points[i - 1] + points[i]);
                EXPECT_NEAR(points[i].y(), points[i].x() * points[i].x(), 1e-12);
                EXPECT_NEAR(middle.y(), middle.x() * middle.x(), 1.01 * tolerance);
            }
            EXPECT_LT(points.size(), 4 / std::sqrt(tolerance)) << "no more than needed";
        }
    }
    const auto fine = path("M 0 0 Q 1 0 2 0", 1, 0.1)[0].points;
    EXPECT_GE(fine.size(), 21U) << "edges no longer than asked for";
}

TEST(SvgPath, ReflectsControlPoints) {
    // The reflected point written out.
    const auto smooth = path("M 0 0 C 1 2 2 2 3 0 S 5 -2 6 0");
    const auto written = path("M 0 0 C 1 2 2 2 3 0 C 4 -2 5 -2 6 0");
    EXPECT_EQ(smooth[0].points, written[0].points);
    EXPECT_EQ(path("M 0 0 Q 1 2 2 0 T 4 0 T 6 0")[0].points,
              path("M 0 0 Q 1 2 2 0 Q 3 -2 4 0 Q 5 2 6 0")[0].points);
    EXPECT_EQ(path("M 0 0 L 1 0 S 2 1 3 0")[0].points, path("M 0 0 L 1 0 C 1 0 2 1 3 0")[0].points)
        << "after a line there is nothing to reflect";
}

TEST(SvgPath, ErrorsNameTheCharacter) {
    struct Bad {
        const char* d;
        int character;
    };
    for (const auto& [d, character] :
         {Bad{"L 1 1", 2}, Bad{"M 1", 4}, Bad{"M 1 1 X", 7}, Bad{"M 0 0 L 1 1 Z 2", 15},
          Bad{"M 0 0 A 1 1 0 2 0 1 1", 15}, Bad{"M 0 0 L 1e9 0", 9}, Bad{"M 0 0 L nan 0", 9}}) {
        try {
            (void)path(d);
            ADD_FAILURE() << "accepted: " << d;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find("character " + std::to_string(character) + " "),
                      std::string::npos)
                << error.what();
        }
    }
    EXPECT_THROW((void)path("M 0 0 A 1e6 1e6 0 1 1 1 1", 1e-9), InputError) << "too many edges";
    EXPECT_TRUE(path("").empty());
}

TEST(Points, AreReadInPieces) {
    const auto pieces = read_points(
        "# a triangle\n0 0\n1,0\n 0.5\t1 # top\n\n\n3 3\r\n4 3\r\n4 4\r\n3 3\r\n", false, "file");
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].points, (Outline{{0, 0}, {1, 0}, {0.5, 1}}));
    EXPECT_FALSE(pieces[0].is_closed);
    EXPECT_EQ(pieces[1].points.size(), 3U);
    EXPECT_TRUE(pieces[1].is_closed) << "it comes back";
    EXPECT_TRUE(read_points("0 0\n1 0\n1 1", true, "file")[0].is_closed);
    EXPECT_TRUE(read_points("", true, "file").empty());
    for (const char* bad : {"0 0\n1", "0 0\n1 x", "0 0\n1 2 3", "0 0\nnan 0", "0 0\n1e300 0"}) {
        try {
            (void)read_points(bad, true, "file");
            ADD_FAILURE() << bad;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), "file:2") << "the line";
        }
    }
}

TEST(GeoJson, HasPolygonsWithHolesAndLines) {
    const auto polygon = read_geojson(
        R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]],[[4,1],[5,1],[5,2],[4,1]]]})",
        "file");
    ASSERT_EQ(polygon.size(), 2U);
    EXPECT_EQ(polygon[0].points.size(), 3U) << "the first point is not repeated";
    EXPECT_EQ(nesting(polygon), (std::vector<int>{0, 1}));
    const auto many = read_geojson(
        R"({"type":"FeatureCollection","features":[
            {"type":"Feature","geometry":{"type":"MultiPolygon","coordinates":[
                [[[0,0],[1,0],[1,1],[0,0]]],[[[2,0],[3,0],[3,1],[2,0]]]]}},
            {"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[
                {"type":"LineString","coordinates":[[5,5,100],[6,6]]},
                {"type":"MultiLineString","coordinates":[[[7,7],[8,8]]]}]}}]})",
        "file");
    ASSERT_EQ(many.size(), 4U);
    EXPECT_TRUE(many[1].is_closed);
    EXPECT_FALSE(many[2].is_closed);
    EXPECT_EQ(many[2].points.front(), Point<double>(5, 5)) << "heights are left out";
}

TEST(GeoJson, RefusesWhatItIsNot) {
    for (const char* bad : {
             "",
             "[",
             "[]",
             "3",
             "{}",
             R"({"type":"Point","coordinates":[0,0]})",
             R"({"type":"Polygon"})",
             R"({"type":"Polygon","coordinates":3})",
             R"({"type":"Polygon","coordinates":[3]})",
             R"({"type":"Polygon","coordinates":[[3]]})",
             R"({"type":"Polygon","coordinates":[[[0,"x"]]]})",
             R"({"type":"Polygon","coordinates":[[[1e300,0]]]})",
             R"({"type":"Feature","geometry":null})",
             R"({"type":["Polygon"],"coordinates":[]})",
         }) {
        EXPECT_THROW((void)read_geojson(bad, "file"), InputError) << bad;
    }
    std::string deep;
    std::string end;
    for (int i = 0; i < 12; ++i) {
        deep += R"({"type":"GeometryCollection","geometries":[)";
        end += "]}";
    }
    EXPECT_THROW((void)read_geojson(deep + end, "file"), InputError);
}

} // namespace
} // namespace dsc::scenes::outline_sources_test
