// SPDX-License-Identifier: MIT
#include "combinations/tolerance.h"

#include "combinations/settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::combinations {

namespace {

// All lengths below are in edge lengths, but for those of the scene.
const InterfaceThresholds upkeep;

// Coordinates are rounded when a target is found and when it is reached: by half a unit in the last
// place of the largest one, twice, in either direction. Curvature flow gives the ends of curves on
// a wall a tension along it of 1e-9 (curve_network.h), so that no system is singular: over the time
// it moves them so far, where edges are of length 1.
double rounding(const Row& row, const Scene& scene, std::size_t sub_steps) {
    const double epsilon = row.precision == Precision::in_double
                               ? std::numeric_limits<double>::epsilon()
                               : std::numeric_limits<float>::epsilon();
    const double size = std::max(scene.domain.high.x(), scene.domain.high.y()) / scene.h;
    const double wall_tension = is_by_curvature(row) ? 1e-9 * scene.end / (scene.h * scene.h) : 0;
    return 2 * epsilon * size * static_cast<double>(sub_steps) + wall_tension;
}

// An arc of curvature k and its chord c are k c^2 / 8 apart in the middle and k c^2 / 12 on the
// average. Upkeep leaves no edge that is longer than `longest`, but for one by an end of a curve.
Tolerance chords(const Row& row, const Scene& scene) {
    double chord = upkeep.longest;
    double longest = upkeep.longest + upkeep.shortest;
    // If no edge is merged, it is as long as at the start, and longer as the curve is.
    const double drawn = scene.longest_at_start * scene.stretch;
    if (row.coarsening == Coarsening::never && drawn < 1) {
        chord = longest = is_normal(row) || is_by_curvature(row) ? drawn : 0;
    }
    const double bend = scene.curvature * scene.h;
    return {bend * chord * chord / 12, bend * longest * longest / 8};
}

// Where pieces meet, the film between them goes once it is thinner than the contact distance. If it
// must not, sheets hold each other up as long as nothing between them is shorter than an edge that
// upkeep collapses.
Tolerance meeting(const Row& row, const Scene& scene, double length) {
    if (scene.seam == 0) {
        return {};
    }
    const double thickness = may_change(row) ? contact_of(row) : PhaseThresholds{}.shortest;
    // Of two phases each may have the whole film to its own side of the middle.
    const bool are_two = row.phases == Phases::junctions && !scene.meets_wall;
    const double film = thickness * scene.seam / scene.h / (are_two ? 2 : 1);
    double area = 0;
    if (!may_change(row) || are_two) {
        area += film; // it stays, or what takes it is one of two
    }
    if (row.topology == Rule::given_back) {
        area += film; // and is found elsewhere
    }
    // At either end of the seam a wedge is left, which goes as well as far as a triangle across it
    // is no higher than the film. One of its edges may lie along a sheet or the wall, and be as
    // long as any there...
    const double edge = scene.meets_wall ? PhaseThresholds{}.longest : upkeep.longest;
    area += thickness * std::max(edge, thickness); // half of it at either end
    // ...and from then on two phases, or a sheet and the wall, meet at its far end.
    const double sideways = are_two || scene.meets_wall ? edge * std::sin(scene.seam_angle) : 0;
    return {area / length, std::max(thickness, sideways)};
}

} // namespace

Tolerance tolerance_of(const Row& row, const Scene& scene, double length, std::size_t sub_steps) {
    const double least = rounding(row, scene, sub_steps);
    Tolerance all{least, least};
    all += chords(row, scene);
    all += meeting(row, scene, length);
    return all;
}

Point<double> by_method(const Row& row, const Scene& scene, std::span<const double> times,
                        const Point<double>& start) {
    using P = Point<double>;
    using scenes::IntegratorChoice;
    const IntegratorChoice method =
        row.told == Told::motion ? IntegratorChoice::rk4 : row.integrator;
    const auto& v = scene.velocity;
    P p = start;
    P way(0, 0);
    double dt_before = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = times[i];
        const double dt = (i + 1 < times.size() ? times[i + 1] : scene.end) - t;
        const double middle = t + dt / 2;
        const P first = v(p, t);
        const P second = v(P(p + dt / 2 * first), middle);
        P next = dt * second;
        switch (method) {
        case IntegratorChoice::euler: next = dt * first; break;
        case IntegratorChoice::midpoint: break;
        case IntegratorChoice::centred:
            if (dt_before > 0) {
                const double ratio = dt / dt_before;
                next = (1 + ratio) * dt * first - ratio * ratio * way;
            }
            break;
        case IntegratorChoice::rk4:
        case IntegratorChoice::adaptive: {
            const P third = v(P(p + dt / 2 * second), middle);
            const P fourth = v(P(p + dt * third), t + dt);
            next = dt / 6 * (first + 2 * second + 2 * third + fourth);
        }
        }
        p += next;
        way = next;
        dt_before = dt;
    }
    return p;
}

} // namespace dsc::combinations
