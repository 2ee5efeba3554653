// SPDX-License-Identifier: MIT
// Lines from files of points and GeoJSON.
#include "scenes/file/outlines/pieces.h"

#include "dsc/base/error.h"
#include "shapes/outline.h"

#include <gtest/gtest.h>

namespace dsc::scenes::outline_sources_test {
namespace {

TEST(Pieces, AreHolesInsideAnOddNumberOfOthers) {
    const auto pieces = read_points("0 0\n9 0\n9 9\n0 9\n\n1 1\n8 1\n8 8\n1 8\n\n"
                                    "2 2\n7 2\n7 7\n2 7\n\n20 0\n29 0\n29 9\n20 9\n",
                                    true, "file");
    EXPECT_EQ(nesting(pieces), (std::vector<int>{0, 1, 0, 0}));
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
