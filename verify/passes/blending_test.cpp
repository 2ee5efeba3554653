// SPDX-License-Identifier: MIT
// Attributes of the vertices that a step makes itself: blended from both ends of the edge, on the
// interface as well as inside. Operations by hand are tested elsewhere; here the driver splits.
#include "support/simulation_testing.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::blending_test {
namespace {

using test::disc_complex;
using test::options_for;

// Nothing moves, and edges are too long: new vertices lie exactly in the middle of old edges, or of
// new ones, so that blended coordinates remain coordinates.
TEST(Blending, OfVerticesThatTheDriverMakes) {
    constexpr double coarse = 0.08;
    auto complex = disc_complex<double>(coarse);
    auto& abscissa = complex.attributes.add<Vertex, double>(
        "abscissa", 0.0,
        [](double a, double b, double fraction) { return a + fraction * (b - a); });
    for (const Vertex v : vertices(complex)) {
        abscissa[v] = complex.position(v).x();
    }
    auto options = options_for<double>(coarse);
    options.insertion = Insertion::linear;
    options.interface.longest = 0.7;
    options.interface.shortest = 0.2;
    options.phases.longest = 0.9;
    options.phases.smooth_quality = 0; // a vertex that smoothing moves keeps its value
    options.phases.collapse_quality = 0;
    Simulation<double> simulation(complex, options);
    OperationCounts counts;
    std::vector<Vertex> made;
    std::size_t on_interface = 0;
    simulation.add_listener([&](std::span<const Edit> edits) {
        for (const Edit& edit : edits) {
            if (edit.kind == EditKind::split) {
                made.push_back(edit.vertex);
                on_interface += edit.on_interface ? 1 : 0;
            }
        }
    });
    for (int step = 0; step < 4; ++step) {
        // Too slow to matter: stars are looked at where vertices move.
        counts += simulation.step(test::constant<double>(1e-12, 0), 0, 1).operations;
    }
    EXPECT_EQ(counts.smoothed, 0U);
    EXPECT_GT(on_interface, 10U);
    EXPECT_GT(made.size() - on_interface, 10U);
    for (const Vertex v : made) {
        if (complex.is_alive(v)) {
            EXPECT_NEAR(abscissa[v], complex.position(v).x(), 1e-9);
        }
    }
}

} // namespace
} // namespace dsc::blending_test
