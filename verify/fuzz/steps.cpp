// SPDX-License-Identifier: MIT
// A random scene for a few steps, by any strategy and with options from the lists of all values:
// each step ends, with a valid complex, a list of exactly the interface's vertices, and a log that
// gives the same complex when it is replayed.
#include "fuzz/target.h"
#include "support/random/options.h"
#include "support/random/scene.h"
#include "support/random/submeshes.h"
#include "support/topology/changing.h"
#include "support/ways.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/io/replay.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <sstream>

namespace dsc::fuzz {

namespace {

using test::Dice;

constexpr int steps = 4;
constexpr std::size_t enough_edits = 10'000; // torn flows make interfaces of any length

template <class Real>
Complex<Real> draw_complex(Dice& dice, double h) {
    return dice.chance(0.4) ? test::random_patches<Real>(dice, h, dice.in(2, 60))
                            : test::random_shapes<Real>(dice, h);
}

template <class Real>
void draw_sizes(Dice& dice, double h, SizeOptions<Real>& sizes) {
    if (!dice.chance(0.4)) {
        return;
    }
    sizes.growth = dice.in(1.05, 2.0);
    sizes.longest = static_cast<Real>(dice.chance(0.5) ? 0.0 : dice.in(1.0, 6.0) * h);
    const auto slope = static_cast<Real>(dice.in(-3.0, 3.0));
    const auto length = static_cast<Real>(h);
    if (dice.chance(0.3)) {
        sizes.by_place = [=](const Point<Real>& p, Real time, Phase phase) {
            return length * (1 + static_cast<Real>(phase) + slope * (p.x() + time));
        };
    }
    if (dice.chance(0.3)) {
        sizes.on_interface = [=](const Point<Real>& p, Real) {
            return length * (1 + slope * p.y());
        };
    }
    if (dice.chance(0.3)) {
        sizes.by_distance = [=](Real distance) { return length + slope * distance; };
    }
    sizes.changes_in_time = (sizes.by_place || sizes.on_interface) && dice.chance(0.5);
}

template <class Real>
test::ChangingOptions<Real> draw_all_options(Dice& dice, double h) {
    std::ostringstream words; // the bytes say all
    test::ChangingOptions<Real> options{test::draw_options<Real>(dice, h, words)};
    options.max_sub_steps = 20;
    test::draw_topology(dice, false, h, options.topology, words);
    if (dice.chance(0.2)) {
        // Up to eight edges; where a phase is too small for it, the stage refuses.
        options.topology.contact *= static_cast<Real>(dice.in(2.0, 12.0));
    }
    if (dice.chance(0.2)) {
        options.topology.energy = [](Phase one, Phase other) { return 1.0 + 0.3 * (one + other); };
    }
    draw_sizes(dice, h, options.sizes);
    if (dice.chance(0.15)) {
        options.carried_phases.push_back(static_cast<Phase>(dice.in(0, 3)));
    }
    return options;
}

// Null: sequential.
template <class Real>
std::unique_ptr<Executor<Real>> draw_executor(Dice& dice, Complex<Real>& complex,
                                              const Options<Real>& options) {
    std::ostringstream words;
    const double kind = dice.in(0.0, 1.0);
    if (kind < 0.4) {
        return nullptr;
    }
    if (kind < 0.75) {
        return test::random_executor(dice, complex, options, 1, words);
    }
    const auto all = test::all_divisions();
    const auto which = static_cast<std::size_t>(dice.in(0, static_cast<int>(all.size()) - 1));
    return make_executor(
        complex, options,
        Parallel{.division = all[which], .submeshes = test::number_in(dice, 0, 9)});
}

template <class Real>
using Stepper = std::function<StepReport(Simulation<Real>& simulation, Real time, Real dt)>;

template <class Flow, class Real>
Stepper<Real> stepper(Flow flow) {
    return [flow](Simulation<Real>& simulation, Real time, Real dt) {
        return simulation.step(flow, time, dt);
    };
}

// A velocity by place, or one that sees the interface, or curvature.
template <class Real>
Stepper<Real> draw_flow(Dice& dice, bool is_velocity) {
    const auto wildness =
        dice.chance(0.5) ? test::Wildness::none : dice.one_of(test::wildness_names);
    const test::RandomFlow flow(dice, 1, wildness);
    if (is_velocity || dice.chance(0.6)) {
        return stepper<Velocity<Real>, Real>(flow.velocity<Real>());
    }
    if (dice.chance(0.5)) {
        const auto speed = static_cast<Real>(dice.in(-1.0, 1.0));
        return stepper<InterfaceFlow<Real>, Real>(
            vertex_flow<Real>([=](const auto& view, std::size_t i, Real) -> Point<Real> {
                return speed * normal(view, i);
            }));
    }
    return stepper<InterfaceMotion<Real>, Real>(
        curvature_flow<Real>({.tension = dice.in(0.0, 1.0), .mobility = dice.in(0.01, 0.3)}));
}

template <class Real>
void check(const Complex<Real>& complex, const Simulation<Real>& simulation,
           const Options<Real>& options, const StepReport& report) {
    std::string problem = validate(complex).problem;
    if (problem.empty() && options.carried_phases.empty()) {
        problem = test::interface_fault(complex, simulation.interface());
    }
    expect(problem.empty(), problem);
    expect(report.sub_steps <= static_cast<std::uint32_t>(options.max_sub_steps),
           "more sub-steps than allowed");
    expect(report.held <= report.unreached, "more vertices held than unreached");
}

template <class Real>
std::uint64_t run_scene(Dice& dice) {
    const double h = dice.in(0.05, 0.14);
    Complex<Real> complex = draw_complex<Real>(dice, h);
    const Options<Real> options = draw_all_options<Real>(dice, h);
    const Stepper<Real> step = draw_flow<Real>(dice, !options.carried_phases.empty());
    const double dt = h * std::pow(10.0, dice.in(-2.0, 0.7));
    std::unique_ptr<Simulation<Real>> simulation;
    try {
        simulation = std::make_unique<Simulation<Real>>(complex, options,
                                                        draw_executor(dice, complex, options));
    } catch (const InputError&) {
        return 0; // options that go together with no complex, or not with this one
    }
    const Complex<Real> first = complex;
    std::vector<Edit> edits;
    std::atomic<bool> is_enough = false;
    simulation->interrupt_by(&is_enough);
    simulation->add_listener([&](std::span<const Edit> some) {
        edits.insert(edits.end(), some.begin(), some.end());
        is_enough = edits.size() > enough_edits;
    });
    std::uint64_t examined = 0;
    for (int i = 0; i < steps && !is_enough && examined < enough_edits; ++i) {
        const StepReport report =
            step(*simulation, static_cast<Real>(i * dt), static_cast<Real>(dt));
        check(complex, *simulation, options, report);
        examined += report.operations.examined;
    }
    // What create and merge did is in no log.
    if (std::ranges::find(edits, EditKind::rebuild, &Edit::kind) == edits.end()) {
        Complex<Real> again = first;
        expect(replay<Real>(again, edits).skipped == 0, "the log does not fit the first complex");
        expect(mesh_hash(again) == mesh_hash(complex), "the log replayed gives another complex");
    }
    return edits.size();
}

} // namespace

std::uint64_t run_steps(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) {
        return 0;
    }
    Dice dice(bytes.subspan(1));
    return bytes[0] % 4 == 3 ? run_scene<float>(dice) : run_scene<double>(dice);
}

} // namespace dsc::fuzz
