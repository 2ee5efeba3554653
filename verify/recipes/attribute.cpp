// SPDX-License-Identifier: MIT
// A new attribute: where on the x axis each vertex of the interface was at the start. Vertices take
// it with them, and a new one between two others gets what lies between theirs.
#include "dsc/dsc.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace dsc;

TEST(Recipe, AnAttributeIsCarriedAlong) {
    auto complex = test::disc_complex<double>(0.03);
    auto& start_x = complex.attributes.add<Vertex>("start_x", 0.0); // the line
    for (const Vertex v : vertices(complex)) {
        start_x[v] = complex.position(v).x();
    }

    // The disc makes half a turn about its centre, in a mesh that does not turn with it.
    Simulation<double> simulation(complex, {.edge_length = 0.03});
    const Velocity<double> turn = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {0.5 - positions[i].y(), positions[i].x() - 0.5};
        }
    };
    OperationCounts operations;
    for (int step = 0; step < 60; ++step) {
        const double dt = std::numbers::pi / 60;
        operations += simulation.step(turn, dt * step, dt).operations;
    }
    EXPECT_GT(operations.flips, 100U);
    for (const std::uint32_t v : simulation.interface()) {
        EXPECT_NEAR(start_x[Vertex{v}], 1 - complex.position(Vertex{v}).x(), 2e-3);
    }
}
