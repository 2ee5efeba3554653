// SPDX-License-Identifier: MIT
// Outlines with tiny angles, and grids in which every test is nearly a tie.
#include "scene.h"
#include "watch.h"

#include "support/random/scene.h"

#include "flows/exact.h"
#include "flows/velocity.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

// One revolution about the middle.
HardResult turned(const Outline& outline, double h, const std::string& asked, double allowed) {
    constexpr int steps = 200;
    return advect({.asked = asked,
                   .outlines = {outline},
                   .h = h,
                   .flow = scenes::Rotation{{0.5, 0.5}, 2 * std::numbers::pi},
                   .dt = 1.0 / steps,
                   .steps = steps,
                   .exact = {outline},
                   .allowed = allowed,
                   .happened = "turns once and keeps its shape",
                   .thorough_every = 5});
}

const double tenth_of_a_degree = 0.1 * std::numbers::pi / 180;

Point<double> tilted(double along, double across) {
    // Rotated by 30 degrees, so that the bounding box of a thin shape is not thin.
    const double c = std::numbers::sqrt3 / 2;
    const double s = 0.5;
    return {0.5 + c * along - s * across, 0.5 + s * along + c * across};
}

HardResult needle_case() {
    const double width = 0.6 * std::tan(tenth_of_a_degree);
    return turned({tilted(-0.3, 0), tilted(0.3, -width / 2), tilted(0.3, width / 2)}, 0.05,
                  "a needle as input: a triangle with an angle of 0.1 degrees, a fiftieth of an "
                  "edge wide, turned once",
                  1e-3);
}

HardResult cap_case() {
    const double height = 0.3 * std::tan(tenth_of_a_degree);
    return turned({tilted(-0.3, 0), tilted(0.3, 0), tilted(0, height)}, 0.05,
                  "a cap as input: a triangle with two angles of 0.1 degrees, turned once", 1e-3);
}

HardResult flat_vertices_case() {
    // A square whose sides have vertices with tiny turns to either side.
    Outline outline;
    const std::vector<Point<double>> corners{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Point<double>& a = corners[k];
        const Point<double>& b = corners[(k + 1) % 4];
        const Point<double> normal = Point<double>(b.y() - a.y(), a.x() - b.x()).normalized();
        for (int i = 0; i < 8; ++i) {
            const double bump = i == 0 ? 0 : (i % 2 == 0 ? 1e-13 : -1e-13);
            outline.push_back(a + (b - a) * (i / 8.0) + bump * normal);
        }
    }
    return turned(outline, 0.05, "a square whose sides have vertices 1e-13 off them, turned once",
                  1e-6);
}

// Perturbs a coordinate by units in the last place, or by a distance.
struct Perturbation {
    int ulps = 0;
    double distance = 0;
};

double nudged(double value, const Perturbation& by, test::Dice& dice) {
    const int ulps = dice.in(-by.ulps, by.ulps);
    for (int i = 0; i < std::abs(ulps); ++i) {
        value = std::nextafter(value, ulps > 0 ? 2.0 : -2.0);
    }
    return value + by.distance * dice.in(-1.0, 1.0);
}

// Up to the perturbation, the corners of a grid's square are cocircular and its lines straight; the
// sides of the domain stay straight. A square phase moves by whole grid spacings, so that its
// vertices return to the grid.
HardResult grid_case(const Perturbation& by, const std::string& how) {
    HardResult result;
    result.asked = "a grid, cocircular and collinear " + how + ", with a square moved in it";
    constexpr int columns = 20;
    constexpr double h = 1.0 / columns;
    test::Dice dice(7);
    auto scene = grid_scene(
        unit_square, columns, columns,
        [](const Point<double>& p) {
            const bool inside = (p - Point<double>(0.35, 0.5)).cwiseAbs().maxCoeff() < 0.15;
            return inside ? Phase{1} : exterior_phase;
        },
        [&](const Point<double>& p) {
            const bool on_side = p.minCoeff() == 0 || p.maxCoeff() == 1;
            return on_side ? p : Point<double>(nudged(p.x(), by, dice), nudged(p.y(), by, dice));
        });
    // The exact outlines include the perturbation.
    const auto first = scenes::interface_outlines(scene.complex);
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square}, result);
    // Moves right, up, and diagonally back to the start: by 4 edges along an axis, in 8 steps each.
    std::uint64_t flips = 0;
    bool going = true;
    const std::vector<Point<double>> legs{{1, 0}, {0, 1}, {-1, -1}};
    double time = 0;
    for (const auto& leg : legs) {
        for (int i = 0; i < 8 && going; ++i, time += h / 2) {
            going = watch.step(scenes::Translation{leg}, time, h / 2);
            flips += watch.last().operations.flips;
        }
    }
    note_error(result, shape_error<double>(scene.complex, first), 1e-11);
    result.happened =
        text(static_cast<double>(flips)) + " flips in 24 steps: ties do not flip back and forth";
    // Each of the 24 vertices passes four grid squares, with a few flips in each.
    expect(result, flips < 6000, text(static_cast<double>(flips)) + " flips");
    expect_sound(result, Targets::reachable);
    return result;
}

// An outline whose vertices lie on a circle up to a perturbation, and a mesh that is built on it.
HardResult circle_case(const Perturbation& by, const std::string& how) {
    test::Dice dice(11);
    Outline outline = scenes::circle({0.5, 0.5}, 0.25, 0.05);
    for (auto& p : outline) {
        p = {nudged(p.x(), by, dice), nudged(p.y(), by, dice)};
    }
    return turned(outline, 0.05, "vertices on a circle, " + how + ", turned once", 1e-6);
}

} // namespace

void append_degenerate(std::vector<HardCase>& cases) {
    cases.push_back({"needle", needle_case});
    cases.push_back({"cap", cap_case});
    cases.push_back({"flat-vertices", flat_vertices_case});
    const auto add = [&](const std::string& suffix, const Perturbation& by,
                         const std::string& how) {
        cases.push_back({"grid-" + suffix, [=] { return grid_case(by, how); }});
        cases.push_back({"cocircular-" + suffix, [=] { return circle_case(by, how); }});
    };
    add("exact", {}, "exactly");
    for (const int ulps : {1, 2, 10}) {
        add(std::to_string(ulps) + "ulp", {.ulps = ulps}, "up to " + std::to_string(ulps) + " ulp");
    }
    for (const double distance : {1e-15, 1e-14, 1e-13, 1e-12}) {
        add(text(distance), {.distance = distance}, "up to " + text(distance));
    }
}

} // namespace dsc::hard
