// SPDX-License-Identifier: MIT
// The journal of a complex stays with it and is emptied by its last reader; options change as a
// whole; how a step is interrupted; a complex has one simulation at a time.
#include "support/courses.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/validate.h"
#include "replay/replay.h"
#include "thesis/algorithm/centred_difference.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dsc::journal_test {
namespace {

using test::disc;
using test::disc_h;

TEST(Journal, IsEmptiedByTheLastReaderAlone) {
    Complex<double> complex = disc();
    {
        Simulation<double> simulation(complex, {.edge_length = disc_h});
        complex.set_phase(Triangle{1}, 3);
        EXPECT_EQ(complex.journal.records.size(), 1U);
        (void)simulation.step(test::still, 0, 0.01);
        EXPECT_TRUE(complex.journal.records.empty());
        complex.set_phase(Triangle{1}, 0);
    }
    EXPECT_TRUE(complex.journal.records.empty());
    ++complex.journal.readers;
    {
        const Simulation<double> simulation(complex, {.edge_length = disc_h});
        complex.set_phase(Triangle{1}, 3);
    }
    EXPECT_EQ(complex.journal.records.size(), 1U);
}

TEST(Journal, StaysWithItsComplex) {
    Complex<double> complex = disc();
    Complex<double> moved;
    {
        const Simulation<double> simulation(complex, {.edge_length = disc_h});
        complex.set_phase(Triangle{1}, 3);
        moved = std::move(complex);
        moved.set_phase(Triangle{1}, 0);
        EXPECT_TRUE(moved.journal.records.empty());
        const Complex<double> made = std::move(moved);
        EXPECT_EQ(made.journal.readers, 0U);
        complex = made;
        moved = made;
        EXPECT_EQ(complex.journal.readers, 1U);
        EXPECT_EQ(complex.journal.records.back().kind, EditKind::rebuild);
    }
    EXPECT_EQ(complex.journal.readers, 0U);
    EXPECT_TRUE(complex.journal.records.empty());
}

class JournalOf : public testing::TestWithParam<test::Course> {};

// As a complex of its own would, from the same place.
void expect_to_go_on(Complex<double>& complex, Simulation<double>& simulation) {
    test::expect_sound(complex, simulation);
    for (int step = 0; step < 4; ++step) {
        EXPECT_EQ(simulation.step(test::swirl, 0.02 * step, 0.02).unreached, 0U);
        test::expect_sound(complex, simulation);
    }
}

TEST_P(JournalOf, AComplexThatBecomesAnotherTellsItsSimulation) {
    for (const auto& custom :
         {std::shared_ptr<const CustomIntegrator<double>>(), centred_difference<double>()}) {
        Complex<double> complex = disc();
        const Complex<double> other = test::disc_complex<double>(disc_h, {0.3, 0.4}, 0.1);
        const Options<double> options{.edge_length = disc_h, .custom_integrator = custom};
        auto simulation = test::make_simulation(complex, options, GetParam());
        (void)simulation->step(test::swirl, 0, 0.02);
        complex = other;
        (void)simulation->step(test::still, 0, 0.02);
        expect_to_go_on(complex, *simulation);

        // The steps are those of a simulation that began there.
        Complex<double> again = other;
        auto fresh = test::make_simulation(again, options, GetParam());
        (void)fresh->step(test::still, 0, 0.02);
        expect_to_go_on(again, *fresh);
        EXPECT_EQ(simulation->interface_size(), fresh->interface_size());
    }
}

TEST_P(JournalOf, AReplayIsToldToTheSimulationOfTheComplex) {
    Complex<double> complex = disc();
    auto simulation = test::make_simulation(complex, {.edge_length = disc_h}, GetParam());
    (void)simulation->step(test::swirl, 0, 0.02);
    std::vector<Edit> edits;
    {
        Complex<double> copy = complex;
        copy.journal.readers = 1;
        const Edge e = copy.edge(next(copy.vertices[simulation->interface()[0]].corner));
        EXPECT_EQ(edge_split(copy, e).verdict, Verdict::legal);
        edits = copy.journal.records;
    }
    EXPECT_EQ(replay<double>(complex, edits).skipped, 0U);
    edits.push_back({.kind = EditKind::rebuild});
    EXPECT_THROW(replay<double>(complex, edits), InputError);
    EXPECT_EQ(complex.journal.readers, 1U);
    complex.set_phase(Triangle{1}, 3);
    (void)simulation->step(test::still, 0, 0.02);
    expect_to_go_on(complex, *simulation);
}

TEST_P(JournalOf, ItsSimulationTakesOptionsAsAWhole) {
    Complex<double> complex = disc();
    auto simulation = test::make_simulation(complex, {.edge_length = disc_h}, GetParam());
    simulation->step(test::swirl, 0, 0.02);
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
    simulation->step(test::swirl, 0.02, 0.02);
    simulation->step(test::swirl, 0.04, 0.02);
    finer.edge_length = disc_h / 2;
    finer.custom_integrator = nullptr;
    simulation->set_options(finer);
    const std::size_t before = simulation->interface_size();
    simulation->step(test::swirl, 0.06, 0.02);
    EXPECT_GT(simulation->interface_size(), before * 3 / 2);
    test::expect_sound(complex, *simulation);
}

INSTANTIATE_TEST_SUITE_P(Ways, JournalOf, testing::ValuesIn(test::all_courses), test::course_name);

TEST(Interruption, EndsAStepBetweenItsSubSteps) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    std::atomic<bool> flag = false;
    simulation.interrupt_by(&flag);
    int calls = 0;
    const Velocity<double> velocity = [&](auto positions, double time, auto velocities) {
        test::swirl(positions, time, velocities);
        flag = ++calls > 12;
    };
    const StepReport report = simulation.step(velocity, 0, 1);
    EXPECT_EQ(report.gave_up, GiveUp::interrupted);
    EXPECT_GT(report.reached, 0);
    EXPECT_LT(report.reached, 0.5);
    test::expect_sound(complex, simulation);
    // After the last one nothing is left to interrupt.
    const StepReport rest = simulation.step(test::swirl, report.reached, 0.001);
    EXPECT_EQ(rest.sub_steps, 1U);
    EXPECT_EQ(rest.gave_up, GiveUp::none);
}

class OneSimulation : public testing::TestWithParam<test::Course> {};
INSTANTIATE_TEST_SUITE_P(Simulations, OneSimulation, testing::ValuesIn(test::all_courses),
                         test::course_name);

TEST_P(OneSimulation, AreRefusedWhileAnotherLives) {
    const Options<double> options{.edge_length = disc_h};
    Complex<double> complex = disc();
    Complex<double> undisturbed = complex;
    {
        const auto first = test::make_simulation(complex, options, GetParam());
        const auto alone = test::make_simulation(undisturbed, options, GetParam());
        for (int step = 0; step < 4; ++step) {
            for (const test::Course& way : test::all_courses) {
                EXPECT_THROW((void)test::make_simulation(complex, options, way), InputError)
                    << way.name;
            }
            (void)first->step(test::swirl, 0.02 * step, 0.02);
            (void)alone->step(test::swirl, 0.02 * step, 0.02);
        }
        EXPECT_EQ(mesh_hash(complex), mesh_hash(undisturbed));
        EXPECT_EQ(complex.vertex_count(), undisturbed.vertex_count());
        EXPECT_TRUE(complex.journal.records.empty());
    }
    const auto second = test::make_simulation(complex, options, GetParam());
    (void)second->step(test::swirl, 0.08, 0.02);
    test::expect_sound(complex, *second);
}

TEST(Simulations, ThatThrewWhileTheyWereMadeLeaveTheComplexFree) {
    Complex<double> complex = disc();
    EXPECT_THROW(Simulation<double>(complex, {.edge_length = -1}), InputError);
    Options<double> options{.edge_length = disc_h, .sizes = {.growth = 1.2}};
    options.sizes.by_place = [](const Point<double>&, double, Phase) -> double {
        throw std::domain_error("no length known");
    };
    EXPECT_THROW(Simulation<double>(complex, options), std::domain_error);
    EXPECT_EQ(complex.journal.readers, 0U);
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    EXPECT_EQ(simulation.step(test::swirl, 0, 0.02).unreached, 0U);
}

// That a simulation works on a complex is of the object, wherever its mesh goes.
TEST(Simulations, WorkOnOneObjectAndNotOnItsCopies) {
    const Options<double> options{.edge_length = disc_h};
    Complex<double> complex = disc();
    auto first = std::make_unique<Simulation<double>>(complex, options);
    Complex<double> copy = complex;
    auto second = std::make_unique<Simulation<double>>(copy, options);
    first.reset(); // in either order
    EXPECT_THROW(Simulation<double>(copy, options), InputError);
    first = std::make_unique<Simulation<double>>(complex, options);
    second.reset();
    copy = complex;
    const Simulation<double> third(copy, options);
    complex = disc();
    EXPECT_THROW(Simulation<double>(complex, options), InputError);
    Complex<double> moved = std::move(complex);
    const Simulation<double> fourth(moved, options);
}

} // namespace
} // namespace dsc::journal_test
