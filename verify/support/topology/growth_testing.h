// SPDX-License-Identifier: MIT
// Shapes that grow along their normals in closed form, and how far a simulation is from them.
#pragma once

#include "support/simulation_testing.h"

#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/parallel.h"
#include "flows/two_discs.h"
#include "geometric_flows/growth_corners.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::test {

using scenes::Outline;

/// The polygon by its corners, grown by one distance and then shrunk by another: arcs where corners
/// have opened, and otherwise the intersections of the sides' offsets. Right as long as no side
/// vanishes.
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
        // A tip has an arc about it while it is larger than it was at first; a notch has an arc
        // about the place from which it receded.
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

/// The union of two discs as one outline, with vertices on the circles and at the notches.
inline Outline union_outline(const scenes::TwoDiscs& discs, double h) {
    const double d = (discs.second.x() - discs.first.x()) / 2;
    const double phi = std::acos(d / discs.radius);
    const int edges =
        static_cast<int>(std::ceil(discs.radius * (2 * std::numbers::pi - 2 * phi) / h));
    Outline outline;
    for (const bool is_first : {true, false}) {
        const double begin = is_first ? phi : phi - std::numbers::pi;
        for (int i = 0; i < edges; ++i) {
            const double angle = begin + i * (2 * std::numbers::pi - 2 * phi) / edges;
            outline.emplace_back((is_first ? discs.first : discs.second) +
                                 discs.radius * Point<double>(std::cos(angle), std::sin(angle)));
        }
    }
    return outline;
}

template <class Real = double>
Complex<Real> complex_of(const Outline& outline, double h) {
    const std::vector<Shape> shapes{{outline, 1}};
    return initial_complex<Real>({{0, 0}, {1, 1}}, shapes, {.edge_length = h});
}

/// A simulation of phase 1, which grows into phase 0.
template <class Real>
class GrowingShape {
public:
    GrowingShape(Complex<Real>& complex, double h, const GrowthOptions<Real>& growing,
                 const Parallel* parallel = nullptr)
        : options_(options_for<Real>(h)),
          simulation_(
              complex, options_,
              parallel != nullptr
                  ? make_executor(complex, options_, *parallel, growth_algorithm(complex, growing))
                  : std::make_unique<Executor<Real>>(complex, options_,
                                                     growth_algorithm(complex, growing))),
          flow_(growth(growing)) {}

    /// In equal steps of at most `step` edge lengths at a speed of 1. Returns the number of
    /// vertices that did not arrive.
    std::uint64_t run(double begin, double duration, double step = 0.4) {
        const double h = static_cast<double>(options_.edge_length);
        const int steps = static_cast<int>(std::ceil(duration / (step * h) - 1e-9));
        std::uint64_t unreached = 0;
        for (int i = 0; i < steps; ++i) {
            const double dt = duration / steps;
            unreached +=
                simulation_.step(flow_, static_cast<Real>(begin + i * dt), static_cast<Real>(dt))
                    .unreached;
        }
        return unreached;
    }
    [[nodiscard]] const Simulation<Real>& simulation() const { return simulation_; }

private:
    Options<Real> options_;
    Simulation<Real> simulation_;
    InterfaceFlow<Real> flow_;
};

/// Grows by one distance and then shrinks by another, one of which may be 0.
template <class Real>
void grow_and_shrink(Complex<Real>& complex, double h, double growth, double shrinkage,
                     double step = 0.4) {
    for (const double distance : {growth, -shrinkage}) {
        if (distance != 0) {
            const double speed = distance > 0 ? 1 : -1;
            GrowingShape<Real> growing(complex, h, {.speeds = {{1, 0, speed}}});
            EXPECT_EQ(growing.run(0, std::abs(distance), step), 0U);
            expect_sound(complex, growing.simulation());
        }
    }
}

/// Relative to the area of the exact shape.
template <class Real>
double difference(const Complex<Real>& complex, const std::vector<Outline>& exact) {
    return scenes::symmetric_difference(scenes::interface_outlines(complex), exact) /
           scenes::signed_area(exact);
}

} // namespace dsc::test
