// SPDX-License-Identifier: MIT
// A new attribute: the x coordinate of each interface vertex at the start. The value moves with its
// vertex, and a new vertex between two others gets a value between theirs.
#include "dsc/dsc.h"
#include "support/random/scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace dsc;

TEST(Recipe, AnAttributeIsAdvectedAlong) {
    auto complex = test::disc_complex<double>(0.03);
    auto& start_x = complex.attributes.add<Vertex>("start_x", 0.0); // the line
    for (const Vertex v : vertices(complex)) {
        start_x[v] = complex.position(v).x();
    }

    // The disc is stretched to an ellipse: x - 0.5 grows by the factor exp(t).
    Simulation<double> simulation(complex, {.edge_length = 0.03});
    const Velocity<double> strain = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {positions[i].x() - 0.5, 0.5 - positions[i].y()};
        }
    };
    OperationCounts operations;
    for (int step = 0; step < 50; ++step) {
        operations += simulation.step(strain, 0.01 * step, 0.01).operations;
    }
    EXPECT_GT(operations.interface_splits, 5U);
    for (const std::uint32_t v : simulation.interface()) {
        const double x = complex.position(Vertex{v}).x() - 0.5;
        EXPECT_NEAR(start_x[Vertex{v}], 0.5 + x * std::exp(-0.5), 1e-3);
    }
}
