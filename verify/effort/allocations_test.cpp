// SPDX-License-Identifier: MIT
// After the first steps no step allocates: arrays belong to the executor and keep their capacity.
// This program counts allocations by replacing operator new, so it is separate from the other
// tests.
#include "effort/counting_new.h"
#include "support/random/scene.h"
#include "support/topology/changing.h"
#include "support/ways.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/executors.h"
#include "dsc/queries/validate.h"
#include "thesis/algorithm/centred_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace dsc::allocations_test {
namespace {

using test::Way;

constexpr double h = 0.03;
constexpr int steps_of_a_period = 40;
constexpr int warm_periods = 6;
constexpr int max_allocating_steps = steps_of_a_period / 3;
constexpr std::uint64_t max_allocations = 200;

struct Choice {
    std::string name;
    std::function<void(test::ChangingOptions<double>&)> set;
    bool has_attributes = false;
    bool in_submeshes = false; ///< tried in these as well
};

std::vector<Choice> choices() {
    return {
        {"default", [](auto&) {}, false, true},
        {"euler", [](auto& o) { o.integrator = Integrator::euler; }},
        {"centred", [](auto& o) { o.custom_integrator = centred_difference<double>(); }},
        {"midpoint", [](auto& o) { o.integrator = Integrator::midpoint; }},
        {"adaptive", [](auto& o) { o.integrator = Integrator::adaptive; }},
        {"length", [](auto& o) { o.interface.coarsening = Coarsening::length; }},
        {"gap", [](auto& o) { o.interface.gap = 1; }},
        {"turn", [](auto& o) { o.interface.turn_degrees = 20; }},
        {"cubic", [](auto& o) { o.interface.reading = Reading::cubic; }},
        {"shuffled", [](auto& o) { o.shuffle_seed = 3; }},
        {"sizes", [](auto& o) { o.sizes.growth = 1.3; }, false, true},
        {"topology", [](auto& o) { o.topology.rule = Topology::change; }, false, true},
        {"wide",
         [](auto& o) {
             o.topology.rule = Topology::change;
             o.topology.contact = 2 * h;
         }},
        {"attributes", [](auto&) {}, true, true},
        {"advected", [](auto& o) { o.advected_phases = {1}; }, false, true},
    };
}

// A disc that is sheared and turned about, and comes back to the same place after a period.
const Velocity<double> back_and_forth = [](auto positions, double time, auto velocities) {
    const double speed = std::cos(2 * std::numbers::pi * time);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        velocities[i] = {speed * (0.3 + 0.5 * positions[i].y()), speed * 0.3};
    }
};

// Counts over the last period.
struct Counted {
    std::uint64_t allocations = 0;
    int allocating_steps = 0;
    std::uint64_t edits = 0; ///< so that something was done
};

Counted count(const Choice& choice, Way way) {
    auto complex = test::disc_complex<double>(h);
    if (choice.has_attributes) {
        complex.attributes.add<Vertex, double>("at vertices");
        complex.attributes.add<Edge, double>("at edges");
        complex.attributes.add<Triangle, Point<double>>("at triangles", Point<double>(0, 0));
    }
    test::ChangingOptions<double> options;
    options.edge_length = h;
    choice.set(options);
    auto executor = way ? make_executor(complex, options,
                                        Parallel{.threads = 2,
                                                 .division = way,
                                                 .submeshes = 4,
                                                 .always_all_threads = true})
                        : nullptr;
    Simulation<double> simulation(complex, options, std::move(executor));
    if (options.topology.changes()) {
        simulation.add_stage(std::make_shared<TopologyStage<double>>(options.topology));
    }
    Counted counted;
    for (int step = 0; step < (warm_periods + 1) * steps_of_a_period; ++step) {
        const std::uint64_t before = test::allocations_so_far();
        const StepReport report = simulation.step(
            back_and_forth, static_cast<double>(step) / steps_of_a_period, 1.0 / steps_of_a_period);
        if (step >= warm_periods * steps_of_a_period) {
            const std::uint64_t made = test::allocations_so_far() - before;
            counted.allocations += made;
            counted.allocating_steps += made > 0 ? 1 : 0;
            counted.edits += report.operations.flips + report.operations.splits +
                             report.operations.collapses + report.operations.interface_splits;
        }
    }
    EXPECT_EQ(validate(complex).problem, "");
    return counted;
}

TEST(Allocations, SequentialStepsMakeNone) {
    for (const Choice& choice : choices()) {
        const Counted counted = count(choice, nullptr);
        EXPECT_GT(counted.edits, 500U) << choice.name << ": hardly anything was done";
        EXPECT_EQ(counted.allocations, 0U) << choice.name;
    }
}

// The mesh is divided anew in every eighth step, which allocates lists of cuts and parts, and the
// arrays of new submeshes grow. All other steps allocate nothing.
TEST(Allocations, StepsInSubmeshesMakeNoneBetweenDivisions) {
    for (const Choice& choice : choices()) {
        if (!choice.in_submeshes) {
            continue;
        }
        for (const Way division : in_place_divisions) {
            SCOPED_TRACE(choice.name + ", " + std::string(division->name));
            const Counted counted = count(choice, division);
            EXPECT_GT(counted.edits, 500U) << "hardly anything was done";
            EXPECT_LE(counted.allocating_steps, max_allocating_steps);
            EXPECT_LE(counted.allocations, max_allocations);
        }
    }
}

// A disc that is stretched gets new vertices in every third step. Each array doubles its capacity
// once or twice during the run, so few steps allocate.
void expect_rare_growth(const Velocity<double>* velocity, const InterfaceFlow<double>& flow,
                        Way way) {
    constexpr double finer = h / 3;
    auto complex = test::disc_complex<double>(finer, {0.5, 0.5}, 0.1);
    Options<double> options;
    options.edge_length = finer;
    Simulation<double> simulation(complex, options, test::executor_of(way, complex, options));
    constexpr int warm_up = 20;
    constexpr int steps = 150;
    constexpr double dt = 0.01;
    std::size_t vertices = 0;
    int growing_steps = 0;
    int allocating_steps = 0;
    for (int step = 0; step < steps; ++step) {
        const std::uint64_t before = test::allocations_so_far();
        const StepReport report = velocity != nullptr ? simulation.step(*velocity, step * dt, dt)
                                                      : simulation.step(flow, step * dt, dt);
        const std::uint64_t made = test::allocations_so_far() - before;
        growing_steps += step >= warm_up && report.interface_vertices > vertices ? 1 : 0;
        allocating_steps += step >= warm_up && made > 0 ? 1 : 0;
        vertices = std::max<std::size_t>(vertices, report.interface_vertices);
    }
    EXPECT_GT(growing_steps, 40) << "it hardly grows";
    EXPECT_LE(allocating_steps, way ? 30 : 15) << "divisions allocate as well";
}

TEST(Allocations, AGrowingInterfaceMakesRoomRarely) {
    const Velocity<double> apart = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {positions[i].x() - 0.5, 0.5 - positions[i].y()};
        }
    };
    const auto apart_as_seen = vertex_flow<double>([](const auto& view, std::size_t i, double) {
        return Point<double>(view.positions[i].x() - 0.5, 0.5 - view.positions[i].y());
    });
    for (const Way way : {Way(nullptr), Way(&cells_division)}) {
        SCOPED_TRACE(test::name_of(way));
        expect_rare_growth(&apart, apart_as_seen, way);
        expect_rare_growth(nullptr, apart_as_seen, way);
    }
}

} // namespace
} // namespace dsc::allocations_test
