// SPDX-License-Identifier: MIT
#include "geometric_flows/curvature_flow.h"

#include "dsc/base/error.h"
#include "geometric_flows/curve_network.h"
#include "geometric_flows/kept_areas.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace dsc {

namespace {

std::pair<Phase, Phase> key_of(const PairCurvature& pair) {
    return std::minmax(pair.one, pair.other);
}

[[noreturn]] void refuse_forces(const std::string& what, const std::string& value,
                                const std::string& allowed) {
    throw InputError({.what = what, .where = "curvature_flow", .value = value, .allowed = allowed});
}

std::string name_of(const PairCurvature& pair) {
    return std::to_string(pair.one) + " and " + std::to_string(pair.other);
}

void check_forces(double tension, double mobility, const std::string& whose) {
    if (!std::isfinite(tension) || tension < 0) {
        refuse_forces("tension of " + whose + " is not an energy", std::to_string(tension),
                      "finite and 0 or more");
    }
    if (!std::isfinite(mobility) || !(mobility > 0)) {
        refuse_forces("mobility of " + whose + " is out of range", std::to_string(mobility),
                      "finite and above 0");
    }
}

/// Checks the options, and sorts the lists.
CurvatureFlowOptions checked(CurvatureFlowOptions options) {
    check_forces(options.tension, options.mobility, "all pairs");
    for (const PairCurvature& pair : options.pairs) {
        check_forces(pair.tension, pair.mobility, "phases " + name_of(pair));
        if (pair.one == pair.other || pair.one == border_phase || pair.other == border_phase) {
            refuse_forces("there is no interface between these phases", name_of(pair),
                          "two different phases of the domain");
        }
    }
    std::ranges::sort(options.pairs, {}, key_of);
    const auto twice = std::ranges::adjacent_find(options.pairs, {}, key_of);
    if (twice != options.pairs.end()) {
        refuse_forces("a pair of phases is given twice", name_of(*twice), "each pair once");
    }
    std::ranges::sort(options.walls, {}, &WallEnergy::phase);
    for (const WallEnergy& wall : options.walls) {
        if (wall.phase == border_phase || !std::isfinite(wall.energy)) {
            refuse_forces("not an energy of the wall under phase " + std::to_string(wall.phase),
                          std::to_string(wall.energy),
                          "a finite energy under a phase of the domain");
        }
    }
    const auto wall_twice = std::ranges::adjacent_find(options.walls, {}, &WallEnergy::phase);
    if (wall_twice != options.walls.end()) {
        refuse_forces("a phase has two energies of the wall", std::to_string(wall_twice->phase),
                      "each phase once");
    }
    std::ranges::sort(options.kept_areas, {}, &KeptArea::phase);
    for (const KeptArea& kept : options.kept_areas) {
        if (kept.phase == exterior_phase || kept.phase == border_phase) {
            refuse_forces("the area of this phase cannot be kept", std::to_string(kept.phase),
                          "a phase of the domain other than the exterior");
        }
        if (!std::isfinite(kept.area) || !(kept.area > 0)) {
            refuse_forces("not an area to be kept", std::to_string(kept.area),
                          "finite and above 0");
        }
    }
    const auto same = std::ranges::adjacent_find(options.kept_areas, {}, &KeptArea::phase);
    if (same != options.kept_areas.end()) {
        refuse_forces("an area is kept twice", std::to_string(same->phase), "each phase once");
    }
    return options;
}

EdgeForces forces_between(const CurvatureFlowOptions& options, Phase left, Phase right) {
    const std::pair<Phase, Phase> key = std::minmax(left, right);
    const auto found = std::ranges::lower_bound(options.pairs, key, {}, key_of);
    return found != options.pairs.end() && key_of(*found) == key
               ? EdgeForces{.tension = found->tension, .drag = 1 / found->mobility}
               : EdgeForces{.tension = options.tension, .drag = 1 / options.mobility};
}

double wall_energy(const CurvatureFlowOptions& options, Phase phase) {
    const auto found = std::ranges::lower_bound(options.walls, phase, {}, &WallEnergy::phase);
    return found != options.walls.end() && found->phase == phase ? found->energy : 0.0;
}

/// One step and two of half the length; their errors of first order cancel in twice the one minus
/// the other, which is still damped for stiff modes.
std::vector<Point<double>> extrapolated(const CurveNetwork& network, std::span<const KeptArea> kept,
                                        double dt) {
    CurveSystem system(network);
    const auto step = [&](std::span<const Point<double>> positions, double time) {
        std::vector<Point<double>> way = system.step(positions, time);
        if (!kept.empty()) {
            keep_areas(network, kept, positions, way, &system);
        }
        return way;
    };
    const std::span<const Point<double>> start = network.positions;
    const std::vector<Point<double>> whole = step(start, dt);
    std::vector<Point<double>> halves = step(start, dt / 2);
    std::vector<Point<double>> middle(start.begin(), start.end());
    for (std::size_t i = 0; i < middle.size(); ++i) {
        middle[i] += halves[i];
    }
    const std::vector<Point<double>> second = step(middle, dt / 2);
    for (std::size_t i = 0; i < halves.size(); ++i) {
        halves[i] = 2 * (halves[i] + second[i]) - whole[i];
    }
    if (!kept.empty()) {
        keep_areas(network, kept, start, halves, nullptr);
    }
    return halves;
}

} // namespace

template <class Real>
InterfaceMotion<Real> curvature_flow(const CurvatureFlowOptions& options) {
    return [options = checked(options)](const InterfaceView<Real>& view, Real, Real dt,
                                        std::span<Point<Real>> displacements) {
        const CurveNetwork network = curve_network(
            view, [&](Phase left, Phase right) { return forces_between(options, left, right); },
            [&](Phase phase) { return wall_energy(options, phase); });
        const std::vector<Point<double>> ways =
            extrapolated(network, options.kept_areas, static_cast<double>(dt));
        for (std::size_t i = 0; i < ways.size(); ++i) {
            displacements[i] = ways[i].template cast<Real>();
        }
    };
}

template InterfaceMotion<double> curvature_flow(const CurvatureFlowOptions&);
template InterfaceMotion<float> curvature_flow(const CurvatureFlowOptions&);

} // namespace dsc
