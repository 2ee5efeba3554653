// SPDX-License-Identifier: MIT
// The list of vertices that interface remeshing keeps: which vertices stay on it and which leave
// it; and what it takes from the log of a pass.
#include "support/simulation_testing.h"
#include "support/small_meshes.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/readers.h"
#include "dsc/passes/work.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::remeshing_list_test {
namespace {

using std::numbers::pi;
using test::options_for;

TEST(RemeshingList, VerticesOfNoInterfaceLeaveIt) {
    auto complex = test::grid<double>(8, 0, 1, 2.5);
    const auto options = options_for<double>(1.5);
    Work<double> work(complex, options);
    work.interface = collect_interface(complex);
    const std::size_t before = work.interface.size();
    work.interface.push_back(4 * 9 + 4); // in the middle of phase 1
    remesh_interface(work);
    EXPECT_EQ(work.interface.size(), before);
    EXPECT_EQ(test::interface_fault(complex, work.interface), "");
}

TEST(RemeshingList, AVertexOfTooManyTrianglesStaysOnIt) {
    constexpr std::uint32_t degree = Star<double>::capacity + 4;
    auto complex = test::wheel<double>(degree);
    for (std::uint32_t i = 0; i < degree / 2; ++i) {
        complex.set_phase(Triangle{i + 1}, 1);
    }
    const auto options = options_for<double>(1);
    Work<double> work(complex, options);
    work.interface = {0};
    remesh_interface(work);
    EXPECT_EQ(work.interface, std::vector<std::uint32_t>{0});
}

// The remnant of a tip is removed only if it is shorter than five times the deviation.
TEST(RemeshingList, RemnantsOfTipsAreAsLongAsTheOptionsSay) {
    constexpr double h = 0.05;
    for (const double length : {0.09, 0.11}) { // a tenth of an edge is five times the deviation
        std::vector<Point<double>> outline;
        for (int i = 0; i < 60; ++i) {
            outline.emplace_back(0.5 + 0.3 * std::cos(2 * pi * i / 60),
                                 0.5 + 0.2 * std::sin(2 * pi * i / 60));
        }
        const Point<double> along = (outline[10] - outline[9]).normalized();
        outline.insert(outline.begin() + 10,
                       outline[10] + length * h * Point<double>(along.y(), -along.x()));
        const std::vector<Shape> shapes{{outline, 1}};
        auto complex =
            initial_complex<double>({}, shapes, {.edge_length = h, .detail = Detail::keep});
        const auto options = options_for<double>(h);
        Work<double> work(complex, options);
        work.interface = collect_interface(complex);
        remesh_interface(work);
        EXPECT_EQ(work.log.counts.interface_collapses, length < 0.1 ? 1U : 0U);
    }
}

class RunPass : public testing::Test {
protected:
    RunPass() : work(complex, options) {
        work.epoch = 1;
        work.interface = collect_interface(complex);
    }

    // Splits an edge of the interface without adding to any list.
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
} // namespace dsc::remeshing_list_test
