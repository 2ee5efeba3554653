// SPDX-License-Identifier: MIT
// Targets of edges that grow away from the interface, kept up to date as it moves, sequentially and
// in each division.
#include "support/courses.h"
#include "support/simulation_testing.h"

#include "dsc/complex/complex.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/phases.h"
#include "dsc/sizes/sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsc::sizes_test {
namespace {

using test::all_courses;
using test::Course;
using test::course_name;
using test::expect_sound;
using test::make_simulation;
using test::swirl;

constexpr double h = 0.015;

Options<double> graded(double growth = 1.3) {
    Options<double> options;
    options.edge_length = h;
    options.sizes.growth = growth;
    return options;
}

Complex<double> small_disc() { return test::disc_complex<double>(h, {0.5, 0.7}, 0.15); }

void run_steps(Simulation<double>& simulation, const Velocity<double>& velocity, int steps,
               double dt = 0.6 * h) {
    for (int step = 0; step < steps; ++step) {
        simulation.step(velocity, step * dt, dt);
    }
}

class GradedMesh : public testing::TestWithParam<Course> {};

TEST_P(GradedMesh, CoarsensFarAwayAndKeepsTheCurve) {
    Complex<double> uniform = small_disc();
    Complex<double> complex = small_disc();
    auto even = make_simulation(uniform, {.edge_length = h}, GetParam());
    auto simulation = make_simulation(complex, graded(), GetParam());
    for (int step = 0; step < 30; ++step) {
        even->step(swirl, 0.01 * step, 0.01);
        simulation->step(swirl, 0.01 * step, 0.01);
        expect_sound(complex, *simulation);
    }
    EXPECT_LT(complex.triangle_count(), uniform.triangle_count() / 2);
    EXPECT_TRUE(uniform.attributes.empty()) << "uniform meshes keep no targets";
    EXPECT_NEAR(static_cast<double>(simulation->interface_size()),
                static_cast<double>(even->interface_size()), 4);
    EXPECT_NEAR(phase_area(complex, 1), phase_area(uniform, 1), 1e-5);
    for (const Edge e : edges(complex)) {
        const auto [a, b] = complex.vertices_of(e);
        const double length = (complex.position(a) - complex.position(b)).norm();
        const double target =
            std::min(size_field(complex)[a].length, size_field(complex)[b].length);
        EXPECT_LT(length, 3 * target);
    }
}

// Stored targets may lag behind the exact ones: by the slack for each ring of vertices, and by one
// ring for each pass.
TEST_P(GradedMesh, TargetsAreThoseOfTheMeshAsItIs) {
    Complex<double> complex = small_disc();
    auto simulation = make_simulation(complex, graded(), GetParam());
    const Velocity<double> back = [](auto positions, double time, auto velocities) {
        swirl(positions, time, velocities);
        std::ranges::for_each(velocities, [](Point<double>& one) { one = -one; });
    };
    run_steps(*simulation, swirl, 150);
    run_steps(*simulation, back, 150);
    run_steps(*simulation, test::constant<double>(1e-9, 0), 40); // changes under way must arrive
    const std::vector<VertexSize<double>> kept = size_field(complex).data();
    SizeOptions<double> sizes = graded().sizes;
    sizes.longest = extent_of(complex);
    measure_sizes(complex, sizes, h, 0.0);
    double sum = 0;
    for (const Vertex v : vertices(complex)) {
        const double ratio = kept[v.id].length / size_field(complex)[v].length;
        EXPECT_GT(ratio, 0.6);
        EXPECT_LT(ratio, 1.5);
        sum += std::abs(ratio - 1);
    }
    EXPECT_LT(sum / complex.vertex_count(), 0.1);
}

// Fine triangles follow the interface and are not left behind.
TEST_P(GradedMesh, CoarsensWhatTheInterfaceLeavesBehind) {
    Complex<double> complex = test::disc_complex<double>(h, {0.25, 0.3}, 0.1);
    auto simulation = make_simulation(complex, graded(), GetParam());
    run_steps(*simulation, test::constant<double>(1e-9, 0), 40);
    const double before = complex.triangle_count();
    run_steps(*simulation, test::constant<double>(1, 0.8), 50);
    run_steps(*simulation, test::constant<double>(1e-9, 0), 40);
    expect_sound(complex, *simulation);
    EXPECT_LT(complex.triangle_count(), 1.25 * before);
    EXPECT_GT(complex.triangle_count(), 0.6 * before);
}

INSTANTIATE_TEST_SUITE_P(Sizes, GradedMesh, testing::ValuesIn(all_courses), course_name);

// If targets change far from the interface, the submeshes there remesh although nothing moves.
TEST_P(GradedMesh, FollowsTheTimeFarFromTheInterface) {
    Complex<double> complex = small_disc();
    Options<double> options = graded(1.5);
    options.sizes.by_place = [](const Point<double>& p, double time, Phase) {
        return time >= 1 && p.norm() < 0.2 ? 2 * h : 0.2;
    };
    options.sizes.changes_in_time = true;
    auto simulation = make_simulation(complex, options, GetParam());
    const auto still = test::constant<double>(1e-9, 0);
    const auto in_the_corner = [&](double time, int steps) {
        for (int i = 0; i < steps; ++i) {
            simulation->step(still, time, 1e-3);
        }
        expect_sound(complex, *simulation);
        return std::ranges::count_if(vertices(complex),
                                     [&](Vertex v) { return complex.position(v).norm() < 0.15; });
    };
    const auto coarse = in_the_corner(0, 20);
    EXPECT_GT(in_the_corner(2, 6), 3 * coarse);
}

} // namespace
} // namespace dsc::sizes_test
