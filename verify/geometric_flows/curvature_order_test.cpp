// SPDX-License-Identifier: MIT
// The orders of curvature flow in dt and in h where curves end: at triple junctions, at the domain
// boundary and at contact angles. The area that a curve sweeps per unit of time is the angle by
// which its direction changes from end to end, which is known as long as the ends keep their
// angles.
#include "support/interface_view_testing.h"
#include "support/simulation_testing.h"

#include "dsc/algorithm/interface_sight.h"
#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/curve_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::curvature_order_test {
namespace {

using std::numbers::pi;
using test::expect_sound;
using test::options_for;

/// A shape whose ends have their equilibrium angles from the start, with its exact rate of area.
struct Bounded {
    Complex<double> complex;
    CurvatureFlowOptions flow;
    double rate; ///< of the area of phase 1
};

// An arc from one end to the other; above the chord if `side` is 1.
Curve arc_between(const Point<double>& middle, double half_width, double angle, int edges,
                  double side, Phase left, Phase right) {
    Curve curve{{}, left, right};
    const double radius = half_width / std::sin(angle);
    for (int i = 0; i <= edges; ++i) {
        const double at = angle * (1 - 2.0 * i / edges);
        const double height = i == 0 || i == edges ? 0 : std::cos(at) - std::cos(angle);
        const Point<double> way(i == 0 || i == edges ? half_width * (i == 0 ? 1 : -1)
                                                     : radius * std::sin(at),
                                radius * height);
        curve.points.push_back(middle + side * way);
    }
    return curve;
}

// A lens of phase 1, bounded by two arcs, on the straight interface of phases 2 and 3, whose
// tension is given; that of the arcs is 1.
Bounded lens(double tension, double h) {
    const double angle = std::acos(tension / 2);
    const Point<double> middle(0.5, 0.5);
    const int edges = static_cast<int>(std::ceil(0.4 * angle / std::sin(angle) / h));
    const Curve upper = arc_between(middle, 0.2, angle, edges, 1, 1, 2);
    const Curve lower = arc_between(middle, 0.2, angle, edges, -1, 1, 3);
    const std::vector<Curve> curves{upper,
                                    lower,
                                    {{{0, 0.5}, lower.points.front()}, 2, 3},
                                    {{lower.points.back(), {1, 0.5}}, 2, 3}};
    return {initial_complex<double>({}, curves, {.edge_length = h}),
            {.pairs = {{.one = 2, .other = 3, .tension = tension}}},
            -4 * angle};
}

// A cap of a disc on the floor, which it meets at the given angle.
Bounded cap(double degrees, double h) {
    const double angle = degrees * pi / 180;
    constexpr double radius = 0.25;
    const int edges = static_cast<int>(std::ceil(2 * radius * angle / h));
    const std::vector<Curve> curves{
        arc_between({0.5, 0}, radius * std::sin(angle), angle, edges, 1, 1, 0)};
    return {initial_complex<double>({}, curves, {.edge_length = h}),
            {.boundary_energies = {{1, -std::cos(angle)}}},
            -2 * angle};
}

/// Only the interface moves: no edge of it is split or collapsed.
class Curves {
public:
    explicit Curves(const Bounded& shape)
        : complex_(shape.complex), rate_(shape.rate), motion_(curvature_flow<double>(shape.flow)) {
        const Simulation<double> simulation(complex_, options_for<double>(0.01));
        const auto list = simulation.interface();
        for (const std::uint32_t v : list) {
            positions.push_back(complex_.position(Vertex{v}));
        }
        test::build(graph_, complex_, list);
    }

    // The relative error of the rate of change of the area.
    double run(double duration, int steps) {
        const double before = area();
        std::vector<Point<double>> ways(positions.size());
        for (int step = 0; step < steps; ++step) {
            std::ranges::fill(ways, Point<double>(0, 0));
            motion_(graph_.view(complex_, positions), 0, duration / steps, ways);
            for (std::size_t i = 0; i < ways.size(); ++i) {
                positions[i] += ways[i];
            }
        }
        return (area() - before) / duration / rate_ - 1;
    }

    std::vector<Point<double>> positions;

private:
    double area() {
        CurveNetwork network;
        find_network(
            graph_.view(complex_, positions), [](Phase, Phase) { return EdgeForces{}; },
            [](Phase) { return 0.0; }, network);
        double sum = 0;
        for (const CurveEdge& edge : network.edges) {
            const Point<double>& from = positions[edge.from];
            const Point<double>& to = positions[edge.to];
            const double part = (from.x() * to.y() - from.y() * to.x()) / 2;
            sum += edge.left == 1 ? part : (edge.right == 1 ? -part : 0);
        }
        return sum;
    }

    Complex<double> complex_;
    double rate_;
    InterfaceMotion<double> motion_;
    InterfaceGraph<double> graph_;
};

/// Errors for the same curves with n, 2 n and 4 n steps.
struct InTime {
    double error;  ///< error of the rate, with the fewest steps
    double finest; ///< the same with the most
    double order;  ///< order of convergence, by the largest distance between vertices
};

// The runs start from curves that have already become smooth at their ends.
InTime in_time(const Bounded& shape, double duration, int steps) {
    Curves curves(shape);
    (void)curves.run(5e-4, 200);
    const auto start = curves.positions;
    std::array<double, 3> errors{};
    std::array<std::vector<Point<double>>, 3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        curves.positions = start;
        errors[k] = curves.run(duration, steps << k);
        ends[k] = curves.positions;
    }
    const auto distance = [&](std::size_t k) {
        double largest = 0;
        for (std::size_t i = 0; i < start.size(); ++i) {
            largest = std::max(largest, (ends[k + 1][i] - ends[k][i]).norm());
        }
        return largest;
    };
    return {errors[0], errors[2], std::log2(distance(0) / distance(1))};
}

TEST(CurvatureOrder, IsThreeHalvesInTimeAtJunctions) {
    struct Case {
        double tension;
        double limit;  ///< of the error with the longest steps
        double finest; ///< limit of the error with the shortest steps, which is due to h
    };
    for (const auto& [tension, limit, finest] : {Case{1, 4e-4, 2e-4}, Case{1.6, 2e-3, 4e-4}}) {
        SCOPED_TRACE(tension);
        const InTime of = in_time(lens(tension, 0.01), 0.004, 32);
        EXPECT_GT(of.order, 1.4);
        EXPECT_LT(std::abs(of.error), limit);
        EXPECT_LT(std::abs(of.finest), finest);
    }
}

TEST(CurvatureOrder, IsTwoInTimeAtTheBoundaryAndThreeHalvesAtContactAngles) {
    const InTime upright = in_time(cap(90, 0.01), 0.008, 8);
    EXPECT_GT(upright.order, 1.85);
    EXPECT_LT(std::abs(upright.error), 2e-3);
    for (const double degrees : {60.0, 120.0}) {
        SCOPED_TRACE(degrees);
        const InTime of = in_time(cap(degrees, 0.01), 0.008, 64);
        EXPECT_GT(of.order, 1.3);
        EXPECT_LT(std::abs(of.error), 3e-3);
    }
}

TEST(CurvatureOrder, IsTwoAlongTheCurve) {
    const auto order = [](const auto& shape_of) {
        const double coarse = Curves(shape_of(0.02)).run(5e-4, 200);
        const double fine = Curves(shape_of(0.01)).run(5e-4, 200);
        EXPECT_LT(std::abs(fine), 2.5e-3);
        return std::log2(coarse / fine);
    };
    for (const double tension : {1.0, 1.6}) {
        EXPECT_GT(order([&](double h) { return lens(tension, h); }), 1.8) << tension;
    }
    for (const double degrees : {60.0, 90.0, 120.0}) {
        EXPECT_GT(order([&](double h) { return cap(degrees, h); }), 1.8) << degrees;
    }
}

// --- with the mesh, and steps proportional to h -------------------------------------------------

double error_in_a_simulation(Bounded shape, double h, double duration) {
    auto options = options_for<double>(h);
    options.interface.feature_degrees = 180;
    Simulation<double> simulation(shape.complex, options);
    const auto motion = curvature_flow<double>(shape.flow);
    const double before = phase_area(shape.complex, 1);
    const int steps = static_cast<int>(std::lround(duration * 40 / h));
    for (int step = 0; step < steps; ++step) {
        EXPECT_EQ(simulation.step(motion, 0, duration / steps).unreached, 0U);
    }
    expect_sound(shape.complex, simulation);
    return (phase_area(shape.complex, 1) - before) / duration / shape.rate - 1;
}

TEST(CurvatureOrder, HoldsInASimulation) {
    const auto expect = [](const auto& shape_of, double duration, double limit) {
        const double coarse = error_in_a_simulation(shape_of(0.02), 0.02, duration);
        const double fine = error_in_a_simulation(shape_of(0.005), 0.005, duration);
        EXPECT_LT(std::abs(coarse), limit);
        EXPECT_GT(std::log2(coarse / fine) / 2, 1.35) << coarse << ", " << fine;
    };
    expect([](double h) { return lens(1, h); }, 0.004, 2.5e-3);
    expect([](double h) { return lens(1.6, h); }, 0.004, 1.2e-2);
    expect([](double h) { return cap(60, h); }, 0.008, 5e-3);
    expect([](double h) { return cap(90, h); }, 0.008, 5e-3);
    expect([](double h) { return cap(120, h); }, 0.008, 1e-2);
}

} // namespace
} // namespace dsc::curvature_order_test
