// SPDX-License-Identifier: MIT
// Coordinates are only names of places, so what happens must not depend on them. The same mesh and
// flow, scaled by powers of two in space and time, give the same bits up to that map, by every
// strategy: lengths are never compared with absolute numbers. What is turned and mirrored,
// combinations/ runs.
#include "support/random/scene.h"
#include "support/simulation_testing.h"
#include "support/topology/changing.h"
#include "support/ways.h"

#include "dsc/complex/ranges.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

namespace dsc::invariance_test {
namespace {

using test::Way;

/// p becomes scale * p; a time t becomes t * time_scale.
struct Map {
    std::string name;
    double scale = 1;
    double time_scale = 1;
};

// The same ids.
Complex<double> mapped(const Complex<double>& complex, const Map& map) {
    std::vector<Point<double>> points;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        points.emplace_back(map.scale * complex.position(Vertex{v}));
    }
    std::vector<std::array<std::uint32_t, 3>> corners;
    std::vector<Phase> phases;
    for (const Triangle t : triangles(complex)) {
        corners.push_back(complex.triangles[t.id].v);
        phases.push_back(complex.phase(t));
    }
    return make_complex<double>(points, corners, phases);
}

test::ChangingOptions<double> mapped(test::ChangingOptions<double> options, const Map& map) {
    options.edge_length *= map.scale;
    options.topology.contact *= map.scale;
    options.topology.least_area *= map.scale * map.scale;
    options.sizes.longest *= map.scale;
    return options;
}

struct Case {
    std::string name;
    std::function<Complex<double>()> complex;
    test::ChangingOptions<double> options;
    std::function<Point<double>(const Point<double>& p, double time)> velocity;
    double dt = 0.01;
    int steps = 12;
};

Velocity<double> mapped(const Case& one, const Map& map) {
    return test::pointwise([velocity = one.velocity, map](const Point<double>& p, double time) {
        return Point<double>(map.scale / map.time_scale *
                             velocity(p / map.scale, time / map.time_scale));
    });
}

test::ChangingOptions<double> options_of(double h) {
    test::ChangingOptions<double> options;
    options.edge_length = h;
    return options;
}

Point<double> swirl(const Point<double>& p, double) {
    constexpr double pi = std::numbers::pi;
    return {std::pow(std::sin(pi * p.x()), 2) * std::sin(2 * pi * p.y()),
            -std::pow(std::sin(pi * p.y()), 2) * std::sin(2 * pi * p.x())};
}

// Two discs that grow into each other, and their own centres.
Point<double> apart(const Point<double>& p, double) {
    return (p - Point<double>(p.x() < 0.5 ? 0.3 : 0.7, 0.5)).normalized();
}

Complex<double> two_discs() {
    const std::vector<Shape> shapes{{test::circle_points({0.3, 0.5}, 0.15, 32), 1},
                                    {test::circle_points({0.7, 0.5}, 0.15, 32), 2}};
    return initial_complex<double>({}, shapes, {.edge_length = 0.03});
}

Case swirled() {
    return {.name = "swirl",
            .complex =
                [] {
                    return test::disc_complex<double>(0.03, {0.5, 0.7}, 0.15);
                },
            .options = options_of(0.03),
            .velocity = swirl};
}

Case merged() {
    Case one{
        .name = "merging", .complex = two_discs, .options = options_of(0.03), .velocity = apart};
    one.options.topology.rule = Topology::change;
    one.options.topology.contact = 0.02;
    one.options.topology.gives_back_area = true;
    return one;
}

Case graded() {
    Case one = swirled();
    one.name = "graded";
    one.options.sizes.growth = 1.3;
    one.options.sizes.longest = 0.1;
    return one;
}

Case of_patches() {
    Case one = swirled();
    one.name = "patches";
    one.complex = [] {
        test::Dice dice(11);
        return test::random_patches<double>(dice, 0.04, 12);
    };
    one.options = options_of(0.04);
    one.options.interface.coarsening = Coarsening::length;
    one.options.insertion = Insertion::linear;
    one.options.interface.turn_degrees = 30;
    return one;
}

std::vector<Case> cases() { return {swirled(), merged(), graded(), of_patches()}; }

std::vector<Way> all_ways() {
    std::vector<Way> ways{nullptr};
    ways.insert(ways.end(), all_divisions.begin(), all_divisions.end());
    return ways;
}

struct Ran {
    Complex<double> complex;
    std::uint64_t edits = 0;
};

Ran run(const Case& one, const Map& map, Way way) {
    Ran ran{.complex = mapped(one.complex(), map)};
    const test::ChangingOptions<double> options = mapped(one.options, map);
    test::ChangingSimulation<double> simulation(ran.complex, options,
                                                test::executor_of(way, ran.complex, options));
    simulation.add_listener([&](std::span<const Edit> edits) { ran.edits += edits.size(); });
    const Velocity<double> velocity = mapped(one, map);
    const double dt = one.dt * map.time_scale;
    for (int step = 0; step < one.steps; ++step) {
        (void)simulation.step(velocity, step * dt, dt);
    }
    EXPECT_EQ(validate(ran.complex).problem, "");
    return ran;
}

// The largest distance between a vertex and the image of its counterpart; infinite where the two
// have other triangles.
double difference(const Complex<double>& plain, const Complex<double>& image, const Map& map) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (plain.vertex_bound() != image.vertex_bound() ||
        plain.triangle_count() != image.triangle_count()) {
        return infinity;
    }
    double most = 0;
    for (std::uint32_t v = 0; v < plain.vertex_bound(); ++v) {
        if (plain.is_alive(Vertex{v}) != image.is_alive(Vertex{v})) {
            return infinity;
        }
        if (plain.is_alive(Vertex{v})) {
            const Point<double> there = map.scale * plain.position(Vertex{v});
            most = std::max(most, (there - image.position(Vertex{v})).norm() / map.scale);
        }
    }
    for (const Triangle t : triangles(plain)) {
        const auto [a, b, c] = plain.vertices_of(t);
        const Corner corner = image.find_half_edge(a, b);
        if (corner == no_id || image.vertex(corner) != c.id ||
            image.phase_at(corner) != plain.phase(t)) {
            return infinity;
        }
    }
    return most;
}

void expect_same_bits(const Case& one, const Map& map, Way way) {
    SCOPED_TRACE(one.name + ", " + map.name + ", " + test::name_of(way));
    const Ran plain = run(one, {}, way);
    const Ran image = run(one, map, way);
    EXPECT_GT(plain.edits, 30U) << "hardly anything happened";
    EXPECT_EQ(image.edits, plain.edits);
    EXPECT_EQ(difference(plain.complex, image.complex, map), 0);
}

TEST(Invariance, ScaledInSpaceOrTimeGivesTheSameBits) {
    for (const Map& map :
         {Map{.name = "half as large", .scale = 0.5}, Map{.name = "large", .scale = 0x1p40},
          Map{.name = "small", .scale = 0x1p-40}, Map{.name = "slow", .time_scale = 64},
          Map{.name = "small and fast", .scale = 0x1p-9, .time_scale = 0x1p-20}}) {
        for (const Case& one : cases()) {
            for (const Way way : all_ways()) {
                expect_same_bits(one, map, way);
            }
        }
    }
}

} // namespace
} // namespace dsc::invariance_test
