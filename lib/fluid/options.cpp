// SPDX-License-Identifier: MIT
#include "fluid/options.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

bool is_of_pair(const FluidTension& pair, Phase one, Phase other) {
    return (pair.one == one && pair.other == other) || (pair.one == other && pair.other == one);
}

std::string name_of_pair(Phase one, Phase other) {
    return "phases " + to_text(one) + " and " + to_text(other);
}

void check_phases(const std::vector<FluidPhase>& phases) {
    for (auto p = phases.begin(); p != phases.end(); ++p) {
        const std::string name = "phase " + to_text(p->phase);
        require(std::isfinite(p->density) && p->density >= 0, "density of " + name, p->density,
                "0 or more");
        require(std::isfinite(p->viscosity) && p->viscosity > 0, "viscosity of " + name,
                p->viscosity, "above 0");
        if (std::any_of(phases.begin(), p,
                        [&](const FluidPhase& q) { return q.phase == p->phase; })) {
            throw InputError({.what = "a phase is given twice",
                              .where = "FluidOptions::phases",
                              .value = name,
                              .allowed = "each phase once"});
        }
    }
}

void check_tensions(const FluidOptions& options) {
    const std::vector<FluidTension>& tensions = options.tensions;
    for (auto t = tensions.begin(); t != tensions.end(); ++t) {
        const std::string name = name_of_pair(t->one, t->other);
        require(std::isfinite(t->tension) && t->tension >= 0, "tension of " + name, t->tension,
                "0 or more");
        require(t->contact_angle > 0 && t->contact_angle < 180, "contact angle of " + name,
                t->contact_angle, "above 0 and below 180 degrees");
        (void)fluid_of(options, t->one);
        (void)fluid_of(options, t->other);
        if (t->one == t->other) {
            throw InputError({.what = "a tension names one phase twice",
                              .where = "FluidOptions::tensions",
                              .value = name,
                              .allowed = "two different phases"});
        }
        if (std::any_of(tensions.begin(), t, [&](const FluidTension& other) {
                return is_of_pair(other, t->one, t->other);
            })) {
            throw InputError({.what = "a pair is given twice",
                              .where = "FluidOptions::tensions",
                              .value = name,
                              .allowed = "each pair once"});
        }
    }
}

void check_sides(const FluidOptions& options) {
    const std::vector<FluidSide>& sides = options.sides;
    for (auto side = sides.begin(); side != sides.end(); ++side) {
        const auto refuse = [&](const char* what, const char* allowed) {
            throw InputError({.what = what,
                              .where = "FluidOptions::sides",
                              .value = "side '" + side->name + "'",
                              .allowed = allowed});
        };
        if (std::any_of(sides.begin(), side,
                        [&](const FluidSide& other) { return other.name == side->name; })) {
            refuse("a side is given twice", "each side once");
        }
        if (side->velocity && side->inflow) {
            refuse("a side has both a velocity and an inflow", "one of them");
        }
        if (side->wall != Wall::no_slip && (side->velocity || side->inflow)) {
            refuse("a velocity is given on a side that slips or is open",
                   "Wall::no_slip with a velocity or an inflow");
        }
    }
    if (!sides.empty() && options.wall_at) {
        throw InputError({.what = "walls are given both by name and by a function",
                          .where = "FluidOptions::sides",
                          .value = "wall_at",
                          .allowed = "either sides or wall_at"});
    }
}

} // namespace

void check_fluid(const FluidOptions& options) {
    check_phases(options.phases);
    if (!options.phases.empty() && std::ranges::all_of(options.phases, &FluidPhase::is_void)) {
        throw InputError({.what = "all phases are void, so there is nothing to solve for",
                          .where = "FluidOptions::phases",
                          .value = "only voids",
                          .allowed = "a phase with fluid"});
    }
    check_tensions(options);
    check_sides(options);
    require(std::isfinite(options.gravity.x()), "gravity, x", options.gravity.x(), "finite");
    require(std::isfinite(options.gravity.y()), "gravity, y", options.gravity.y(), "finite");
    require(options.implicitness >= 0.5 && options.implicitness <= 1, "implicitness",
            options.implicitness, "0.5 to 1");
    require(options.tolerance >= 0 && options.tolerance <= 1, "tolerance of a fluid",
            options.tolerance, "0 to 1");
    require(options.threads >= 1 && options.threads <= 1024, "threads of a fluid", options.threads,
            "1 to 1024");
}

const FluidPhase& fluid_of(const FluidOptions& options, Phase phase) {
    const auto found = std::ranges::find(options.phases, phase, &FluidPhase::phase);
    if (found == options.phases.end()) {
        throw InputError({.what = "a phase has no density and viscosity",
                          .where = "FluidOptions::phases",
                          .value = "phase " + to_text(phase),
                          .allowed = "properties for each phase"});
    }
    return *found;
}

const FluidTension& pair_of(const FluidOptions& options, Phase one, Phase other) {
    const auto found = std::ranges::find_if(
        options.tensions, [&](const FluidTension& pair) { return is_of_pair(pair, one, other); });
    if (found == options.tensions.end()) {
        throw InputError({.what = "two phases meet, but their interface has no tension",
                          .where = "FluidOptions::tensions",
                          .value = name_of_pair(one, other),
                          .allowed = "a tension, or 0, for each pair that meets"});
    }
    return *found;
}

} // namespace dsc
