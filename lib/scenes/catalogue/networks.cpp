// SPDX-License-Identifier: MIT
// Networks of curves that move by their curvature: three phases at a junction, junctions that
// exchange their neighbours (T1), grains that grow and vanish, foams with constant areas.
#include "flows/exact.h"
#include "flows/junction_solutions.h"
#include "scenes/catalogue/families.h"
#include "shapes/voronoi.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

// --- a lens -------------------------------------------------------------------------------------

// The upper half of a circle from right to left, or the lower one from left to right; both ends are
// at the height of the centre, exactly.
std::vector<Point<double>> half_circle(const Point<double>& centre, double radius, bool is_upper,
                                       double edge_length) {
    const int n = std::max(4, static_cast<int>(std::ceil(pi * radius / edge_length)));
    const double side = is_upper ? 1 : -1;
    std::vector<Point<double>> points;
    points.emplace_back(centre.x() + side * radius, centre.y());
    for (int i = 1; i < n; ++i) {
        const double angle = pi * i / n;
        points.emplace_back(centre.x() + side * radius * std::cos(angle),
                            centre.y() + side * radius * std::sin(angle));
    }
    points.emplace_back(centre.x() - side * radius, centre.y());
    return points;
}

Setup disc_between_half_planes(const Parameters& p) {
    static constexpr double radius = 0.2;
    static const Point<double> centre(0.5, 0.5);
    enum : Phase { disc = 1, below = 2, above = 3 };
    const Point<double> across(radius, 0);
    Setup setup = scheduled(p, 0.3, 0.05 * p.h);
    setup.curves = {{half_circle(centre, radius, true, p.h), disc, above},
                    {half_circle(centre, radius, false, p.h), disc, below},
                    {{{0, centre.y()}, centre - across}, above, below},
                    {{centre + across, {1, centre.y()}}, above, below}};
    setup.measured = disc;
    setup.curvature = CurvatureMotion{.keeps = {disc, below}};
    // The shape is a disc at the start and the lens at the end; in between it is unknown.
    setup.exact = [](double time) {
        return time > 0 ? lens_shape({.centre = centre, .area = pi * radius * radius})
                        : exact_circle(centre, radius);
    };
    return setup;
}

// --- four sectors -------------------------------------------------------------------------------

Setup four_sectors(const Parameters& p) {
    enum : Phase { right = 1, above = 2, left = 3, below = 4 };
    static const Point<double> origin(0, 0);
    const double theta = p.angle * pi / 180;
    const double slope = std::tan(theta);
    // Ends when the opening edge is 12 edge lengths long.
    Setup setup = scheduled(p, std::pow(12 * p.h / opening_factor(theta), 2), 0.1 * p.h * p.h);
    setup.domain = {{-0.5, -0.6}, {0.5, 0.6}};
    const auto ray = [&](double x, double y, Phase on_its_left, Phase on_its_right) {
        setup.curves.push_back({{origin, {x, y}}, on_its_left, on_its_right});
    };
    ray(0.5, 0.5 * slope, above, right);
    ray(-0.5, 0.5 * slope, left, above);
    ray(-0.5, -0.5 * slope, below, left);
    ray(0.5, -0.5 * slope, right, below);
    setup.clamped = true; // the outer ends of the rays stay
    setup.measured = right;
    setup.curvature = CurvatureMotion{};
    setup.exact = [theta, box = setup.domain](double time) {
        return right_sector({origin, theta}, time, box);
    };
    return setup;
}

// --- grains and bubbles -------------------------------------------------------------------------

/// Edges of the first network that are shorter than this, in edge lengths, are contracted.
constexpr double shortest = 0.3;

// The number given, or the number of cells with this diameter in edge lengths.
std::uint32_t count_of(const Parameters& p, double diameter) {
    return p.grains > 0 ? static_cast<std::uint32_t>(p.grains)
                        : static_cast<std::uint32_t>(
                              std::max(4.0, std::round(1 / std::pow(diameter * p.h, 2))));
}

std::vector<dsc::Curve> network(const Parameters& p, std::uint32_t count, int rounds) {
    const auto sites = relaxed_sites({}, random_sites({}, count, 1), rounds);
    return voronoi_curves({}, sites, shortest * p.h);
}

Setup voronoi_grains(const Parameters& p) {
    static constexpr double diameter = 10;
    const std::uint32_t count = count_of(p, diameter);
    // The mean area grows by about this much per unit of time; about half of the grains are left at
    // the end.
    static constexpr double growth = 1;
    Setup setup = scheduled(p, 2.0 / count / growth, 0.2 * p.h * p.h);
    // The sites are not relaxed: the areas of such cells vary nearly as much as those of grains
    // that have grown for a long time, so the mean area is linear in time almost from the start.
    setup.curves = network(p, count, 0);
    setup.curvature = CurvatureMotion{};
    return setup;
}

Setup voronoi_foam(const Parameters& p) {
    static constexpr double diameter = 12;
    const std::uint32_t count = count_of(p, diameter);
    Setup setup = scheduled(p, 1.0 / count, 0.2 * p.h * p.h);
    setup.curves = network(p, count, 1);
    CurvatureMotion motion;
    for (Phase bubble = 1; bubble < count; ++bubble) { // the last one fills the rest
        motion.keeps.push_back(bubble);
    }
    setup.curvature = motion;
    return setup;
}

} // namespace

std::vector<Scene> network_scenes() {
    // Curvature flow smooths every feature at once: none is kept.
    const InterfaceThresholds smooth{.feature_degrees = 180};
    return {
        {.name = "three-phases",
         .description = "a disc between two half-planes becomes a lens with angles of 120 degrees",
         .section = "13",
         .defaults = {.h = 0.02, .dt = 0, .interface = smooth},
         .prepare = disc_between_half_planes},
        {.name = "t1",
         .description =
             "a junction of four sectors splits: an edge opens between two new junctions",
         .section = "13",
         .defaults =
             {.h = 0.0125, .dt = 0, .angle = 40, .interface = smooth, .topology = Topology::change},
         .prepare = four_sectors,
         .keys = common_keys({"angle"})},
        {.name = "grains",
         .description = "grains from random sites grow and vanish by the curvature of their sides",
         .section = "13",
         .defaults = {.h = 0.01, .dt = 0, .interface = smooth, .topology = Topology::change},
         .prepare = voronoi_grains,
         .keys = common_keys({"grains"})},
        {.name = "foam",
         .description = "bubbles that keep their areas come to rest",
         .section = "13",
         .defaults = {.h = 0.016, .dt = 0, .interface = smooth, .topology = Topology::change},
         .prepare = voronoi_foam,
         .keys = common_keys({"grains"})},
    };
}

} // namespace dsc::scenes
