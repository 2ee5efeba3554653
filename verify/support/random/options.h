// SPDX-License-Identifier: MIT
// Random options for the tests of the whole method, from the tables of all values of the enums: new
// values are drawn automatically.
#pragma once

#include "scene.h"

#include "dsc/passes/options.h"
#include "scenes/integrator_choice.h"
#include "topology/options.h"

#include <algorithm>
#include <cmath>

namespace dsc::test {

inline PhaseThresholds draw_phase(Dice& dice) {
    PhaseThresholds thresholds;
    thresholds.shortest = dice.in(0.0, 0.6);
    // A smaller value would only make the mesh larger.
    thresholds.longest = std::max(0.8, 2.05 * thresholds.shortest) + dice.in(0.0, 1.5);
    thresholds.crowded = dice.in(0.0, 2.0);
    thresholds.collapse_quality = dice.in(0.0, 0.6);
    thresholds.smooth_quality = dice.in(0.0, 1.0);
    return thresholds;
}

/// Numbers are drawn only for some scenes, because most applications keep the defaults.
inline InterfaceThresholds draw_interface(Dice& dice) {
    InterfaceThresholds interface;
    interface.coarsening = dice.one_of(coarsening_names);
    interface.reading = dice.one_of(reading_names);
    if (dice.chance(0.3)) {
        interface.shortest = dice.in(0.0, 0.8);
        interface.longest = 2.05 * interface.shortest + dice.in(0.1, 1.0);
        interface.deviation = dice.in(0.0, 0.3);
        interface.degenerate = dice.in(0.0, 10.0);
    }
    if (dice.chance(0.3)) {
        interface.feature_degrees = dice.in(1.0, 180.0);
    }
    if (dice.chance(0.5)) {
        interface.grading = dice.chance(0.3) ? 0.0 : dice.in(2.0, 8.0);
        interface.turn_degrees = dice.chance(0.4) ? 0.0 : dice.in(1.0, 180.0);
        interface.gap = dice.chance(0.4) ? 0.0 : dice.in(0.1, 4.0);
        interface.finest = dice.in(0.05, 1.0);
    }
    return interface;
}

/// All options of an application, in the ranges that check_options allows.
template <class Real>
Options<Real> draw_options(Dice& dice, double h) {
    Options<Real> options;
    options.edge_length = static_cast<Real>(h);
    const auto integrator = dice.one_of(scenes::integrator_choice_names);
    scenes::choose_integrator(options, integrator);
    options.insertion = dice.one_of(insertion_names);
    options.tolerance = std::pow(10.0, dice.in(-7.0, -1.0));
    options.interface = draw_interface(dice);
    options.max_sub_steps = 60;
    if (dice.chance(0.3)) {
        options.phases = draw_phase(dice);
    }
    if (dice.chance(0.2)) {
        options.per_phase = {draw_phase(dice), draw_phase(dice)};
    }
    if (dice.chance(0.3)) {
        options.sub_step = dice.in(0.05, 2.0);
        options.max_passes = dice.in(1, 32);
        options.max_idle_passes = dice.in(1, 8);
    }
    if (dice.chance(0.3)) {
        options.shuffle_seed = 17;
    }
    return options;
}

/// In half of the scenes the topology may change.
template <class Real>
void draw_topology(Dice& dice, double h, TopologyOptions<Real>& topology) {
    if (!dice.chance(0.5)) {
        return;
    }
    topology.rule = dice.one_of(topology_names);
    topology.opening = dice.one_of(opening_names);
    topology.contact = static_cast<Real>(dice.chance(0.5) ? 0.0 : dice.in(0.05, 0.75) * h);
    topology.min_area = static_cast<Real>(dice.chance(0.5) ? 0.0 : dice.in(0.1, 4.0) * h * h);
    if (dice.chance(0.5)) {
        topology.pairs.push_back({.one = 1,
                                  .other = dice.chance(0.5) ? exterior_phase : 2U,
                                  .rule = Topology::change,
                                  .contact = static_cast<Real>(dice.in(0.05, 0.75) * h)});
    }
    topology.gives_back_area = dice.chance(0.5);
}

} // namespace dsc::test
