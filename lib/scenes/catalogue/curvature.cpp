// SPDX-License-Identifier: MIT
// Curvature flow. Any closed curve loses area at the rate 2 pi, becomes convex, and vanishes as a
// round point without ever splitting: M. A. Grayson, "The heat equation shrinks embedded plane
// curves to round points" (1987).
#include "flows/exact.h"
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;
/// The largest displacement of a vertex in a step, for the curvature of the radius below.
constexpr double farthest_step = 0.25;

Setup circle_to_half(const Parameters& p) {
    static constexpr double first_radius = 0.3;
    static const Point<double> middle(0.5, 0.5);
    const double last_radius = first_radius / std::sqrt(2.0);
    Setup setup = scheduled(p, first_radius * first_radius / 4, farthest_step * p.h * last_radius);
    setup.outlines = {circle(middle, first_radius, p.h)};
    setup.curvature = CurvatureMotion{};
    setup.exact = [](double time) {
        return exact_circle(middle, std::sqrt(first_radius * first_radius - 2 * time));
    };
    return setup;
}

// The exact area is known at all times, the shape only at the start and at the end.
Setup dumbbell_to_a_hundredth(const Parameters& p) {
    static const Dumbbell first;
    static const double first_area = dumbbell_area(first);
    Setup setup = scheduled(p, 0.99 * first_area / (2 * pi), farthest_step * p.h * first.rounding);
    setup.outlines = {dumbbell(first, p.h)};
    setup.curvature = CurvatureMotion{};
    setup.exact = [](double time) {
        const double area = first_area - 2 * pi * time;
        // The curve approaches the disc of the exact area.
        ExactShape shape = exact_circle(first.centre, std::sqrt(area / pi));
        shape.area = area;
        shape.own_error = std::numeric_limits<double>::quiet_NaN();
        return shape;
    };
    return setup;
}

} // namespace

std::vector<Scene> curvature_scenes() {
    return {
        {.name = "curvature-circle",
         .description = "a circle shrinks by its curvature to half its area",
         .section = "13",
         .defaults = {.h = 0.015, .dt = 0},
         .prepare = circle_to_half},
        {.name = "curvature-dumbbell",
         .description =
             "a dumbbell shrinks by its curvature to a hundredth of its area, in one piece",
         .section = "13",
         .defaults = {.h = 0.01, .dt = 0},
         .prepare = dumbbell_to_a_hundredth},
    };
}

} // namespace dsc::scenes
