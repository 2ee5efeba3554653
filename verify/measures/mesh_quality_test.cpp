// SPDX-License-Identifier: MIT
// The measurement of mesh quality must detect known faults.
#include "measures/mesh_quality.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/archive.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/quality/measures.h"
#include "support/random/scene.h"
#include "support/small_meshes.h"
#include "thesis/copies/copy_executor.h"
#include "topology/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>

namespace dsc::scenes::mesh_quality_test {
namespace {

TEST(MeshQuality, CountsTrianglesThatAreTurnedOver) {
    auto complex = test::hexagon<double>();
    EXPECT_EQ(measure_worst(complex).inverted, 0U);
    complex.set_position(Vertex{0}, {1.5, 0}); // beyond the edges on the right
    const MeshQuality quality = measure_quality(complex);
    EXPECT_EQ(quality.inverted, 2U);
    EXPECT_LT(quality.min_quality, 0);
}

TEST(MeshQuality, CountsTrianglesWithoutArea) {
    auto complex = test::hexagon<double>();
    complex.set_position(Vertex{0}, complex.position(Vertex{1}));
    EXPECT_EQ(measure_worst(complex).inverted, 2U);
}

TEST(MeshQuality, IsThatOfTheWorstTriangleWhereverItIs) {
    for (std::uint32_t worst = 1; worst <= 6; ++worst) {
        auto complex = test::hexagon<double>();
        const Triangle flat{worst};
        const auto v = complex.vertices_of(flat);
        const Point<double> middle =
            midpoint<double>(complex.position(v[1]), complex.position(v[2]));
        complex.set_position(Vertex{0}, 0.9 * middle);
        const MeshQuality quality = measure_quality(complex);
        EXPECT_EQ(quality.min_quality, dsc::quality(complex, flat));
        EXPECT_LT(quality.min_quality, 0.3);
        EXPECT_NEAR(quality.min_angle_deg, min_angle_deg(complex, flat), 1e-4);
    }
}

// Most triangles are skipped by a bound; the result must be bitwise identical to that of measuring
// each triangle.
template <class Real>
void expect_a_look_at_each(double size) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> away(-1.1, 1.1);
    for (int i = 0; i < 3000; ++i) {
        auto moved = test::hexagon<Real>();
        // Sometimes near an edge or a vertex, and sometimes exactly on it.
        moved.set_position(Vertex{0}, {static_cast<Real>(i % 5 == 0 ? 1 : away(random)),
                                       static_cast<Real>((i % 3 == 0 ? 1e-9 : 1) * away(random))});
        MeshQuality expected;
        for (std::uint32_t v = 0; v < 7; ++v) {
            moved.set_position(Vertex{v}, static_cast<Real>(size) * moved.position(Vertex{v}));
        }
        for (const Triangle t : triangles(moved)) {
            const auto [a, b, c] = moved.positions_of(t);
            expected.inverted += orientation<Real>(a, b, c) > 0 ? 0U : 1U;
            expected.min_quality =
                std::min(expected.min_quality, static_cast<double>(dsc::quality(moved, t)));
        }
        ASSERT_EQ(measure_worst(moved).min_quality, expected.min_quality) << size << ", " << i;
        ASSERT_EQ(measure_worst(moved).inverted, expected.inverted) << size << ", " << i;
    }
}

TEST(MeshQuality, IsThatOfALookAtEachTriangle) {
    for (const double size : {1.0, 1e-3, 1e-60, 1e-75, 1e60}) {
        expect_a_look_at_each<double>(size);
    }
    for (const double size : {1.0, 1e-3, 1e-15}) {
        expect_a_look_at_each<float>(size);
    }
}

// Inverts two triangles of a hexagon, in its first run.
class TurnsOver : public Stage<double> {
public:
    void run(const Between<double>& between) override {
        if (std::exchange(is_first_, false)) {
            between.complex.set_position(Vertex{0}, {1.5, 0}); // beyond the edges on the right
        }
    }

private:
    bool is_first_ = true;
};

// Inverted triangles are counted until they are mended; the worst quality so far is kept.
TEST(QualityWatch, LooksAtWhatStagesDo) {
    auto complex = test::hexagon<double>();
    Simulation<double> simulation(complex, {.edge_length = 1});
    simulation.add_stage(std::make_shared<TurnsOver>());
    QualityWatch<double> watch(simulation);
    EXPECT_EQ(watch.look().min_quality, measure_worst(complex).min_quality);
    const dsc::Velocity<double> at_rest = [](auto, double, auto velocities) {
        std::ranges::fill(velocities, Point<double>(0, 0));
    };
    simulation.step(at_rest, 0, 1);
    const MeshQuality beyond = watch.look();
    EXPECT_EQ(beyond.inverted, 2U);
    EXPECT_LT(beyond.min_quality, 0);
    EXPECT_EQ(watch.look().inverted, 2U) << "nothing was touched in between";
    for (int step = 1; step < 4; ++step) { // the mesh update changes the inverted triangles
        simulation.step(at_rest, step, 1);
        const MeshQuality after = watch.look();
        EXPECT_EQ(after.inverted, measure_worst(complex).inverted);
        EXPECT_EQ(after.min_quality, beyond.min_quality);
    }
}

// After every step, the watched figures are bitwise identical to those of the whole mesh.
template <class Real>
void expect_a_look_at_all(const Options<Real>& options, const Division* division,
                          const TopologyOptions<Real>& topology = {}) {
    auto complex = test::disc_complex<Real>(static_cast<double>(options.edge_length));
    auto executor =
        division != nullptr
            ? make_executor(complex, options, Parallel{.division = division, .submeshes = 4})
            : nullptr;
    Simulation<Real> simulation(complex, options, std::move(executor));
    if (topology.changes()) {
        simulation.add_stage(std::make_shared<TopologyStage<Real>>(topology));
    }
    QualityWatch<Real> watch(simulation);
    // Stretches the disc to two drops with a neck between them, and back.
    const dsc::Velocity<Real> squeeze = [](auto positions, Real time, auto velocities) {
        const Real speed = time < Real(0.5) ? 1 : -1;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Real x = positions[i].x() - Real(0.5);
            velocities[i] = {speed * 6 * x * (Real(0.35) - std::abs(x)),
                             speed * 3 * (Real(0.2) - std::abs(x)) *
                                 (Real(0.5) - positions[i].y())};
        }
    };
    const double first = watch.look().min_quality;
    double smallest = first;
    std::uint64_t edits = 0;
    const Real dt = Real(0.01);
    for (int step = 0; step < 100; ++step) {
        const StepReport report = simulation.step(squeeze, static_cast<Real>(step) * dt, dt);
        edits += report.operations.flips + report.operations.splits + report.operations.collapses;
        const MeshQuality all = measure_worst(complex);
        smallest = std::min(smallest, all.min_quality);
        const MeshQuality touched = watch.look();
        ASSERT_EQ(touched.min_quality, smallest) << "step " << step;
        ASSERT_EQ(touched.inverted, all.inverted) << "step " << step;
    }
    EXPECT_GT(edits, 300U) << "hardly anything was done";
    EXPECT_LT(smallest, first);
}

TEST(QualityWatch, IsALookAtAllAfterEachStep) {
    Options<double> options;
    options.edge_length = 0.03;
    for (const Division* division :
         {static_cast<const Division*>(nullptr), &cells_division, &copy_division}) {
        expect_a_look_at_all<double>(options, division);
        expect_a_look_at_all<double>(options, division, {.rule = Topology::change});
    }
    options.sizes.growth = 1.3;
    expect_a_look_at_all<double>(options, nullptr);
    Options<float> in_float;
    in_float.edge_length = 0.03F;
    expect_a_look_at_all<float>(in_float, &cells_division);
}

// A restored mesh may be worse than the mesh that was measured before, so it is measured as a
// whole.
TEST(QualityWatch, LooksAtAllAfterARestore) {
    auto worse = test::disc_complex<double>(0.03);
    auto complex = worse;
    const Options<double> options{.edge_length = 0.03};
    Simulation<double> other(worse, options);
    const dsc::Velocity<double> shear = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {positions[i].y() - 0.5, 0};
        }
    };
    for (int step = 0; step < 40; ++step) {
        other.step(shear, 0, 0.05);
    }
    Simulation<double> simulation(complex, options);
    QualityWatch<double> watch(simulation);
    const double first = watch.look().min_quality;
    Archive written;
    other.archive(written);
    Archive read(written.bytes(), "of the other simulation");
    simulation.archive(read);
    const double all = measure_worst(complex).min_quality;
    ASSERT_LT(all, first) << "nothing to be found";
    EXPECT_EQ(watch.look().min_quality, all);
}

// The list of poor stars does not grow without bound if an application never takes it.
TEST(QualityWatch, ListsNoMoreThanTheMeshHasTriangles) {
    auto complex = test::disc_complex<double>(0.1);
    Options<double> options;
    options.edge_length = 0.1;
    Simulation<double> simulation(complex, options);
    simulation.watch_quality(1); // every star
    const dsc::Velocity<double> turn = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {0.5 - positions[i].y(), positions[i].x() - 0.5};
        }
    };
    for (int step = 0; step < 200; ++step) {
        simulation.step(turn, 0, 0.05);
    }
    const auto all = simulation.take_poor();
    EXPECT_LE(all.size(), 2 * complex.triangle_bound());
    EXPECT_NE(std::ranges::find(all, no_id), all.end()) << "says that the list is not whole";
    simulation.step(turn, 0, 0.05);
    const auto some = simulation.take_poor();
    EXPECT_FALSE(some.empty());
    EXPECT_EQ(std::ranges::find(some, no_id), some.end());
}

} // namespace

} // namespace dsc::scenes::mesh_quality_test
