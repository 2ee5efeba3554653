// SPDX-License-Identifier: MIT
// What is read from the log of a pass, and that nothing is left in it.
#include "dsc/passes/readers.h"

#include "support/simulation_testing.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/interface/list.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::run_pass_test {
namespace {

class RunPass : public testing::Test {
protected:
    RunPass() : work(complex, options) {
        work.epoch = 1;
        work.interface = collect_interface(complex);
    }

    // Splits an edge of the interface without saying so to anybody.
    void run() {
        run_pass<double>(work, {"split", [](Work<double>& here) {
                                    for (const Edge e : edges(here.complex)) {
                                        if (is_interface(here.complex, e)) {
                                            edge_split(here.submesh, e.id,
                                                       midpoint_of(here.complex, e));
                                            return;
                                        }
                                    }
                                }});
    }
    static Point<double> midpoint_of(const Complex<double>& complex, Edge e) {
        const auto [a, b] = complex.vertices_of(e);
        return (complex.position(a) + complex.position(b)) / 2;
    }

    Complex<double> complex = test::disc_complex<double>(0.1);
    Options<double> options = test::options_for<double>(0.1);
    Work<double> work;
};

TEST_F(RunPass, ListsAndWakesWhatAPassHasChanged) {
    const std::size_t before = work.interface.size();
    run();
    EXPECT_EQ(work.interface.size(), before + 1);
    EXPECT_EQ(test::interface_fault(complex, work.interface), "");
    EXPECT_EQ(work.active.size(), 5U);
    EXPECT_EQ(work.changed_interface.size(), 1U);
}

TEST_F(RunPass, LeavesRecordsWhereThereIsAReaderAlone) {
    run();
    EXPECT_TRUE(work.log.records.empty());
    EXPECT_EQ(work.log.readers, 0U);
    work.log.readers = 1;
    run();
    EXPECT_EQ(work.log.records.size(), 1U);
    run();
    EXPECT_EQ(work.log.records.size(), 2U);
    EXPECT_EQ(work.log.readers, 1U);
}

} // namespace
} // namespace dsc::run_pass_test
