// SPDX-License-Identifier: MIT
// A network of grains coarsens to a tenth by curvature flow: no vertex is stuck, and all junctions
// become stable.
#include "support/random/scene.h"
#include "support/topology/changing.h"
#include "support/topology/topology_testing.h"

#include "dsc/queries/phases.h"
#include "geometric_flows/curvature_flow.h"
#include "measures/mesh_quality.h"

#include <gtest/gtest.h>

namespace dsc::grains_test {
namespace {

TEST(Grains, CoarsenToATenthAndNothingIsStuck) {
    constexpr double h = 0.018;
    auto complex = test::random_grains(30, h, 2);
    test::ChangingOptions<double> options;
    options.edge_length = h;
    options.topology.rule = Topology::change;
    options.interface.feature_degrees = 180; // curvature flow knows no corners
    test::ChangingSimulation<double> simulation(complex, options);
    const InterfaceMotion<double> motion = curvature_flow<double>();
    const double dt = 0.4 * h * h;
    int step = 0;
    for (; phases(complex).size() > 3 && step < 5000; ++step) {
        EXPECT_EQ(simulation.step(motion, step * dt, dt).unreached, 0U) << step;
        EXPECT_EQ(test::ends_of(complex).crowded, 0U) << step;
        EXPECT_EQ(validate(complex).problem, "") << step;
        EXPECT_GT(scenes::measure_quality(complex).min_quality, 0.01) << step;
    }
    EXPECT_LT(step, 5000);
}

} // namespace
} // namespace dsc::grains_test
