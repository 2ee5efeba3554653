// SPDX-License-Identifier: MIT
#include "combinations/tolerance.h"

#include "combinations/settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::combinations {

namespace {

using std::numbers::pi;

// All lengths below are in edge lengths, but for those of the scene.
const InterfaceThresholds upkeep;

// An arc of curvature k and its chord c are k c^2 / 8 apart in the middle and k c^2 / 12 on the
// average. Upkeep leaves no edge that is longer than `longest`, but for one by an end of a curve.
Tolerance chords(const Row& row, const Scene& scene) {
    double chord = upkeep.longest;
    double longest = upkeep.longest + upkeep.shortest;
    if (row.coarsening == Coarsening::never) {
        // No edge is merged: it is as long as at the start, and longer as the curve is.
        const double drawn = scene.longest_at_start * scene.stretch;
        if (drawn < 1) {
            const bool is_carried = !is_normal(row.motion) && !is_by_curvature(row.motion);
            chord = longest = is_carried ? 0 : drawn;
        }
    }
    const double bend = scene.curvature * scene.h;
    return {bend * chord * chord / 12, bend * longest * longest / 8};
}

// Corners that upkeep does not know, of 60 degrees at most (scene.cpp).
Tolerance loose_corners(const Row& row, const Scene& scene) {
    if (row.outline != Outline::loose_corners) {
        return {};
    }
    const double sine = std::sin(pi / 3);
    Tolerance of_corner; // an area and a distance
    if (row.coarsening != Coarsening::never) {
        // A corner with an edge shorter than `shortest` may go, if what takes the place of both its
        // edges is no longer than `longest`: so much is cut off.
        const double cut = upkeep.shortest * upkeep.longest * sine / 2;
        of_corner += {cut, 0};
    }
    if (row.insertion != Insertion::linear) {
        // A parabola through the ends of an edge c and the next vertex beyond the corner, at a
        // distance a, is c^2 sin / (4 (a + c)) off in the middle of c: most if c is the longest
        // edge and a the shortest. A vertex is put there, and so on both sides: a triangle each.
        const double off = sine / (4 * (upkeep.longest + upkeep.shortest));
        of_corner += {off * upkeep.longest, off};
    }
    return {of_corner.mean / (scene.corner_distance / scene.h), of_corner.farthest};
}

// Curvature flow gives the ends of curves on a wall a tension along it of 1e-9 (curve_network.h),
// so that no system is singular: over the time it moves them so far, where edges are of length 1.
double wall_tension(const Row& row, const Scene& scene) {
    return is_by_curvature(row.motion) ? 1e-9 * scene.end / (scene.h * scene.h) : 0;
}

// Whoever is held for a step lags behind by its way for ever. Half of the vertices are, among them
// all of a phase perhaps.
Tolerance lag(const Row& row, const Scene& scene) {
    if (row.interruption != Interruption::not_a_number) {
        return {};
    }
    const double dt = scene.end / scene.steps;
    double way = (scene.velocity ? scene.fastest : 1.0) * dt / scene.h;
    if (row.motion == Motion::swirl) {
        way *= pi * dt / 2; // the flow turns round at the beginning of this step
    }
    // A parabola overshoots such a step of the curve by an eighth of it...
    double farthest = way * (row.insertion == Insertion::linear ? 1 : 1.125);
    if (is_normal(row.motion)) {
        // ...and normals are turned there by half of its slope, over one edge: for the second half
        // of the run vertices move aslant.
        const double turn = std::atan(way / scene.longest_at_start) / 2;
        farthest += (1 - std::cos(turn)) * scene.end / 2 / scene.h;
    }
    return {row.phases == Phases::one ? way / 2 : way, farthest};
}

// Where pieces meet, the film between them goes once it is thinner than the contact distance. If it
// must not, sheets hold each other up as long as nothing between them is shorter than an edge that
// upkeep collapses.
Tolerance meeting(const Row& row, const Scene& scene, double length) {
    if (scene.seam == 0) {
        return {};
    }
    const bool may_change = row.topology != Rule::keep && row.topology != Rule::forbidden;
    const double thickness = may_change ? contact_of(row) : PhaseThresholds{}.shortest;
    // Of two phases each may have the whole film to its own side of the middle.
    const bool are_two = row.phases == Phases::junctions && !scene.meets_wall;
    const double film = thickness * scene.seam / scene.h / (are_two ? 2 : 1);
    double area = 0;
    if (!may_change || are_two) {
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

// Cells exchange neighbours at edges as short as the contact distance: half of the square over it
// changes hands. A cell has six corners on the average. That opens no film, so that nobody is asked
// whether it may.
Tolerance exchanges(const Row& row, double length) {
    if (row.phases != Phases::many || row.topology == Rule::keep) {
        return {};
    }
    const double contact = contact_of(row);
    return {6 * contact * contact / 2 / length, contact};
}

} // namespace

double rounding_of(const Scene& scene, std::size_t sub_steps, double epsilon) {
    const double size = std::max(scene.domain.high.x(), scene.domain.high.y()) / scene.h;
    return 2 * epsilon * size * static_cast<double>(sub_steps);
}

Tolerance tolerance_of(const Row& row, const Scene& scene, double length, std::size_t sub_steps,
                       double epsilon) {
    const double least = rounding_of(scene, sub_steps, epsilon) + wall_tension(row, scene);
    Tolerance all{least, least};
    all += chords(row, scene);
    all += loose_corners(row, scene);
    all += lag(row, scene);
    all += meeting(row, scene, length);
    all += exchanges(row, length);
    return all;
}

bool has_method_error(const Row& row) {
    return row.motion == Motion::turn || row.motion == Motion::swirl;
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
