// SPDX-License-Identifier: MIT
// Phases whose inside is advected: a rigid motion does not change their triangles, sequentially and
// in every division.
#include "support/courses.h"
#include "support/simulation_testing.h"

#include "dsc/base/error.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/interface/list.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace dsc::advected_phases_test {
namespace {

using test::Course;

constexpr double h_of_disc = 0.03;

Complex<double> disc_to_advect() { return test::disc_complex<double>(h_of_disc, {0.4, 0.5}, 0.2); }

// Options with which the triangles of phase 1 are never improved.
Options<double> carrying() {
    Options<double> options = test::options_for<double>(h_of_disc);
    options.advected_phases = {1};
    options.per_phase = {{}, {.collapse_quality = 0, .smooth_quality = 0}};
    return options;
}

const Velocity<double> drift = test::constant<double>(0.8, 0.3);

void run_advected(Simulation<double>& simulation, const Velocity<double>& velocity, int steps) {
    constexpr double dt = 0.1 * h_of_disc;
    for (int step = 0; step < steps; ++step) {
        EXPECT_EQ(simulation.step(velocity, step * dt, dt).unreached, 0U);
    }
}

using TriangleMap = std::map<std::uint32_t, std::array<std::uint32_t, 3>>;

TriangleMap triangles_inside(const Complex<double>& complex) {
    TriangleMap all;
    for (const Triangle t : triangles(complex, 1)) {
        all[t.id] = complex.triangles[t.id].v;
    }
    return all;
}

class AdvectedPhase : public testing::TestWithParam<Course> {};

TEST_P(AdvectedPhase, KeepsItsTrianglesInARigidMotion) {
    Complex<double> complex = disc_to_advect();
    auto& first = complex.attributes.add<Vertex, Point<double>>("first", Point<double>(0, 0));
    for (const Vertex v : vertices(complex)) {
        first[v] = complex.position(v);
    }
    auto simulation = make_simulation(complex, carrying(), GetParam());
    const TriangleMap before = triangles_inside(complex);
    const std::size_t on_curve = simulation->interface_size();
    run_advected(*simulation, drift, 60);
    test::expect_sound(complex, *simulation);
    EXPECT_EQ(simulation->interface_size(), on_curve);
    // Create and merge gives everything new ids, as the thesis does.
    if (GetParam().division != &copy_division) {
        EXPECT_EQ(triangles_inside(complex), before);
    }
    EXPECT_EQ(triangles_inside(complex).size(), before.size());
    const Point<double> way = 60 * 0.1 * h_of_disc * Point<double>(0.8, 0.3);
    for (const Triangle t : triangles(complex, 1)) {
        for (const Vertex v : complex.vertices_of(t)) {
            EXPECT_LT((complex.position(v) - first[v] - way).norm(), 1e-13);
        }
    }
}

// Vertices inserted inside the phase are advected from then on, and removed ones have no effect. In
// a linear velocity field the position of every vertex is known.
TEST_P(AdvectedPhase, MovesTheVerticesThatAreNewInside) {
    Complex<double> complex = test::disc_complex<double>(h_of_disc, {0.5, 0.5}, 0.1);
    auto& first = complex.attributes.add<Vertex, Point<double>>("first", Point<double>(0, 0));
    for (const Vertex v : vertices(complex)) {
        first[v] = complex.position(v);
    }
    const Point<double> centre(0.5, 0.5);
    const auto stretching = test::pointwise<double>([&](const Point<double>& p, double) {
        return Point<double>(p.x() - centre.x(), centre.y() - p.y());
    });
    Options<double> options = carrying();
    options.insertion = Insertion::linear;
    options.interface.deviation = 0; // collapses would not be exact in a linear field
    auto simulation = make_simulation(complex, options, GetParam());
    const std::size_t before = triangles_inside(complex).size();
    constexpr double dt = 0.01;
    for (int step = 0; step < 120; ++step) {
        simulation->step(stretching, step * dt, dt);
    }
    test::expect_sound(complex, *simulation);
    EXPECT_GT(triangles_inside(complex).size(), before + 5);
    const double grown = std::exp(120 * dt);
    for (const Vertex v : vertices(complex)) {
        if (is_advected<double>(complex, options.advected_phases, v)) {
            const Point<double> from = first[v] - centre;
            const Point<double> there = centre + Point<double>(grown * from.x(), from.y() / grown);
            EXPECT_LT((complex.position(v) - there).norm(), 1e-6) << "vertex " << v.id;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Passes, AdvectedPhase, testing::ValuesIn(test::all_courses),
                         test::course_name);

TEST(AdvectedPhases, CanBeChosenBetweenTwoSteps) {
    Complex<double> complex = disc_to_advect();
    const Options<double> options = test::options_for<double>(h_of_disc);
    Simulation<double> simulation(complex, options);
    run_advected(simulation, drift, 10);
    simulation.set_options(carrying());
    run_advected(simulation, drift, 1); // flips that were due
    const TriangleMap before = triangles_inside(complex);
    run_advected(simulation, drift, 20);
    EXPECT_EQ(triangles_inside(complex), before);
    renumber(complex);
    run_advected(simulation, drift, 1);
    const TriangleMap renumbered = triangles_inside(complex);
    run_advected(simulation, drift, 10);
    EXPECT_EQ(triangles_inside(complex), renumbered);
    simulation.set_options(options);
    run_advected(simulation, drift, 20);
    test::expect_sound(complex, simulation);
    EXPECT_NE(triangles_inside(complex), renumbered);
}

TEST(AdvectedPhases, RefuseAFlowThatIsNotKnownInside) {
    Complex<double> complex = disc_to_advect();
    Simulation<double> simulation(complex, carrying());
    const auto outwards = vertex_flow<double>(
        [](const auto& view, std::size_t i, double) { return normal(view, i); });
    EXPECT_THROW(simulation.step(outwards, 0, 0.001), InputError);
    EXPECT_EQ(simulation.step(drift, 0, 0.001).unreached, 0U);
}

} // namespace
} // namespace dsc::advected_phases_test
