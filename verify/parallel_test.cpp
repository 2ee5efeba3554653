// SPDX-License-Identifier: MIT
// Parallel DSC: the same bits and the same counts for any number of threads, for every way to cut;
// a submesh leaves what it does not own alone; what a thread throws comes out.
#include "dsc/parallel/slab_executor.h"

#include "random_scene.h"

#include "dsc/base/error.h"
#include "dsc/complex/hash.h"
#include "dsc/complex/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <tuple>

namespace dsc {
namespace {

using test::Dice;
using test::RandomFlow;
using test::Wildness;

auto counts_of(const OperationCounts& c) {
    return std::tuple(c.moves, c.flips, c.interface_splits, c.interface_collapses, c.splits,
                      c.collapses, c.smoothed, c.subdivisions, c.retriangulations, c.examined);
}

struct Outcome {
    std::vector<std::uint64_t> hashes; ///< after each step
    OperationCounts counts;
    std::uint64_t unreached = 0;
    std::vector<std::uint32_t> interface;
    std::size_t red_slabs = 0;
};

template <class Real>
Outcome simulate(std::uint64_t seed, const SlabOptions& slabs, bool sequential = false) {
    constexpr double h = 0.025;
    Dice dice(seed);
    auto complex = seed % 3 == 0 ? test::random_patches<Real>(dice, h, 12)
                                 : test::random_shapes<Real>(dice, h);
    const RandomFlow flow(dice, 1, seed % 5 == 4 ? Wildness::not_a_number : Wildness::none);
    const Velocity<Real> velocity = flow.velocity<Real>();
    Options<Real> options;
    options.edge_length = static_cast<Real>(h);
    std::unique_ptr<Executor<Real>> executor;
    SlabExecutor<Real>* parallel = nullptr;
    if (!sequential) {
        auto made = std::make_unique<SlabExecutor<Real>>(complex, options,
                                                         default_algorithm<Real>(), slabs);
        parallel = made.get();
        executor = std::move(made);
    }
    Simulation<Real> simulation(complex, options, std::move(executor));
    Outcome outcome;
    for (int step = 0; step < 12; ++step) {
        const auto report =
            simulation.step(velocity, static_cast<Real>(step) * Real(0.01), Real(0.01));
        outcome.counts += report.operations;
        outcome.unreached += report.unreached;
        outcome.hashes.push_back(mesh_hash(complex));
        EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "")
            << "seed " << seed << ", step " << step;
    }
    EXPECT_EQ(validate(complex).problem, "") << "seed " << seed;
    outcome.interface = simulation.interface();
    outcome.red_slabs = parallel != nullptr ? parallel->cuts().red_count() : 1;
    return outcome;
}

class EverySlabbing : public testing::TestWithParam<Slabbing> {};

TEST_P(EverySlabbing, GivesTheSameBitsForAnyNumberOfThreads) {
    std::size_t most_slabs = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SlabOptions slabs;
        slabs.slabbing = GetParam();
        slabs.submeshes = static_cast<std::uint32_t>(2 + seed);
        slabs.least_width = 4;
        if (seed % 2 == 0) {
            slabs.normal_x = 0.6;
            slabs.normal_y = 0.8;
        }
        const Outcome one = simulate<double>(seed, slabs);
        most_slabs = std::max(most_slabs, one.red_slabs);
        for (const std::uint32_t threads : {2U, 3U, 5U}) {
            slabs.threads = threads;
            const Outcome many = simulate<double>(seed, slabs);
            EXPECT_EQ(many.hashes, one.hashes) << "seed " << seed << ", threads " << threads;
            EXPECT_EQ(counts_of(many.counts), counts_of(one.counts)) << "seed " << seed;
            EXPECT_EQ(many.unreached, one.unreached) << "seed " << seed;
            EXPECT_EQ(many.interface, one.interface) << "seed " << seed << ": ids differ";
        }
    }
    EXPECT_GE(most_slabs, 5U) << "hardly anything ran in parallel";
}

TEST_P(EverySlabbing, GivesTheSameBitsInFloat) {
    SlabOptions slabs;
    slabs.slabbing = GetParam();
    slabs.submeshes = 5;
    slabs.least_width = 4;
    const Outcome one = simulate<float>(1, slabs);
    slabs.threads = 4;
    EXPECT_EQ(simulate<float>(1, slabs).hashes, one.hashes);
}

TEST_P(EverySlabbing, IsTheSequentialMethodWhereThereIsOneSlab) {
    SlabOptions slabs;
    slabs.slabbing = GetParam();
    slabs.submeshes = 1;
    slabs.threads = 3;
    const Outcome one = simulate<double>(2, slabs);
    const Outcome sequential = simulate<double>(2, slabs, true);
    EXPECT_EQ(one.red_slabs, 1U);
    EXPECT_EQ(one.unreached, sequential.unreached);
    EXPECT_NEAR(static_cast<double>(one.counts.moves), static_cast<double>(sequential.counts.moves),
                0.05 * static_cast<double>(sequential.counts.moves));
}

INSTANTIATE_TEST_SUITE_P(Parallel, EverySlabbing,
                         testing::Values(Slabbing::fixed, Slabbing::counting, Slabbing::active),
                         [](const auto& one) { return std::string(to_string(one.param)); });

// All that is known of a vertex but the scratch of the active set.
struct Seen {
    double x, y;
    std::uint32_t flags;
    friend bool operator==(const Seen&, const Seen&) = default;
};

// The passes run on one slab only: whatever is not owned stays bit for bit, and so do the triangles
// that are not wholly in the slab, but for their links into it.
TEST(Submesh, LeavesAloneWhatItDoesNotOwn) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        constexpr double h = 0.03;
        Dice dice(seed);
        auto complex = seed % 2 == 0 ? test::random_patches<double>(dice, h, 8)
                                     : test::random_shapes<double>(dice, h);
        Options<double> options;
        options.edge_length = h;
        const RandomFlow flow(dice, 1, Wildness::none);
        Work<double> work(complex, options);
        const double low = dice.in(0.2, 0.4);
        const std::array<double, 2> cuts{low, low + 0.3};
        work.submesh.region = slab_region(cuts, 0, 1, 0);
        IdPool pool;
        for (int i = 0; i < 200; ++i) {
            const std::uint32_t v = complex.take_vertex(complex.ids);
            complex.vertices[v].flags = vertex_dead;
            pool.vertices.push_back(v);
            for (int k = 0; k < 2; ++k) {
                const std::uint32_t t = complex.take_triangle(complex.ids);
                complex.triangles[t].v = {no_id, no_id, no_id};
                pool.triangles.push_back(t);
            }
        }
        pool.may_grow = false;
        work.submesh.pool = &pool;
        const auto on = test::on_interface(complex);
        work.epoch = 1;
        for (std::uint32_t v = 0; v < on.size(); ++v) {
            if (on[v] != 0) {
                work.interface.push_back(v);
            }
        }
        const auto vertices = complex.vertices;
        const auto triangles = complex.triangles;
        const auto owned = [&](std::uint32_t v) {
            return vertices[v].x >= cuts[0] && vertices[v].x < cuts[1];
        };
        std::vector<Point<double>> positions;
        for (const std::uint32_t v : work.interface) {
            positions.push_back(complex.position(Vertex{v}));
        }
        std::vector<Point<double>> velocities(positions.size());
        flow.velocity<double>()(positions, 0, velocities);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> target = positions[i] + 0.5 * h * velocities[i];
            work.movers.push_back({work.interface[i], target.x(), target.y()});
        }
        const auto algorithm = default_algorithm<double>();
        for (const auto* passes : {&algorithm.upkeep, &algorithm.motion}) {
            for (const auto& pass : *passes) {
                pass.run(work);
            }
        }
        EXPECT_GT(work.counts.moves, 0U);
        int foreign = 0;
        for (std::uint32_t v = 0; v < vertices.size(); ++v) {
            if ((vertices[v].flags & vertex_dead) == 0 && !owned(v)) {
                ++foreign;
                const auto& now = complex.vertices[v];
                ASSERT_EQ((Seen{now.x, now.y, now.flags}),
                          (Seen{vertices[v].x, vertices[v].y, vertices[v].flags}))
                    << "vertex " << v << " of seed " << seed;
            }
        }
        for (std::uint32_t t = 1; t < triangles.size(); ++t) {
            const auto& v = triangles[t].v;
            if (v[0] != no_id && !(owned(v[0]) && owned(v[1]) && owned(v[2]))) {
                ASSERT_EQ(complex.triangles[t].v, v) << "triangle " << t << " of seed " << seed;
                ASSERT_EQ(complex.triangles[t].phase, triangles[t].phase);
            }
        }
        EXPECT_GT(foreign, 100);
        // Everyone is accounted for: arrived, still on the way, or put off.
        for (const auto& mover : work.put_off_movers) {
            EXPECT_FALSE(on[mover.vertex] == 0);
        }
        complex.lent_vertices = static_cast<std::uint32_t>(pool.vertices.size());
        complex.lent_triangles = static_cast<std::uint32_t>(pool.triangles.size());
        EXPECT_EQ(validate(complex).problem, "") << "seed " << seed;
    }
}

// --- failures ----------------------------------------------------------------------------------

struct Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

TEST(SlabExecutor, PassesOnWhatAVelocityThrows) {
    constexpr double h = 0.03;
    for (const std::uint32_t threads : {1U, 2U, 4U}) {
        auto complex = test::disc_complex<double>(h);
        Options<double> options;
        options.edge_length = h;
        SlabOptions slabs;
        slabs.submeshes = 4;
        slabs.threads = threads;
        Simulation<double> simulation(complex, options,
                                      std::make_unique<SlabExecutor<double>>(
                                          complex, options, default_algorithm<double>(), slabs));
        const Velocity<double> velocity = [](std::span<const Point<double>> positions, double,
                                             std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                if (positions[i].x() > 0.7) {
                    throw Fault("no velocity here");
                }
                velocities[i] = {0.01, 0};
            }
        };
        EXPECT_THROW((void)simulation.step(velocity, 0, 1), Fault);
        EXPECT_EQ(validate(complex).problem, "");
        // The complex is still good for another step.
        const Velocity<double> good = [](std::span<const Point<double>> positions, double,
                                         std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                velocities[i] = {0.01, 0};
            }
        };
        EXPECT_EQ(simulation.step(good, 0, 1).unreached, 0U);
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
    }
}

// A pass of the application throws in one slab, before or after the others ran there. The step is
// lost, the simulation is not.
TEST(SlabExecutor, GoesOnAfterAPassThrew) {
    constexpr double h = 0.03;
    for (const bool in_upkeep : {true, false}) {
        for (const bool before : {true, false}) {
            SCOPED_TRACE(std::string(in_upkeep ? "upkeep" : "motion") +
                         (before ? ", first" : ", last"));
            auto complex = test::disc_complex<double>(h);
            Options<double> options;
            options.edge_length = h;
            std::atomic<bool> faulty{true};
            const Pass<double> fault{"fault", [&](Work<double>& work) {
                                         if (faulty && work.submesh.region.low > 0.4) {
                                             throw Fault("as seeded");
                                         }
                                     }};
            auto algorithm = default_algorithm<double>();
            auto& passes = in_upkeep ? algorithm.upkeep : algorithm.motion;
            passes.insert(before ? passes.begin() : passes.end(), fault);
            SlabOptions slabs;
            slabs.submeshes = 4;
            slabs.threads = 3;
            Simulation<double> simulation(
                complex, options,
                std::make_unique<SlabExecutor<double>>(complex, options, algorithm, slabs));
            const Velocity<double> right = [](std::span<const Point<double>> positions, double,
                                              std::span<Point<double>> velocities) {
                for (std::size_t i = 0; i < positions.size(); ++i) {
                    velocities[i] = {0.01, 0};
                }
            };
            EXPECT_THROW((void)simulation.step(right, 0, 1), Fault);
            EXPECT_EQ(validate(complex).problem, "");
            EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
            // What was on its way when the step was lost must not arrive in a later one.
            faulty = false;
            const Velocity<double> rest = [](std::span<const Point<double>> positions, double,
                                             std::span<Point<double>> velocities) {
                for (std::size_t i = 0; i < positions.size(); ++i) {
                    velocities[i] = {0, 0};
                }
            };
            EXPECT_EQ(simulation.step(rest, 0, 1).operations.moves, 0U);
            EXPECT_EQ(simulation.step(right, 0, 1).unreached, 0U);
            EXPECT_EQ(validate(complex).problem, "");
            EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
        }
    }
}

TEST(SlabExecutor, RefusesOptionsThatMakeNoSense) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct Seeded {
        const char* where;
        void (*seed)(SlabOptions&, double);
    };
    const std::array<Seeded, 10> faults{{
        {"submeshes", [](SlabOptions& s, double) { s.submeshes = 0; }},
        {"submeshes", [](SlabOptions& s, double) { s.submeshes = 70000; }},
        {"threads", [](SlabOptions& s, double) { s.threads = 0; }},
        {"threads", [](SlabOptions& s, double) { s.threads = 5000; }},
        {"normal", [](SlabOptions& s, double) { s.normal_x = 0; }},
        {"normal", [](SlabOptions& s, double) { s.normal_y = 1; }},
        {"normal", [](SlabOptions& s, double bad) { s.normal_x = bad; }},
        {"least_width", [](SlabOptions& s, double) { s.least_width = 1; }},
        {"least_width", [](SlabOptions& s, double bad) { s.least_width = bad; }},
        {"recount", [](SlabOptions& s, double) { s.recount = 0; }},
    }};
    for (const auto& fault : faults) {
        SlabOptions slabs;
        fault.seed(slabs, nan);
        try {
            SlabExecutor<double> executor(complex, options, default_algorithm<double>(), slabs);
            ADD_FAILURE() << "accepted: " << fault.where;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), fault.where);
        }
    }
}

// --- cuts --------------------------------------------------------------------------------------

TEST(Cuts, GiveEachSlabTheSameShareAndNoneIsThin) {
    Dice dice(1);
    std::vector<double> positions;
    for (int i = 0; i < 4000; ++i) {
        positions.push_back(dice.chance(0.5) ? dice.in(0.0, 1.0) : dice.in(0.2, 0.5));
    }
    const Cuts cuts = cuts_of_equal_share(positions, 8, 0.01);
    ASSERT_EQ(cuts.red_count(), 8U);
    std::array<int, 8> held{};
    for (const double s : positions) {
        ++held.at(slab_of(cuts.red, s));
    }
    for (const int count : held) {
        EXPECT_NEAR(count, 500, 2);
    }
    const Cuts wide = cuts_of_equal_share(positions, 8, 0.2);
    EXPECT_LT(wide.red_count(), 6U);
    for (std::size_t i = 1; i + 2 < wide.red.size(); ++i) {
        EXPECT_GE(wide.red[i + 1] - wide.red[i], 0.2);
    }
}

TEST(Cuts, CoverEverything) {
    Dice dice(2);
    for (const double least : {0.0, 0.05, 0.5, 5.0}) {
        for (const std::uint32_t slabs : {1U, 2U, 3U, 8U, 100U}) {
            std::vector<double> positions;
            const int n = dice.in(0, 300);
            for (int i = 0; i < n; ++i) {
                positions.push_back(dice.in(-1.0, 1.0));
            }
            for (const Cuts& cuts : {cuts_of_equal_share(positions, slabs, least),
                                     cuts_of_equal_width(-1, 1, slabs, least)}) {
                for (const auto* list : {&cuts.red, &cuts.black}) {
                    ASSERT_GE(list->size(), 2U);
                    EXPECT_EQ(list->front(), -std::numeric_limits<double>::infinity());
                    EXPECT_EQ(list->back(), std::numeric_limits<double>::infinity());
                    EXPECT_TRUE(std::is_sorted(list->begin(), list->end()));
                    for (int i = 0; i < 20; ++i) {
                        const double s = i < 2 ? (i == 0 ? -1e9 : 1e9) : dice.in(-2.0, 2.0);
                        const std::size_t slab = slab_of(*list, s);
                        ASSERT_LT(slab, list->size() - 1);
                        const Region region = slab_region(*list, slab, 1, 0);
                        EXPECT_TRUE(region.owns(0, s, 17));
                    }
                }
            }
        }
    }
}

// Black slabs straddle the cuts of the red ones: what one colour locks, the other does not.
TEST(Cuts, OfTheTwoColoursLieApart) {
    const Cuts cuts = cuts_of_equal_width(0, 1, 8, 0.1);
    ASSERT_EQ(cuts.red_count(), 8U);
    for (std::size_t i = 1; i + 1 < cuts.red.size(); ++i) {
        double nearest = 1;
        for (const double black : cuts.black) {
            nearest = std::min(nearest, std::abs(black - cuts.red[i]));
        }
        EXPECT_GE(nearest, 0.05) << "red cut " << i;
    }
}

} // namespace
} // namespace dsc
