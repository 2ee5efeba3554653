// SPDX-License-Identifier: MIT
// Fronts that meet at once. Flat ones meet everywhere: no seam runs through the film from one place
// outwards, and many contacts leave pockets between them; the seam is halfway, exactly. Those of
// four discs meet in one point.
#include "dsc/algorithm/simulation.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/growth.h"
#include "geometric_flows/growth_features.h"
#include "replay/replay.h"
#include "topology/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

namespace dsc::fronts::parallel_fronts_test {
namespace {

using P = Point<double>;

Shape rectangle(double bottom, double top, Phase phase) {
    return {{P(0.2, bottom), P(0.8, bottom), P(0.8, top), P(0.2, top)}, phase};
}

struct Seam {
    double mean = 0;             ///< distance from the line halfway, in edge lengths
    double max = 0;              ///< the same
    std::size_t size = 0;        ///< vertices
    std::size_t parted = 0;      ///< times that fronts which had met came apart
    std::size_t exchanges = 0;   ///< events T1
    std::uint64_t unreached = 0; ///< vertices
    bool is_valid = false;       ///< at the end
    std::uint64_t mesh_hash = 0; ///< the same
};

Seam grow(const std::vector<Shape>& shapes, double until, double h, std::uint32_t threads) {
    auto complex = initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = h});
    const Options<double> options{.edge_length = h};
    GrowthOptions<double> growing;
    for (const Shape& shape : shapes) {
        growing.speeds.push_back({shape.phase, 0, 1.0});
    }
    Simulation<double> simulation(complex, options,
                                  make_executor(complex, options, Parallel{.threads = threads},
                                                growth_algorithm(complex, growing)));
    const auto topology =
        std::make_shared<TopologyStage<double>>(TopologyOptions<double>{.rule = Topology::change});
    simulation.add_stage(topology);
    const InterfaceFlow<double> flow = growth(growing);
    Seam seam;
    const double dt = h / 2;
    for (int step = 0; step * dt < until; ++step) {
        seam.unreached += simulation.step(flow, step * dt, dt).unreached;
        for (const Event& event : topology->take_events()) {
            seam.exchanges += event.kind == EventKind::t1 ? 1U : 0U;
            seam.parted += event.kind == EventKind::t1 && event.lost != exterior_phase &&
                                   event.taken[0] == exterior_phase &&
                                   event.taken[1] == exterior_phase
                               ? 1U
                               : 0U;
        }
    }
    for (const Vertex v : vertices(complex)) {
        const auto has = [&](Phase phase) {
            return find_corner(complex, v,
                               [&](Corner c) { return complex.phase_at(c) == phase; }) != no_id;
        };
        const P place = complex.position(v);
        if (has(1) && has(2) && place.x() > 0.21 && place.x() < 0.79) {
            const double distance = std::abs(place.y() - 0.45) / h;
            seam.mean += distance;
            seam.max = std::max(seam.max, distance);
            ++seam.size;
        }
    }
    seam.mean /= static_cast<double>(seam.size);
    seam.is_valid = validate(complex).ok();
    seam.mesh_hash = mesh_hash(complex);
    return seam;
}

// Two fronts at y = 0.4 and y = 0.5 meet at y = 0.45 at the time 0.05.
const std::vector<Shape> flat{rectangle(0.3, 0.4, 1), rectangle(0.5, 0.6, 2)};

TEST(ParallelFronts, MeetOnTheLineHalfway) {
    for (const double h : {0.02, 0.01, 0.005}) {
        const Seam seam = grow(flat, 0.08, h, 1);
        EXPECT_TRUE(seam.is_valid) << h;
        EXPECT_EQ(seam.unreached, 0U) << h;
        EXPECT_EQ(seam.parted, 0U) << h;
        EXPECT_GT(static_cast<double>(seam.size), 0.58 / (1.5 * h)) << h; // a whole seam
        EXPECT_LT(seam.mean, 0.004) << h;
        EXPECT_LT(seam.max, 0.1) << h;
    }
}

TEST(ParallelFronts, MeetAlikeWithAnyThreads) {
    EXPECT_EQ(grow(flat, 0.08, 0.01, 2).mesh_hash, grow(flat, 0.08, 0.01, 3).mesh_hash);
}

// The corner in which four seams meet is not stable: two junctions are left of it, once.
TEST(ParallelFronts, FourThatMeetInAPointStayThere) {
    constexpr int points = 50;
    std::vector<Shape> discs;
    for (int k = 0; k < 4; ++k) {
        const double along = (0.25 + 0.5 * k) * std::numbers::pi;
        Shape disc{{}, static_cast<Phase>(k + 1)};
        for (int i = 0; i < points; ++i) {
            const double turn = 2 * std::numbers::pi * i / points;
            disc.outline.emplace_back(0.5 + 0.2 * std::cos(along) + 0.08 * std::cos(turn),
                                      0.5 + 0.2 * std::sin(along) + 0.08 * std::sin(turn));
        }
        discs.push_back(disc);
    }
    for (const double h : {0.02, 0.01}) {
        const Seam seam = grow(discs, 0.2, h, 1);
        EXPECT_TRUE(seam.is_valid) << h;
        EXPECT_EQ(seam.unreached, 0U) << h;
        EXPECT_LE(seam.exchanges, 1U) << h;
    }
}

} // namespace
} // namespace dsc::fronts::parallel_fronts_test
