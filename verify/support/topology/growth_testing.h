// SPDX-License-Identifier: MIT
// Exact shapes of growth along normals, and the errors of simulations.
#pragma once

#include "support/simulation_testing.h"

#include "dsc/algorithm/executor.h"
#include "dsc/initial/initial_complex.h"
#include "geometric_flows/growth_features.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace dsc::test {

using scenes::Outline;

/// A polygon grown by one distance and then shrunk by another: with arcs at opened corners, and
/// elsewhere the intersections of the offset sides. Correct as long as no side vanishes.
inline Outline offset_polygon(const Outline& corners, double growth, double shrinkage = 0) {
    constexpr int chords = 2000;
    Outline offset;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point<double> in = (corners[i] - corners[(i + n - 1) % n]).normalized();
        const Point<double> out = (corners[(i + 1) % n] - corners[i]).normalized();
        const Point<double> before(in.y(), -in.x());
        const Point<double> after(out.y(), -out.x());
        const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        const Point<double> meeting = (before + after) / (1 + before.dot(after));
        // A tip becomes an arc about itself while the shape is larger than at first; a notch
        // becomes an arc about its position after growth.
        const bool is_tip = turn > 0;
        const Point<double> centre = is_tip ? corners[i] : corners[i] + growth * meeting;
        const double radius = is_tip ? growth - shrinkage : -shrinkage;
        if (is_tip ? radius <= 0 : radius >= 0) {
            offset.emplace_back(centre + radius * meeting);
            continue;
        }
        const double first = std::atan2(before.y(), before.x());
        for (int k = 0; k <= chords; ++k) {
            const double angle = first + turn * static_cast<double>(k) / chords;
            offset.emplace_back(centre + radius * Point<double>(std::cos(angle), std::sin(angle)));
        }
    }
    return offset;
}

inline Complex<double> complex_of(const Outline& outline, double h) {
    const std::vector<Shape> shapes{{outline, 1}};
    return initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = h});
}

/// A simulation of phase 1, which grows into phase 0.
class GrowingShape {
public:
    GrowingShape(Complex<double>& complex, double h, const GrowthOptions<double>& growing)
        : h_(h),
          simulation_(complex, options_for<double>(h),
                      std::make_unique<Executor<double>>(complex, options_for<double>(h),
                                                         growth_algorithm(complex, growing))),
          flow_(growth(growing)) {}

    /// Grows in equal steps of at most `step` edge lengths at a speed of 1. Returns the number of
    /// vertices that did not arrive.
    std::uint64_t run(double begin, double duration, double step = 0.4) {
        const int steps = static_cast<int>(std::ceil(duration / (step * h_) - 1e-9));
        const double dt = duration / steps;
        std::uint64_t unreached = 0;
        for (int i = 0; i < steps; ++i) {
            unreached += simulation_.step(flow_, begin + i * dt, dt).unreached;
        }
        return unreached;
    }
    [[nodiscard]] const Simulation<double>& simulation() const { return simulation_; }

private:
    double h_;
    Simulation<double> simulation_;
    InterfaceFlow<double> flow_;
};

/// Grows by one distance and then shrinks by another, one of which may be 0.
inline void grow_and_shrink(Complex<double>& complex, double h, double growth, double shrinkage,
                            double step = 0.4) {
    for (const double distance : {growth, -shrinkage}) {
        if (distance != 0) {
            GrowingShape growing(complex, h, {.speeds = {{1, 0, distance > 0 ? 1.0 : -1.0}}});
            EXPECT_EQ(growing.run(0, std::abs(distance), step), 0U);
            expect_sound(complex, growing.simulation());
        }
    }
}

/// The symmetric difference relative to the area of the exact shape.
inline double difference(const Complex<double>& complex, const std::vector<Outline>& exact) {
    return scenes::symmetric_difference(scenes::interface_outlines(complex), exact) /
           scenes::signed_area(exact);
}

} // namespace dsc::test
