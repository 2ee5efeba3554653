// SPDX-License-Identifier: MIT
// What a run writes beside its result: outlines that this project reads back, pictures, and the
// line that shows how far it has come.
#include "scenes/output/frames.h"
#include "scenes/output/outlines_file.h"
#include "scenes/output/pictures.h"
#include "scenes/output/progress.h"

#include "dsc/base/error.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/phases.h"
#include "scenes/file/outlines/pieces.h"
#include "shapes/outline.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string>

#include <unistd.h>

namespace dsc::scenes::output_test {
namespace {

// Phase 1 with a hole, phase 2 in two pieces, of which one lies in the hole.
template <class Real>
Complex<Real> two_phases() {
    const std::vector<Shape> shapes{{test::square(0.1, 0.1, 0.5), 1},
                                    {test::square(0.2, 0.2, 0.3), 0},
                                    {test::square(0.3, 0.3, 0.1), 2},
                                    {test::square(0.7, 0.7, 0.2), 2}};
    return initial_complex<Real>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.05});
}

template <class Real>
void expect_outlines_to_read_back() {
    const Complex<Real> complex = two_phases<Real>();
    const std::string text = outlines_to_geojson(complex);
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["type"], "FeatureCollection");
    std::map<Phase, double> areas;
    std::multiset<std::pair<Phase, std::size_t>> rings;
    for (const auto& feature : json["features"]) {
        EXPECT_EQ(feature["type"], "Feature");
        EXPECT_EQ(feature["geometry"]["type"], "Polygon");
        const auto& lines = feature["geometry"]["coordinates"];
        const Phase phase = feature["properties"]["phase"];
        rings.emplace(phase, lines.size());
        double area = 0;
        for (const auto& line : lines) {
            ASSERT_GE(line.size(), 4U);
            EXPECT_EQ(line.front(), line.back());
            std::vector<Point<double>> ring;
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                ring.emplace_back(line[i][0], line[i][1]);
            }
            // The right-hand rule.
            EXPECT_EQ(signed_area(ring) > 0, line == lines.front());
            area += signed_area(ring);
        }
        EXPECT_NEAR(feature["properties"]["area"], area, 1e-7);
        areas[phase] += area;
    }
    EXPECT_EQ(rings, (std::multiset<std::pair<Phase, std::size_t>>{{1, 2}, {2, 1}, {2, 1}}));
    for (const Phase phase : {1U, 2U}) {
        EXPECT_NEAR(areas[phase], static_cast<double>(phase_area(complex, phase)), 1e-6);
    }
    // By the project's own reader: the same points, to the bit, and the same nesting.
    std::set<std::pair<double, double>> corners;
    for (const auto& vertex : complex.vertices) {
        corners.emplace(vertex.x, vertex.y);
    }
    const std::vector<Piece> pieces = read_geojson(text, "here");
    ASSERT_EQ(pieces.size(), 4U);
    double sum = 0;
    for (const Piece& piece : pieces) {
        EXPECT_TRUE(piece.is_closed);
        sum += signed_area(piece.points);
        for (const Point<double>& p : piece.points) {
            EXPECT_TRUE(corners.contains({p.x(), p.y()}));
        }
    }
    EXPECT_NEAR(sum, areas[1] + areas[2], 1e-12);
    const std::vector<int> inside = nesting(pieces);
    EXPECT_EQ(std::ranges::count(inside, 1), 1);
}

TEST(Outlines, AreReadBackByThisProject) {
    expect_outlines_to_read_back<double>();
    expect_outlines_to_read_back<float>();
}

TEST(Outlines, NoPhaseButTheExteriorIsAnEmptyCollection) {
    const auto empty = initial_complex<double>({{0, 0}, {1, 1}}, {}, {.edge_length = 0.2});
    EXPECT_TRUE(read_geojson(outlines_to_geojson(empty), "here").empty());
}

TEST(Progress, ShowsNothingBeforeTwoSeconds) {
    std::ostringstream out;
    double now = 100;
    {
        Progress progress(&out, "swirl", 0, 100, [&] { return now; });
        now += 1.9;
        progress.show(10, 3000);
        EXPECT_EQ(out.str(), "");
        now += 0.55;
        progress.show(20, 3600);
        const std::string line = "\r\033[Kswirl: step 20 of 100, 0:10 left, 3600 triangles";
        EXPECT_EQ(out.str(), line);
        now += 0.05; // ten times a second
        progress.show(21, 3600);
        EXPECT_EQ(out.str(), line);
    }
    EXPECT_TRUE(out.str().ends_with("\r\033[K"));
}

TEST(Progress, CountsFromWhereTheRunWentOn) {
    for (const auto& [steps, left] :
         {std::pair{1000, "0:10 left"}, {950 + 5 * 7325, "2:02:05 left"}}) {
        std::ostringstream out;
        double now = 0;
        Progress progress(&out, "grains", 900, steps, [&] { return now; });
        now = 10;
        progress.show(950, 1);
        EXPECT_NE(out.str().find(left), std::string::npos) << out.str();
    }
}

TEST(Frames, AreDueAtStepsAndTimes) {
    const FrameSchedule schedule{.steps = 10, .dt = 0.1, .half = 5};
    const auto due = [&](FramePlan plan) {
        plan.folder = "somewhere";
        std::vector<int> steps;
        for (int step = 0; step <= schedule.steps; ++step) {
            if (is_frame_due(plan, schedule, step)) {
                steps.push_back(step);
            }
        }
        return steps;
    };
    EXPECT_EQ(due({.count = 3}), (std::vector<int>{0, 5, 10}));
    EXPECT_EQ(due({.every = 4}), (std::vector<int>{0, 4, 8, 10}));
    EXPECT_EQ(due({.times = {0.3, 0.31, 0.7, 1.0}}), (std::vector<int>{3, 4, 7, 10}));
    // 2.1 / 0.7 is more than 3 by a rounding, and reached by the third step all the same.
    EXPECT_TRUE(is_frame_due({.folder = "f", .times = {2.1}}, {20, 0.7, {}}, 3));
    EXPECT_EQ(due({.every = 5, .times = {0.05}}), (std::vector<int>{0, 1, 5, 10}));
    EXPECT_FALSE(is_frame_due({}, schedule, 0));
    EXPECT_THROW(check_times({.times = {1.05}}, schedule), InputError);
    EXPECT_THROW(check_times({.times = {-0.1}}, schedule), InputError);
}

TEST(Pictures, HaveTheLayersThatAreAskedFor) {
    const auto folder = std::filesystem::temp_directory_path();
    const std::string path = folder / ("dsc_picture_" + std::to_string(getpid()) + ".svg");
    const auto complex = two_phases<double>();
    std::vector<double> lengths(complex.triangle_bound(), 0.05);
    lengths[5] = 0.2;
    std::vector<std::int32_t> owners(complex.triangle_bound(), 3);
    owners[5] = -1;
    const std::vector<VtuArray> arrays{{"size", SimplexKind::triangle, 1, lengths},
                                       {"submesh", SimplexKind::triangle, 1, owners}};
    const std::vector<Event> events{{.kind = EventKind::split, .time = 0.25, .x = 0, .y = 1}};
    const auto draw = [&](const std::string& layers) {
        write_picture<double>(complex, parse_layers(layers), arrays, events, "a title", path);
        std::ifstream file(path);
        return std::string{std::istreambuf_iterator<char>(file), {}};
    };
    const auto has = [](const std::string& text, const char* what) {
        return text.find(what) != std::string::npos;
    };
    const std::string phases = draw("phases,edges,interface");
    EXPECT_TRUE(has(phases, "class=\"phase-2\"") && has(phases, "class=\"interface\""));
    EXPECT_TRUE(has(phases, "stroke=\"#888888\"") && has(phases, "<title>a title</title>"));
    EXPECT_FALSE(has(phases, "class=\"mark\""));
    const std::string targets = draw("targets,events");
    EXPECT_TRUE(has(targets, "class=\"targets-0\" fill=\"#46075a\"")) << targets.substr(0, 400);
    EXPECT_TRUE(has(targets, "class=\"targets-31\""));
    EXPECT_FALSE(has(targets, "class=\"interface\"") || has(targets, "phase-"));
    // The upper left corner of the domain is that of the picture, less its margin.
    EXPECT_TRUE(has(targets, "d=\"M10.000 10.000m-12 0"));
    EXPECT_TRUE(has(targets, "<title>split at 0.25</title>"));
    const std::string owned = draw("submeshes");
    EXPECT_TRUE(has(owned, "class=\"submesh-3\"") && has(owned, "class=\"submesh-none\""));
    EXPECT_TRUE(has(draw("quality"), "class=\"quality-3"));
    for (const char* bad : {"", "quality,targets", "phase", "quality;edges"}) {
        EXPECT_THROW((void)parse_layers(bad), InputError) << bad;
    }
    std::filesystem::remove(path);
}

TEST(Pictures, ARangeOfColoursHasTwoFiniteEnds) {
    const std::array<double, 2> values{0, 1};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const auto& [low, high] :
         {std::pair{1.0, 0.0}, {1.0, 1.0}, {-infinity, 0.0}, {0.0, infinity}}) {
        EXPECT_THROW((void)fill_by_value("a", values, low, high), InputError) << low << ' ' << high;
    }
    EXPECT_EQ(fill_by_value("a", values, 0, 1).of, (std::vector<std::uint32_t>{0, 31}));
}

} // namespace
} // namespace dsc::scenes::output_test
