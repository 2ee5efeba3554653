// SPDX-License-Identifier: MIT
// What an interface may run into: another one, the side of the domain, a junction.
#include "cases.h"
#include "scene.h"
#include "watch.h"

#include "dsc/complex/mesh_functions.h"
#include "scenes/exact.h"
#include "scenes/measure.h"
#include "scenes/shapes.h"
#include "scenes/velocity.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

const char* const shape_words = "symmetric difference to the exact shape, relative";

// Two discs, each driven at the other at a speed that vanishes nowhere.
HardResult pressed_case(double edges_a_step, const std::string& how) {
    HardResult result;
    result.asked = "two discs pressed together for 10,000 steps, topology kept, " + how;
    constexpr double h = 0.05;
    constexpr int steps = 10000;
    const std::vector<Outline> outlines{scenes::circle({0.28, 0.5}, 0.19, h),
                                        scenes::circle({0.72, 0.5}, 0.19, h)};
    auto scene = scene_of<double>(unit_square, outlines, h);
    Watch<double> watch(scene.complex, scene.options,
                        {.domain = unit_square, .thorough_every = 100}, result);
    const double speed = edges_a_step * h;
    const Velocity<double> press = [speed](std::span<const Point<double>> positions, double,
                                           std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {positions[i].x() < 0.5 ? speed : -speed, 0};
        }
    };
    const bool going = watch.run(press, 0, 1, steps);
    std::uint64_t in_contact = 0;
    for (std::uint32_t v = 0; v < scene.complex.vertex_bound(); ++v) {
        in_contact +=
            scene.complex.is_alive(Vertex{v}) && is_in_contact(scene.complex.vertices[v]) ? 1U : 0U;
    }
    const auto pieces = scenes::interface_outlines(scene.complex);
    result.values = {
        {"vertices in contact at the end", static_cast<double>(in_contact)},
        {"passes of the last step", static_cast<double>(watch.last().passes)},
        {"triangles at the end", static_cast<double>(scene.complex.triangle_count())},
        {"area left, relative", scenes::signed_area(pieces) / scenes::signed_area(outlines)}};
    result.happened = std::to_string(in_contact) + " vertices end in contact; " +
                      std::to_string(result.unreached) +
                      " targets, summed over all steps, were not reached, each of them counted";
    expect(result, going, "the run ended early");
    expect(result, result.steps == steps, "not all steps were done");
    expect(result, result.unreached > 0, "nothing was in the way");
    expect(result, in_contact > 0, "nobody is in contact");
    expect(result, result.held == 0, "vertices were held though all velocities are finite");
    expect(result, pieces.size() == 2, "the topology was not kept");
    expect(result, scene.complex.triangle_count() < 20000, "the mesh grows without a bound");
    expect_sound(result, Targets::may_be_missed);
    return result;
}

struct WallEdges {
    double shortest = std::numeric_limits<double>::max();
    double longest = 0;
    double off_wall = 0; ///< largest distance of a boundary vertex from the sides of the domain
};

WallEdges wall_edges(const Scene<double>& scene) {
    WallEdges wall;
    const auto& complex = scene.complex;
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        if (!complex.is_alive(Triangle{t})) {
            continue;
        }
        for (const Edge e : complex.edges_of(Triangle{t})) {
            if (!is_boundary(complex, e)) {
                continue;
            }
            const auto v = complex.vertices_of(e);
            const Point<double> p = complex.position(v[0]);
            const Point<double> q = complex.position(v[1]);
            wall.shortest = std::min(wall.shortest, (q - p).norm());
            wall.longest = std::max(wall.longest, (q - p).norm());
            for (const Point<double>& a : {p, q}) {
                const double off = std::min((a - scene.domain.low).cwiseAbs().minCoeff(),
                                            (a - scene.domain.high).cwiseAbs().minCoeff());
                wall.off_wall = std::max(wall.off_wall, off);
            }
        }
    }
    return wall;
}

// A phase that fills a strip from side to side; the outline lies on the sides of the domain.
HardResult wall_case(double shear, double shift) {
    HardResult result;
    result.asked = shear != 0 ? "a strip from wall to wall is sheared: its ends slide along the "
                                "walls by seven edge lengths either way"
                              : "a strip from wall to wall goes six edge lengths along the walls";
    const Rectangle domain{{0, 0}, {2, 1}};
    constexpr int columns = 40;
    constexpr double h = 2.0 / columns;
    constexpr double left = 0.8;
    constexpr double right = 1.1;
    auto scene = grid_scene(domain, columns, columns / 2, [](const Point<double>& p) {
        return p.x() > left && p.x() < right ? Phase{1} : exterior_phase;
    });
    Watch<double> watch(scene.complex, scene.options, {.domain = domain}, result);
    const Velocity<double> velocity = [&](std::span<const Point<double>> positions, double,
                                          std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {shift + shear * (positions[i].y() - 0.5), 0};
        }
    };
    const std::vector<Outline> outlines{{{left, 0}, {right, 0}, {right, 1}, {left, 1}}};
    constexpr int steps = 50;
    const bool going = watch.run(velocity, 0, 1.0 / steps, steps);
    result.error =
        shape_error<double>(scene.complex, mapped(outlines, [&](const Point<double>& p) {
                                return Point<double>(p.x() + shift + shear * (p.y() - 0.5), p.y());
                            }));
    result.error_is = shape_words;
    const double area_error = std::abs(domain_area(scene.complex) - 2.0) / 2;
    const WallEdges wall = wall_edges(scene);
    result.values = {{"domain area, relative error", area_error},
                     {"boundary vertices off the wall, at most", wall.off_wall},
                     {"shortest edge of the wall, in h", wall.shortest / h},
                     {"longest edge of the wall, in h", wall.longest / h}};
    result.happened = "its ends slide; edges of the wall end between " + text(wall.shortest / h) +
                      " and " + text(wall.longest / h) + " edge lengths";
    expect(result, going, "the run ended early");
    expect(result, wall.off_wall == 0, "a boundary vertex left the wall");
    expect(result, area_error < 1e-13, "the domain's area changed");
    expect(result, *result.error < 1e-9, "error " + text(*result.error) + ", allowed 1e-9");
    expect(result, wall.longest < 2 * h, "the wall was not refined");
    expect(result, wall.shortest > 0.2 * h, "the wall was not coarsened");
    expect_sound(result, Targets::reachable);
    return result;
}

// A square of two halves in two phases, with phase 0 about them: two junctions of three phases.
HardResult junction_case(const scenes::Velocity& velocity, const std::string& motion,
                         const std::function<Point<double>(const Point<double>&)>& exact) {
    HardResult result;
    result.asked = "a square whose halves are of two phases, with two junctions, is " + motion;
    constexpr int columns = 40;
    auto scene = grid_scene(unit_square, columns, columns, [](const Point<double>& p) {
        if (p.x() < 0.3 || p.x() > 0.6 || p.y() < 0.3 || p.y() > 0.6) {
            return exterior_phase;
        }
        return p.x() < 0.45 ? Phase{1} : Phase{2};
    });
    const std::vector<Outline> halves{{{0.3, 0.3}, {0.45, 0.3}, {0.45, 0.6}, {0.3, 0.6}},
                                      {{0.45, 0.3}, {0.6, 0.3}, {0.6, 0.6}, {0.45, 0.6}}};
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square, .thorough_every = 5},
                        result);
    constexpr int steps = 200;
    const bool going = watch.run(velocity, 0, 1.0 / steps, steps);
    const auto moved = mapped(halves, exact);
    double worst = 0;
    for (Phase phase = 1; phase <= 2; ++phase) {
        const double error = shape_error(scene.complex, phase, moved[phase - 1]);
        result.values.push_back({"error of phase " + std::to_string(phase), error});
        worst = std::max(worst, error);
    }
    result.error = worst;
    result.error_is = std::string(shape_words) + ", of the worse phase";
    result.happened = "the junctions move with the flow, and each phase keeps its shape";
    expect(result, going, "the run ended early");
    expect(result, worst < 1e-7, "error " + text(worst) + ", allowed 1e-7");
    expect_sound(result, Targets::reachable);
    return result;
}

HardResult junction_translation() {
    return junction_case(scenes::Translation{{0.3, 0.2}}, "translated",
                         [](const auto& p) { return Point<double>(p + Point<double>(0.3, 0.2)); });
}

HardResult junction_rotation() {
    return junction_case(scenes::Rotation{{0.5, 0.5}, 2 * std::numbers::pi},
                         "turned once about the middle of the domain",
                         [](const auto& p) { return p; });
}

} // namespace

void append_contacts(std::vector<HardCase>& cases) {
    cases.push_back({"pressed-slowly", false,
                     [] { return pressed_case(4e-4, "by four edge lengths in all, each"); }});
    cases.push_back({"pressed-flat", false,
                     [] { return pressed_case(0.3, "by 0.3 edge lengths a step, for ever"); }});
    cases.push_back({"wall-translation", false, [] { return wall_case(0, 0.3); }});
    cases.push_back({"wall-shear", false, [] { return wall_case(0.7, 0); }});
    cases.push_back({"junction-translation", false, junction_translation});
    cases.push_back({"junction-rotation", false, junction_rotation});
}

} // namespace dsc::hard
