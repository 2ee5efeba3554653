// SPDX-License-Identifier: MIT
// The journal of a complex is emptied by its last reader, and a step that was done as a whole was
// not interrupted.
#include "support/courses.h"

#include "dsc/algorithm/simulation.h"

#include <gtest/gtest.h>

#include <atomic>

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
}

TEST(Journal, IsKeptForAnotherReader) {
    Complex<double> complex = disc();
    const Simulation<double> first(complex, {.edge_length = disc_h});
    {
        const Simulation<double> second(complex, {.edge_length = disc_h});
        complex.set_phase(Triangle{1}, 3);
    }
    EXPECT_EQ(complex.journal.records.size(), 1U);
}

TEST(Interruption, AfterTheLastSubStepChangesNothing) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h});
    const std::atomic<bool> flag = true;
    simulation.interrupt_by(&flag);
    const StepReport report = simulation.step(test::swirl, 0, 0.001);
    EXPECT_EQ(report.sub_steps, 1U);
    EXPECT_EQ(report.gave_up, GiveUp::none);
}

} // namespace
} // namespace dsc::journal_test
