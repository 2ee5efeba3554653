// SPDX-License-Identifier: MIT
// Options of interface remeshing: which vertices may be removed, lengths of edges, features that
// stay, and the quality of the mesh beside short edges.
#include "dsc/complex/gather.h"
#include "dsc/passes/algorithm.h"

#include "support/simulation_testing.h"

#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dsc::interface_remeshing_test {
namespace {

using test::options_for;

constexpr double h = 0.05;
using Outline = std::vector<Point<double>>;

Outline ellipse(double a, double b, int n) {
    Outline outline;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        outline.emplace_back(0.5 + a * std::cos(angle), 0.5 + b * std::sin(angle));
    }
    return outline;
}

Complex<double> complex_of(const Outline& outline) {
    const std::vector<Shape> shapes{{outline, 1}};
    return initial_complex<double>({}, shapes, {.edge_length = h, .detail = Detail::keep});
}

// Runs remeshing repeatedly until nothing changes any more.
struct Kept {
    Complex<double> complex;
    OperationCounts counts;
    std::vector<std::uint32_t> interface;
    bool ended = false;
};

Kept keep_up(const Outline& outline, const Options<double>& options) {
    Kept kept{complex_of(outline), {}, {}, false};
    mark_features(kept.complex, collect_interface(kept.complex), options.interface.feature_degrees,
                  0.0);
    Work<double> work(kept.complex, options);
    work.interface = collect_interface(kept.complex);
    for (int round = 0; round < 60 && !kept.ended; ++round) {
        work.log.counts = {};
        remesh_interface(work);
        EXPECT_EQ(validate(kept.complex).problem, "");
        kept.counts += work.log.counts;
        kept.ended = work.log.counts.interface_splits + work.log.counts.interface_collapses == 0;
    }
    kept.interface = work.interface;
    return kept;
}

Options<double> with(Coarsening coarsening) {
    auto options = options_for<double>(h);
    options.interface.coarsening = coarsening;
    return options;
}

// Edges of a fifth of the edge length: far more vertices than the thresholds call for.
const Outline crowded = ellipse(0.3, 0.15, 148);

// A hexagon with a vertex too close to each corner: that vertex is removed and the corner stays,
// although the curve turns by only 60 degrees there.
TEST(Coarsening, KeepsCornersAndTakesWhatIsBesideThem) {
    Outline outline;
    std::vector<Point<double>> corners;
    for (int i = 0; i < 6; ++i) {
        const auto at = [](int k) {
            const double angle = std::numbers::pi * (k + 0.5) / 3;
            return Point<double>(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
        };
        corners.push_back(at(i));
        for (const double share : {0.0, 0.025, 0.2, 0.4, 0.6, 0.8}) {
            outline.push_back((1 - share) * at(i) + share * at(i + 1));
        }
    }
    auto options = with(Coarsening::length);
    options.interface.feature_degrees = 45;
    const Kept kept = keep_up(outline, options);
    EXPECT_GE(kept.counts.interface_collapses, 6U);
    for (const Point<double>& corner : corners) {
        EXPECT_TRUE(std::ranges::any_of(kept.interface, [&](std::uint32_t v) {
            return (kept.complex.position(Vertex{v}) - corner).norm() < 1e-12;
        })) << corner.transpose();
    }
}

TEST(Coarsening, NeverLeavesAllVertices) {
    const Kept kept = keep_up(crowded, with(Coarsening::never));
    EXPECT_TRUE(kept.ended);
    EXPECT_EQ(kept.counts.interface_collapses, 0U);
    EXPECT_GE(kept.interface.size(), crowded.size());
}

TEST(Coarsening, ByLengthTakesAllThatDeviationTakesAndMore) {
    auto narrow = with(Coarsening::deviation);
    narrow.interface.deviation = 4e-3;
    const Kept deviation = keep_up(crowded, narrow);
    const Kept length = keep_up(crowded, with(Coarsening::length));
    EXPECT_TRUE(deviation.ended);
    EXPECT_TRUE(length.ended);
    EXPECT_GT(deviation.counts.interface_collapses, 10U);
    EXPECT_GT(length.counts.interface_collapses, deviation.counts.interface_collapses * 6 / 5);
}

// A vertex is removed only if its distance from the curve without it is less than the allowed
// deviation, whether the curve is read by chords or by cubics.
TEST(Coarsening, ByDeviationKeepsTheCurve) {
    for (const Reading reading : {Reading::chords, Reading::cubic}) {
        auto options = with(Coarsening::deviation);
        options.interface.deviation = 2e-4;
        options.interface.reading = reading;
        const Kept kept = keep_up(crowded, options);
        const double lost =
            std::abs(phase_area(kept.complex, 1) - phase_area(complex_of(crowded), 1));
        const double perimeter = 1.46;
        if (reading == Reading::chords) {
            EXPECT_LT(lost, 3 * options.interface.deviation * h * perimeter);
            EXPECT_LT(kept.counts.interface_collapses, 20U);
        } else {
            // The cubic through the neighbours passes through the vertex, so it may be removed
            // although it is off the chord.
            EXPECT_GT(kept.counts.interface_collapses, 40U);
        }
    }
}

// The cubic is evaluated at the vertex's own position along the chord, not at the middle.
TEST(Coarsening, ByDeviationFromTheCubicTakesUnevenVerticesToo) {
    Outline uneven;
    for (int i = 0; i < 240; ++i) {
        const double angle = 2 * std::numbers::pi * (i + (i % 2 == 0 ? 0.0 : -0.5)) / 240;
        uneven.emplace_back(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
    }
    auto options = with(Coarsening::deviation);
    options.interface.deviation = 1e-4;
    options.interface.reading = Reading::cubic;
    EXPECT_GT(keep_up(uneven, options).counts.interface_collapses, 80U);
    options.interface.reading = Reading::chords;
    EXPECT_EQ(keep_up(uneven, options).counts.interface_collapses, 0U);
}

double largest_turn(const Complex<double>& complex, double shortest) {
    double largest = 0;
    Star<double> star;
    for (const std::uint32_t v : collect_interface(complex)) {
        EXPECT_TRUE(gather(complex, Region{}, v, star));
        const IncidentEdges s = interface_edges_of(star);
        const Point<double> p(star.x0, star.y0);
        const Point<double> a = link_point(star, s.first);
        const Point<double> b = link_point(star, s.second);
        const double length = std::max((a - p).norm(), (b - p).norm());
        if (length > shortest) {
            largest = std::max(largest, std::abs(curvature<double>(a, p, b)) * length);
        }
    }
    return largest * 180 / std::numbers::pi;
}

TEST(Sizes, FollowTheCurvature) {
    const Outline outline = ellipse(0.3, 0.06, 36); // turns by 24 degrees in 0.1 h at its tips
    auto options = with(Coarsening::never);
    const Kept plain = keep_up(outline, options);
    options.interface.turn_degrees = 20;
    options.interface.feature_degrees = 180;
    options.interface.finest = 0.02;
    const Kept fine = keep_up(outline, options);
    EXPECT_TRUE(fine.ended);
    EXPECT_GT(largest_turn(plain.complex, 0), 30);
    EXPECT_LT(largest_turn(fine.complex, 2 * 0.02 * h), 20.0001);
    EXPECT_GT(fine.interface.size(), plain.interface.size());
    // Nor is any edge split to less than the finest length.
    for (const std::uint32_t v : fine.interface) {
        const Point<double> p = fine.complex.position(Vertex{v});
        for (const std::uint32_t w : fine.interface) {
            EXPECT_TRUE(v == w || (fine.complex.position(Vertex{w}) - p).norm() > 0.9 * 0.02 * h);
        }
    }
}

// A strip that is a quarter of an edge wide.
TEST(Sizes, FollowTheGapToTheNextSheet) {
    constexpr double width = 0.25 * h;
    const Outline strip{{0.2, 0.475}, {0.8, 0.475}, {0.8, 0.525}, {0.2, 0.525}};
    auto options = with(Coarsening::never);
    for (const bool follows : {false, true}) {
        options.interface.gap = follows ? 2 : 0;
        auto complex = complex_of(strip);
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            const Point<double> p = complex.position(Vertex{v});
            complex.set_position(Vertex{v}, {p.x(), 0.5 + (p.y() - 0.5) * width / h});
        }
        Work<double> work(complex, options);
        work.interface = collect_interface(complex);
        mark_features(complex, work.interface, options.interface.feature_degrees, 0.0);
        for (int round = 0; round < 10; ++round) {
            remesh_interface(work);
        }
        EXPECT_EQ(validate(complex).problem, "");
        double longest = 0;
        Star<double> star;
        for (const std::uint32_t v : work.interface) {
            ASSERT_TRUE(gather(complex, Region{}, v, star));
            const IncidentEdges s = interface_edges_of(star);
            const Point<double> p(star.x0, star.y0);
            longest = std::max(longest, (link_point(star, s.first) - p).norm());
        }
        if (follows) {
            EXPECT_LE(longest, 2 * width * 1.0001);
        } else {
            EXPECT_GT(longest, 3 * width);
        }
    }
}

// Where a triangle cuts off a corner of the curve, the curve's second edge is in the link; it does
// not count as another sheet.
TEST(Sizes, KnowNoGapToTheSameSheet) {
    const Outline square{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    const Outline small{{0.5, 0.5}, {0.55, 0.5}, {0.55, 0.55}, {0.5, 0.55}};
    std::size_t cut = 0;
    for (const Outline& outline : {square, small, ellipse(0.3, 0.15, 40)}) {
        const auto complex = complex_of(outline);
        Star<double> star;
        for (const std::uint32_t v : collect_interface(complex)) {
            ASSERT_TRUE(gather(complex, Region{}, v, star));
            const IncidentEdges incident = interface_edges_of(star);
            EXPECT_TRUE(std::isinf(squared_gap(complex, star, incident)));
            for (std::uint32_t i = 0; i < star.size; ++i) {
                const bool is_beside = i == incident.first || i == incident.second ||
                                       (i + 1) % star.size == incident.first ||
                                       (i + 1) % star.size == incident.second;
                const Phase across = complex.phase_at(complex.twin(star.corner[i]));
                cut += is_beside && across != star.phase[i] ? 1U : 0U;
            }
        }
    }
    EXPECT_GT(cut, 0U);
}

// The default of `feature_degrees`.
TEST(Corners, AreTurnsOfMoreThanFortyDegrees) {
    for (const double turn : {39.9, 40.1}) {
        const double high = 0.2 * std::tan(turn / 2 * std::numbers::pi / 180);
        auto complex =
            complex_of({{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.6}, {0.5, 0.6 + high}, {0.3, 0.6}});
        const Simulation<double> simulation(complex, options_for<double>(h));
        const auto corners = std::ranges::count_if(simulation.interface(), [&](std::uint32_t v) {
            return (complex.vertices[v].flags & vertex_feature) != 0;
        });
        EXPECT_EQ(corners, turn > 40 ? 5 : 4);
    }
}

// A vertex that deviates from the curve by less than the mesh resolves is no feature; a corner that
// a short edge cuts off is one.
TEST(Corners, AreTurnsAtTheScaleOfTheMesh) {
    Outline circle = ellipse(0.3, 0.3, 40);
    circle.insert(circle.begin() + 8,
                  Point<double>(circle[7] * 1.01 - 0.01 * Point<double>(0.5, 0.5)));
    const Outline square{{0.3, 0.3}, {0.698, 0.3}, {0.7, 0.302}, {0.7, 0.7}, {0.3, 0.7}};
    for (const auto& [outline, corners] : {std::pair(circle, 0), std::pair(square, 4)}) {
        auto complex = initial_complex<double>({}, {Shape{outline, 1}},
                                               {.edge_length = h, .detail = Detail::keep});
        mark_features(complex, collect_interface(complex), 40, feature_arc * h);
        int marked = 0;
        for (const Vertex v : vertices(complex)) {
            marked += complex.is_feature(v) ? 1 : 0;
        }
        EXPECT_EQ(marked, corners);
    }
}

TEST(Corners, AreMarkedOnceAndKept) {
    const Outline square{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    const auto options = options_for<double>(h);
    auto complex = complex_of(square);
    Simulation<double> simulation(complex, options);
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : simulation.interface()) {
        if ((complex.vertices[v].flags & vertex_feature) != 0) {
            corners.push_back(v);
        }
    }
    ASSERT_EQ(corners.size(), 4U);
    // A shear that opens two of the corners to 135 degrees and more, and back.
    const auto shear = [](double speed) {
        return test::pointwise<double>([=](const Point<double>& p, double) {
            return Point<double>(speed * (p.y() - 0.5), 0);
        });
    };
    for (int step = 0; step < 80; ++step) {
        const auto report = simulation.step(shear(step < 40 ? 1 : -1), 0, 0.025);
        ASSERT_EQ(report.unreached, 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        ASSERT_TRUE(complex.is_alive(Vertex{corners[i]}));
        double nearest = 1;
        for (const auto& p : square) {
            nearest = std::min(nearest, (complex.position(Vertex{corners[i]}) - p).norm());
        }
        EXPECT_LT(nearest, 1e-13);
    }
    EXPECT_NEAR(phase_area(complex, 1), 0.16, 1e-13);
}

double worst_quality_at(const Complex<double>& complex,
                        const std::vector<std::uint32_t>& interface) {
    double worst = 1;
    Star<double> star;
    for (const std::uint32_t v : interface) {
        EXPECT_TRUE(gather(complex, Region{}, v, star));
        worst = std::min(worst, worst_quality_squared(star, star.x0, star.y0));
    }
    return std::sqrt(worst);
}

// Edges of a fifth of the edge length, which must be kept.
TEST(Grading, FillsTheMeshBesideShortEdges) {
    std::array<double, 2> worst{};
    for (const bool graded : {false, true}) {
        auto options = with(Coarsening::never);
        options.interface.grading = graded ? 3 : 0;
        auto complex = complex_of(crowded);
        Simulation<double> simulation(complex, options);
        for (int step = 0; step < 15; ++step) {
            const auto report = simulation.step(test::constant<double>(0.5, 0.1), 0, 0.02);
            EXPECT_TRUE(!graded || report.unreached == 0);
            ASSERT_EQ(validate(complex).problem, "");
        }
        worst[graded ? 1 : 0] = worst_quality_at(complex, simulation.interface());
    }
    EXPECT_LT(worst[0], 0.2);
    EXPECT_GT(worst[1], 0.25);
}

// Arms that a flow bends, and that are much thinner than an edge. New vertices of sheets that bend
// away from their neighbours must not leave the edges while those behind them cannot: the arms
// would gain 2 per cent. The polygon of the markers that the flow carries gains 0.06.
TEST(ThinArms, KeepTheirAreaWhereTheyBend) {
    constexpr int arms = 400;
    Outline star;
    for (int i = 0; i < 2 * arms; ++i) {
        const double angle = std::numbers::pi * i / arms;
        const double radius = i % 2 == 0 ? 0.1 : 0.3;
        star.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
    }
    const Velocity<double> swirl = test::pointwise<double>([](const Point<double>& p) {
        const double x = std::numbers::pi * p.x();
        const double y = std::numbers::pi * p.y();
        return Point<double>(std::pow(std::sin(x), 2) * std::sin(2 * y),
                             -std::pow(std::sin(y), 2) * std::sin(2 * x));
    });
    auto complex = initial_complex<double>({{0, 0}, {1, 1}}, {{star, 1}}, {.edge_length = 0.02});
    const double area = phase_area(complex, 1);
    Simulation<double> simulation(complex, options_for<double>(0.02));
    std::uint64_t unreached = 0;
    for (int step = 0; step < 20; ++step) {
        unreached += simulation.step(swirl, 0.01 * step, 0.01).unreached;
    }
    EXPECT_EQ(unreached, 0U);
    EXPECT_NEAR(phase_area(complex, 1) / area, 1, 1e-3);
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::interface_remeshing_test
