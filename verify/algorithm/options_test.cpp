// SPDX-License-Identifier: MIT
// The options of a simulation: they are copied, and changed as a whole; and how a step is
// interrupted.
#include "support/courses.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "replay/mesh_hash.h"
#include "thesis/algorithm/centred_difference.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace dsc::options_test {
namespace {

using test::all_courses;
using test::Course;
using test::course_name;
using test::disc;
using test::disc_h;
using test::expect_sound;
using test::make_simulation;
using test::swirl;

class EveryWay : public testing::TestWithParam<Course> {};

TEST(SimulationOptions, AreCopied) {
    Complex<double> complex = disc();
    Complex<double> other = complex;
    auto options = std::make_unique<Options<double>>();
    options->edge_length = disc_h;
    Simulation<double> simulation(complex, *options);
    Simulation<double> temporary(other, {.edge_length = disc_h});
    *options = {}; // an edge length of 0 would be refused, or worse
    options.reset();
    for (int step = 0; step < 3; ++step) {
        simulation.step(swirl, 0.02 * step, 0.02);
        temporary.step(swirl, 0.02 * step, 0.02);
    }
    EXPECT_EQ(mesh_hash(complex), mesh_hash(other));
    expect_sound(complex, simulation);
}

TEST_P(EveryWay, SetOptionsTakesThemAsAWhole) {
    Complex<double> complex = disc();
    auto simulation = make_simulation(complex, {.edge_length = disc_h}, GetParam());
    simulation->step(swirl, 0, 0.02);
    Options<double> wrong = simulation->options();
    wrong.sub_step = -1;
    wrong.edge_length = disc_h / 2;
    EXPECT_THROW(simulation->set_options(wrong), InputError);
    EXPECT_EQ(simulation->options().edge_length, disc_h);

    // A memory that begins with the switch: the first centred step is one of `midpoint`.
    Options<double> centred = simulation->options();
    centred.custom_integrator = centred_difference<double>();
    simulation->set_options(centred);
    Options<double> finer = centred;
    simulation->step(swirl, 0.02, 0.02);
    simulation->step(swirl, 0.04, 0.02);
    finer.edge_length = disc_h / 2;
    finer.custom_integrator = nullptr;
    simulation->set_options(finer);
    const std::size_t before = simulation->interface_size();
    simulation->step(swirl, 0.06, 0.02);
    EXPECT_GT(simulation->interface_size(), before * 3 / 2);
    expect_sound(complex, *simulation);
}

TEST(SimulationOptions, AStepEndsWhereItIsInterrupted) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    std::atomic<bool> flag = false;
    simulation.interrupt_by(&flag);
    int calls = 0;
    const Velocity<double> velocity = [&](auto positions, double time, auto velocities) {
        swirl(positions, time, velocities);
        flag = ++calls > 12;
    };
    const StepReport report = simulation.step(velocity, 0, 1);
    EXPECT_EQ(report.gave_up, GiveUp::interrupted);
    EXPECT_GT(report.reached, 0);
    EXPECT_LT(report.reached, 0.5);
    expect_sound(complex, simulation);
    flag = false;
    const Velocity<double> rest = swirl;
    EXPECT_EQ(simulation.step(rest, report.reached, 0.1).gave_up, GiveUp::none);
}

INSTANTIATE_TEST_SUITE_P(Options, EveryWay, testing::ValuesIn(all_courses), course_name);

} // namespace
} // namespace dsc::options_test
