// SPDX-License-Identifier: MIT
// The model of more threads than the machine has, with given times: one second for each task.
#include "steps/model.h"
#include "steps/space/model.h"

#include "dsc/parallel/submesh_view.h"
#include "dsc/passes/algorithm.h"
#include "support/submesh_executor_testing.h"
#include "thesis/divisions/slabs.h"

#include <memory>
#include <utility>

namespace dsc::model_test {
namespace {

constexpr double h = 0.04;

struct Profiled {
    bench::ModelRun run;
    double tasks = 0; ///< as the executor counts them
    double seconds = 0;
};

// Profiles the steps of a growing disc in four slabs.
Profiled profiled_steps() {
    auto complex = test::disc_complex<double>(h);
    Options<double> options;
    options.edge_length = h;
    auto executor = std::make_unique<SubmeshExecutor<double>>(
        complex, options, default_algorithm<double>(),
        std::make_unique<SlabPartitioner<double>>(
            SlabOptions{.slabbing = Slabbing::fixed, .submeshes = 4, .min_width = 4}),
        Parallel{.threads = 1, .profile = true});
    const SubmeshExecutor<double>& seen = *executor;
    Simulation<double> simulation(complex, options, std::move(executor));
    const auto grow = test::pointwise(
        [](const Point<double>& p) { return Point<double>(p - Point<double>(0.5, 0.5)); });
    Profiled profiled;
    for (int step = 0; step < 3; ++step) {
        simulation.step(grow, 0, 0.2);
        bench::add_step(profiled.run, seen.view(), 1000);
        for (const SubStepProfile& times : seen.view().profile) {
            for (const auto* tasks : {&times.targets, &times.move}) {
                profiled.tasks += static_cast<double>(tasks->size());
                for (const double seconds : *tasks) {
                    profiled.seconds += seconds;
                }
            }
        }
    }
    return profiled;
}

// The same run with one second for each task, and no time for anything else.
bench::ModelRun in_seconds(bench::ModelRun run) {
    run.serial_outside.assign(run.serial_outside.size(), 0);
    for (auto& step : run.steps) {
        for (bench::ModelSubStep& sub_step : step) {
            sub_step.serial = 0;
            sub_step.targets.seconds.assign(sub_step.targets.seconds.size(), 1);
            sub_step.move.seconds.assign(sub_step.move.seconds.size(), 1);
        }
    }
    return run;
}

TEST(Model, TakesAllTasksAndNoOthers) {
    const Profiled profiled = profiled_steps();
    ASSERT_GT(profiled.tasks, 24);
    EXPECT_NEAR(profiled.run.account.tasks / profiled.seconds, 1, 1e-12);
    EXPECT_NEAR(bench::model(profiled.run, 1, 0).tasks / profiled.seconds, 1, 1e-12);
    const bench::ModelTimes one = bench::model(in_seconds(profiled.run), 1, 0);
    EXPECT_EQ(one.tasks, profiled.tasks);
    EXPECT_EQ(one.seconds, profiled.tasks);
    EXPECT_EQ(one.busy_share, 1);
}

TEST(Model, TwoWorkersTakeAtLeastHalfOfIt) {
    const Profiled profiled = profiled_steps();
    const bench::ModelTimes two = bench::model(in_seconds(profiled.run), 2, 0);
    EXPECT_GE(two.seconds, profiled.tasks / 2);
    EXPECT_LT(two.seconds, 0.75 * profiled.tasks); // four slabs of either colour
    EXPECT_EQ(two.busy_share, profiled.tasks / (2 * two.seconds));
    // Serial parts and the start of each section add to the modelled time.
    bench::ModelRun run = in_seconds(profiled.run);
    double sections = 0;
    for (auto& step : run.steps) {
        sections += 2 * static_cast<double>(step.size());
        step.front().serial = 5;
    }
    const bench::ModelTimes more = bench::model(run, 2, 0.25);
    const double serial = 5 * static_cast<double>(run.steps.size());
    EXPECT_EQ(more.serial, serial);
    EXPECT_EQ(more.starts, 0.25 * sections);
    EXPECT_EQ(more.seconds, two.seconds + serial + 0.25 * sections);
    EXPECT_EQ(more.serial_share, serial / (serial + profiled.tasks));
}

// Two steps with 2 s of serial work, sections of 5 and of 1 tasks, measured with two threads.
TEST(Model, InSpaceTasksAreTakenInTheirOrder) {
    bench::SpaceProfile run;
    const dsc3::StepProfile step{{{0, 8.5}, {5, 4}}, {1, 2, 3, 4, 5, 4}};
    run.add(step, 14.5);
    run.add(step, 14.5);
    EXPECT_EQ(run.steps, 2);
    EXPECT_EQ(run.tasks(), 38);
    EXPECT_EQ(run.serial(), 4);
    EXPECT_EQ(bench::makespan({1, 2, 3, 4, 5}, 2), 9); // 1 3 5, and 2 4
    EXPECT_EQ(bench::makespan({1, 2, 3, 4, 5}, 8), 5);
    EXPECT_EQ(bench::measured_start(run, 2), 0); // 8.5 is less than 9
    const bench::ModelTimes one = bench::model(run, 1, 0.25);
    EXPECT_EQ(one.seconds, 42);
    EXPECT_EQ(one.busy_share, 1);
    EXPECT_EQ(one.starts, 0);
    const bench::ModelTimes four = bench::model(run, 4, 0.25); // a start for two levels of threads
    EXPECT_EQ(four.starts, 1);
    EXPECT_EQ(four.seconds, 4 + 2 * (6 + 4) + 1);
    EXPECT_EQ(four.serial_share, 4.0 / 42);
}

} // namespace
} // namespace dsc::model_test
