// SPDX-License-Identifier: MIT
// Complexes from label images: areas of phases, distances of boundaries and junctions from those of
// the pixels, and small grains that are dropped.
#include "dsc/initial/label_image.h"

#include "dsc/base/error.h"
#include "dsc/geometry/points.h"
#include "dsc/queries/phases.h"
#include "support/curve_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace dsc::label_image_test {
namespace {

LabelImage painted(std::size_t rows, std::size_t columns, auto phase_at) {
    LabelImage image{rows, columns, {}};
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            // The phase at the centre of the pixel; the origin is the lower left corner.
            image.labels.push_back(
                phase_at(static_cast<double>(column) + 0.5, static_cast<double>(rows - row) - 0.5));
        }
    }
    return image;
}

LabelImage of_grains(std::size_t side, std::size_t count, std::uint64_t start = 5) {
    std::mt19937_64 random(start);
    std::uniform_real_distribution<double> place(0, static_cast<double>(side));
    std::vector<Point<double>> seeds(count);
    for (Point<double>& seed : seeds) {
        seed = {place(random), place(random)};
    }
    return painted(side, side, [&](double x, double y) {
        const auto nearest = std::ranges::min_element(seeds, {}, [&](const auto& seed) {
            return (seed - Point<double>(x, y)).squaredNorm();
        });
        return static_cast<Phase>(nearest - seeds.begin() + 1);
    });
}

std::map<Phase, double> shares(const LabelImage& image) {
    std::map<Phase, double> counts;
    for (const Phase label : image.labels) {
        counts[label] += 1 / static_cast<double>(image.labels.size());
    }
    return counts;
}

// The largest relative error of a phase's area, in the unit square.
double area_error(const Complex<double>& complex, const LabelImage& image) {
    std::map<Phase, double> found = test::areas_by_phase(complex);
    double worst = 0;
    for (const auto& [phase, area] : shares(image)) {
        worst = std::max(worst, std::abs(found[phase] - area) / area);
        found.erase(phase);
    }
    EXPECT_TRUE(found.empty());
    return worst;
}

// Corners of pixels at which three phases and more meet, in pixels from the lower left corner.
std::vector<Point<double>> junctions_of(const LabelImage& image) {
    std::vector<Point<double>> junctions;
    for (std::size_t row = 1; row < image.rows; ++row) {
        for (std::size_t column = 1; column < image.columns; ++column) {
            const std::size_t i = row * image.columns + column;
            const std::set<Phase> around{image.labels[i], image.labels[i - 1],
                                         image.labels[i - image.columns],
                                         image.labels[i - image.columns - 1]};
            if (around.size() > 2) {
                junctions.emplace_back(static_cast<double>(column),
                                       static_cast<double>(image.rows - row));
            }
        }
    }
    return junctions;
}

TEST(LabelImage, KeepsAreasAndJunctionsOfGrains) {
    for (const double pixels_to_an_edge : {1.0, 2.5, 4.0}) {
        const LabelImage image = of_grains(200, 60);
        InputReport report;
        const auto complex =
            initial_complex<double>({}, image, {.edge_length = pixels_to_an_edge / 200}, &report);
        EXPECT_TRUE(validate(complex).ok());
        EXPECT_LT(area_error(complex, image), 1e-3);
        EXPECT_GT(test::smallest_angle(complex), 10);
        std::vector<Point<double>> found;
        for (const InterfaceCurve& curve : interface_curves(complex)) {
            for (const Vertex v : {curve.vertices.front(), curve.vertices.back()}) {
                const Point<double> p = complex.position(v) * 200;
                const bool is_inside = p.minCoeff() > 0 && p.maxCoeff() < 200;
                if (is_inside && !curve.is_closed) {
                    found.push_back(p);
                }
            }
        }
        EXPECT_GT(found.size(), 200U);
        for (const Point<double>& junction : junctions_of(image)) {
            EXPECT_GE(std::ranges::count_if(
                          found, [&](const auto& p) { return distance(p, junction) < 0.5; }),
                      3)
                << to_text(junction);
        }
        EXPECT_EQ(report.dropped, 0U);
    }
}

// Points are left out at all borders of a grain; together they change its area by no more.
TEST(LabelImage, KeepsAreasAtLongEdges) {
    for (std::uint64_t start = 1; start <= 5; ++start) {
        const LabelImage image = of_grains(200, 30, start);
        const auto complex = initial_complex<double>({}, image, {.edge_length = 0.04});
        EXPECT_LT(area_error(complex, image), 1e-3) << start;
    }
}

// Errors of areas shrink from round to round of their correction. Where they came down to rounding,
// the equation for the rounds had no solution any more, and areas were wrong by 50 pixels.
TEST(LabelImage, CorrectsAreasNoFurtherThanRounding) {
    for (std::uint64_t start = 1; start <= 20; ++start) {
        const LabelImage image = of_grains(100, 20, start);
        const auto complex = initial_complex<double>({}, image, {.edge_length = 0.01});
        EXPECT_LT(area_error(complex, image), 1e-5) << start;
    }
}

// Lines and circles are recovered more exactly than by the edges of pixels.
TEST(LabelImage, SmoothsTheStairsOfPixels) {
    for (const double slope : {0.0, 0.13, 1.0 / 3, 0.71, 1.0, 2.3}) {
        const auto height = [&](double x) { return 40.2 + slope * (x - 40); };
        const LabelImage image =
            painted(80, 80, [&](double x, double y) { return y > height(x) ? 1U : 2U; });
        const auto complex = initial_complex<double>({}, image, {.edge_length = 2.0 / 80});
        EXPECT_LT(area_error(complex, image), 1e-5);
        for (const InterfaceCurve& curve : interface_curves(complex)) {
            for (const Vertex v : curve.vertices) {
                const Point<double> p = complex.position(v) * 80;
                if (const double d = p.y() - height(p.x());
                    std::min(p.minCoeff(), 80 - p.maxCoeff()) > 5) {
                    EXPECT_LT(std::abs(d) / std::hypot(1, slope), 0.35)
                        << slope << ' ' << to_text(p);
                }
            }
        }
    }
    const auto is_in = [](double x, double y) { return std::hypot(x - 41, y - 39.3) < 20.0; };
    const LabelImage image =
        painted(80, 80, [&](double x, double y) { return is_in(x, y) ? 1U : 0U; });
    const auto complex = initial_complex<double>({}, image, {.edge_length = 2.0 / 80});
    EXPECT_LT(area_error(complex, image), 1e-5);
    for (const InterfaceCurve& curve : interface_curves(complex)) {
        EXPECT_TRUE(curve.is_closed);
        for (const Vertex v : curve.vertices) {
            const Point<double> p = complex.position(v) * 80 - Point<double>(41, 39.3);
            EXPECT_NEAR(p.norm(), 20, 0.45);
        }
    }
}

TEST(LabelImage, PixelsThatShareACornerAlone) {
    // Two squares of one phase meet in a point, and so do four phases.
    const auto diagonal =
        painted(8, 8, [](double x, double y) { return (x < 4) == (y < 4) ? 2U : 1U; });
    const auto complex = initial_complex<double>({}, diagonal, {.edge_length = 0.1});
    EXPECT_LT(area_error(complex, diagonal), 1e-5);
    EXPECT_EQ(interface_curves(complex).size(), 8U); // with those along the sides
    const auto four =
        painted(8, 8, [](double x, double y) { return (x < 4 ? 1U : 2U) + (y < 4 ? 0U : 2U); });
    EXPECT_LT(area_error(initial_complex<double>({}, four, {.edge_length = 0.1}), four), 1e-5);
    // Noise, without any straight boundaries.
    std::mt19937_64 random(2);
    const auto noise =
        painted(40, 40, [&](double, double) { return static_cast<Phase>(random() % 5); });
    const auto noisy =
        initial_complex<double>({}, noise, {.edge_length = 1.0 / 40, .detail = Detail::keep});
    EXPECT_TRUE(validate(noisy).ok());
    EXPECT_LT(area_error(noisy, noise), 1e-2);
}

// A pixel, much smaller than an edge, touches its grain only at a corner: it is dropped, but its
// area is kept.
TEST(LabelImage, PixelsThatHangOnAGrainByACorner) {
    const auto image = painted(40, 40, [](double x, double y) {
        const bool hangs = std::abs(x - 20.5) < 0.5 && std::abs(y - 20.5) < 0.5;
        return (x < 20 && y < 20) || hangs ? 1U : 2U;
    });
    InputReport report;
    const auto complex = initial_complex<double>({}, image, {.edge_length = 0.25}, &report);
    EXPECT_EQ(report.dropped, 1U);
    EXPECT_LT(area_error(complex, image), 1e-3);
}

TEST(LabelImage, SmallGrainsGoToTheirLongestNeighbour) {
    const auto phase = [](double x, double y) {
        const bool is_small = std::abs(x - 21) < 2 && std::abs(y - 20) < 2;
        return is_small ? 3U : x < 20 ? 1U : 2U;
    };
    LabelImage image = painted(40, 40, phase);
    const InitialOptions options{.edge_length = 0.05};
    EXPECT_EQ(test::areas_by_phase(initial_complex<double>({}, image, options)).size(), 3U);
    image.min_pixels = 17;
    InputReport report;
    auto areas = test::areas_by_phase(initial_complex<double>({}, image, options, &report));
    EXPECT_EQ(report.dropped, 1U);
    EXPECT_NEAR(report.area_dropped, 16.0 / 1600, 1e-12);
    EXPECT_EQ(areas.size(), 2U);
    EXPECT_NEAR(areas[2], 0.5 + 4.0 / 1600, 1e-5);
    // One pixel is much smaller than an edge.
    const auto one = painted(40, 40, [](double x, double y) { return x < 1 && y < 1 ? 1U : 2U; });
    areas = test::areas_by_phase(initial_complex<double>({}, one, {.edge_length = 0.25}, &report));
    EXPECT_EQ(report.dropped, 1U);
    EXPECT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[2], 1, 1e-12);
}

TEST(LabelImage, RefusesWhatIsNoImage) {
    EXPECT_THROW((void)initial_complex<double>({}, LabelImage{}), InputError);
    EXPECT_THROW((void)initial_complex<double>({}, LabelImage{2, 2, {1, 2, 3}}), InputError);
    EXPECT_THROW((void)initial_complex<double>({}, LabelImage{1, 2, {1, border_phase}}),
                 InputError);
}

} // namespace
} // namespace dsc::label_image_test
