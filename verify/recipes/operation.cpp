// SPDX-License-Identifier: MIT
// A new operation: flips an edge where the other diagonal is shorter; run as a pass of its own.
#include "dsc/dsc.h"
#include "support/random/scene.h"
#include "thesis/thesis.h"

#include <gtest/gtest.h>

using namespace dsc;

// The length that a flip would save; not positive on the domain boundary.
static double gain(const Complex<double>& mesh, Edge edge) {
    const Corner twin = mesh.twin(edge.id);
    const auto at = [&](Corner c) { return mesh.position(Vertex{mesh.vertex(c)}); };
    return is_border(twin) ? 0 : length(mesh, edge) - (at(edge.id) - at(twin)).norm();
}

TEST(Recipe, AnOperationIsOnePassMore) {
    auto complex = test::disc_complex<double>(0.03);
    const Options<double> options{.edge_length = 0.03};
    int flips = 0;
    auto algorithm = default_algorithm<double>();
    auto& passes = algorithm.motion;
    // This statement adds the pass before the mesh update, which empties the active set.
    passes.insert(passes.end() - 1,
                  mesh_update_pass<double, Edge>(
                      {.name = "shorter diagonals",
                       .quality = [](const auto& mesh, Edge edge) { return -gain(mesh, edge); },
                       .select = below<Edge>(0),
                       .operation =
                           [&](auto& work, Edge edge) {
                               if (gain(work.complex, edge) <= 0) {
                                   return Verdict::no_gain; // an earlier flip changed it
                               }
                               const Verdict verdict = edge_flip(work.submesh, edge);
                               flips += verdict == Verdict::legal ? 1 : 0;
                               return verdict;
                           }}));
    Simulation<double> simulation(
        complex, options,
        std::make_unique<Executor<double>>(complex, options, std::move(algorithm)));
    simulation.step([](auto p, double, auto v) { std::ranges::copy(p, v.begin()); }, 0, 0.3);
    EXPECT_GT(flips, 0);
    EXPECT_TRUE(validate(complex).problem.empty());
}
