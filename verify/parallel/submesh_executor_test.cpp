// SPDX-License-Identifier: MIT
// The executor of submeshes: exceptions in a submesh are passed on, and the simulation can
// continue; use of threads and memory.
#include "dsc/parallel/in_place/submesh_executor.h"

#include "support/refusal.h"
#include "support/submesh_executor_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/error.h"
#include "dsc/base/timer.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/work.h"
#include "dsc/queries/validate.h"
#include "thesis/divisions/slabs.h"
#include "thesis/divisions/voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dsc::submesh_executor_test {
namespace {

using test::Growing;
using test::NamedPartitioner;
using test::ways_to_divide;

// --- failures -----------------------------------------------------------------------------------

struct Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

bool is_same(const Region& a, const Region& b) {
    return a.kind == b.kind && a.low == b.low && a.high == b.high && a.side_low == b.side_low &&
           a.side_high == b.side_high && a.place == b.place && a.context == b.context &&
           a.label == b.label;
}

// A pass of the application throws in one submesh of some colour, or in the serial part, before or
// after the other passes ran there, in a step that is not the first. The step is lost, but not the
// simulation.
TEST(SubmeshExecutor, GoesOnAfterAPassThrew) {
    constexpr std::size_t serial = 99;
    int serial_faults = 0;
    for (const NamedPartitioner& way : ways_to_divide(3)) {
        for (const bool in_remeshing : {true, false}) {
            for (const bool before : {true, false}) {
                for (const std::size_t colour : {std::size_t{0}, std::size_t{1}, serial}) {
                    if (in_remeshing && colour == 1) {
                        continue; // work deferred by the first colour is done serially
                    }
                    SCOPED_TRACE(
                        std::string(way.name) + (in_remeshing ? ", remeshing" : ", motion") +
                        (before ? ", first" : ", last") + ", colour " + std::to_string(colour));
                    std::atomic<bool> is_armed{false};
                    std::atomic<bool> has_thrown{false};
                    const SubmeshExecutor<double>* seen = nullptr;
                    const auto is_meant = [&](const Region& region) {
                        if (colour == serial) {
                            return region.is_whole();
                        }
                        // Any submesh of the colour except the first.
                        const auto& regions = seen->view().partition.colours.at(colour).regions;
                        return std::any_of(regions.begin() + 1, regions.end(), [&](const auto& r) {
                            return is_same(r.simplest(), region);
                        });
                    };
                    const Pass<double> fault{"fault", [&](Work<double>& work) {
                                                 if (is_armed && is_meant(work.submesh.region)) {
                                                     has_thrown = true;
                                                     throw Fault("as seeded");
                                                 }
                                             }};
                    auto algorithm = default_algorithm<double>();
                    auto& passes = in_remeshing ? algorithm.remeshing : algorithm.motion;
                    passes.insert(before ? passes.begin() : passes.end(), fault);
                    Growing disc(way.make(), 3, algorithm);
                    seen = disc.seen;
                    (void)disc.simulation->step(disc.grow, 0, Growing::h);
                    disc.expect_good();
                    is_armed = true;
                    bool came_out = false;
                    for (int step = 0; step < 4 && !came_out; ++step) {
                        try {
                            (void)disc.simulation->step(disc.grow, 0, Growing::h);
                        } catch (const Fault&) {
                            came_out = true;
                        }
                    }
                    EXPECT_EQ(came_out, has_thrown);
                    if (colour != serial) {
                        EXPECT_TRUE(has_thrown) << "nothing ran there";
                    }
                    serial_faults += colour == serial && has_thrown ? 1 : 0;
                    is_armed = false;
                    disc.expect_to_go_on();
                }
            }
        }
    }
    EXPECT_GE(serial_faults, 2) << "nothing was ever left to be done serially";
}

// A partitioner of the application that does not cover the plane, or that throws.
TEST(SubmeshExecutor, PassesOnWhatIsWrongWithAPartition) {
    bool is_faulty = false;
    bool has_gap = false;
    Growing disc(std::make_unique<PlacePartitioner<double>>(
                     [&](const PartitionInput<double>& input) {
                         if (is_faulty) {
                             throw Fault("no partition");
                         }
                         auto colours = voronoi_colours(input, 4);
                         if (has_gap) {
                             colours[0].number_of = [](double, double) { return 9U; };
                         }
                         return colours;
                     },
                     2),
                 2);
    for (int step = 0; step < 10; ++step) {
        is_faulty = step == 2;
        has_gap = step == 7;
        if (is_faulty) {
            EXPECT_THROW((void)disc.simulation->step(disc.grow, 0, Growing::h), Fault);
        } else if (has_gap) {
            EXPECT_THROW((void)disc.simulation->step(disc.grow, 0, Growing::h), InputError);
        } else {
            EXPECT_EQ(disc.simulation->step(disc.grow, 0, Growing::h).unreached, 0U);
        }
        disc.expect_good();
    }
    auto complex = test::disc_complex<double>(Growing::h);
    Options<double> options;
    options.edge_length = Growing::h;
    const auto divide = [&](const PlaceFunction<double>& function) {
        const SubmeshExecutor<double> executor(complex, options, default_algorithm<double>(),
                                               std::make_unique<PlacePartitioner<double>>(function),
                                               Parallel{});
    };
    EXPECT_THROW(divide([](const PartitionInput<double>&) {
                     return std::vector<PlaceColour>{
                         {[](double x, double) { return x < 0.5 ? 0U : 2U; }, 2}};
                 }),
                 InputError);
    EXPECT_THROW(divide([](const PartitionInput<double>&) -> std::vector<PlaceColour> {
                     throw Fault("no partition");
                 }),
                 Fault);
    EXPECT_EQ(validate(complex).problem, "");
}

// --- options ------------------------------------------------------------------------------------

TEST(SubmeshExecutor, RefusesOptionsThatMakeNoSense) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    const auto make = [&](bool with_partitioner, const Parallel& submeshes) {
        std::unique_ptr<Partitioner<double>> partitioner;
        if (with_partitioner) {
            partitioner = std::make_unique<SlabPartitioner<double>>(SlabOptions{});
        }
        const SubmeshExecutor<double> executor(complex, options, default_algorithm<double>(),
                                               std::move(partitioner), submeshes);
    };
    make(true, {});
    EXPECT_THROW(make(false, {}), InputError);
    for (const std::uint32_t threads : {0U, 5000U}) {
        test::expect_refusal([&] { make(true, {.threads = threads}); }, "threads");
    }
    EXPECT_EQ(validate(complex).problem, "");
}

// --- threads and memory -------------------------------------------------------------------------

// A stage, and a motion of the whole interface, share their work among the threads of the step:
// each share is done once, whatever the number of threads, and an exception in a share is passed
// on.
struct Sharing final : Stage<double> {
    void run(const Between<double>& between) override { share(between.in_shares); }
    void share(const InShares& in_shares) {
        for (const std::size_t shares : {3U, 64U, 1U}) {
            std::vector<std::atomic<int>> done(shares);
            in_shares(shares, [&](std::size_t share) { ++done.at(share); });
            for (const std::atomic<int>& times : done) {
                EXPECT_EQ(times, 1);
            }
            EXPECT_THROW(in_shares(shares, [](std::size_t) { throw Fault("as seeded"); }), Fault);
        }
        ++calls;
    }
    int calls = 0;
};

TEST(SubmeshExecutor, ThreadsOfAStepShareTheWorkOfStagesAndMotions) {
    for (const std::uint32_t submeshes : {1U, 4U}) {
        Growing disc(std::make_unique<SlabPartitioner<double>>(
                         SlabOptions{.submeshes = submeshes, .min_width = 4}),
                     3);
        const auto stage = std::make_shared<Sharing>();
        disc.simulation->add_stage(stage);
        const InterfaceMotion<double> still = [&](const InterfaceView<double>& view, double, double,
                                                  std::span<Point<double>>) {
            stage->share(view.in_shares);
        };
        (void)disc.simulation->step(still, 0, 1);
        EXPECT_EQ(stage->calls, 2);
        disc.expect_good();
    }
}

TEST(SubmeshExecutor, UsesNoMoreThreadsThanThereIsWorkFor) {
    // At most one thread for each 32 interface vertices is used.
    const auto threads_of = [&](std::uint32_t threads, double radius, bool always_all) {
        constexpr double h = 0.02;
        auto complex = test::disc_complex<double>(h, {0.5, 0.5}, radius);
        Options<double> options;
        options.edge_length = h;
        auto executor = std::make_unique<SubmeshExecutor<double>>(
            complex, options, default_algorithm<double>(),
            std::make_unique<SlabPartitioner<double>>(
                SlabOptions{.slabbing = Slabbing::fixed, .submeshes = 4, .min_width = 4}),
            Parallel{.threads = threads, .always_all_threads = always_all});
        const SubmeshExecutor<double>& seen = *executor;
        Simulation<double> simulation(complex, options, std::move(executor));
        std::uint32_t largest = 0; // the executor begins with one thread, then tries all
        for (int step = 0; step < 8; ++step) {
            (void)simulation.step(test::constant<double>(0.001, 0), 0, 1);
            largest = std::max(largest, seen.view().threads_used);
        }
        EXPECT_EQ(seen.view().partition.colours.front().regions.size(), 4U);
        return largest;
    };
    EXPECT_EQ(threads_of(1, 0.25, true), 1U);
    EXPECT_EQ(threads_of(3, 0.25, true), 3U);
    EXPECT_EQ(threads_of(9, 0.25, true), 4U) << "no more than submeshes";
    EXPECT_EQ(threads_of(4, 0.25, false), 2U) << "of some 79 vertices";
    EXPECT_EQ(threads_of(4, 0.15, false), 1U) << "of some 48 vertices";
}

TEST(SubmeshExecutor, ThreadsAreBusyForAPartOfTheirSections) {
    for (const std::uint32_t threads : {1U, 3U}) {
        Growing disc(
            std::make_unique<SlabPartitioner<double>>(SlabOptions{.submeshes = 4, .min_width = 4}),
            threads);
        Timer timer;
        for (int step = 0; step < 5; ++step) {
            (void)disc.simulation->step(disc.grow, 0, Growing::h);
        }
        const double wall_s = timer.lap();
        const ThreadWork& work = disc.seen->view().work;
        ASSERT_EQ(work.busy_s.size(), threads);
        for (const double busy_s : work.busy_s) {
            EXPECT_GE(busy_s, 0);
            EXPECT_LE(busy_s, work.sections_s);
        }
        EXPECT_GT(work.sections_s, 0);
        EXPECT_GT(work.busy_s.front(), 0);
        EXPECT_LT(work.sections_s, wall_s);
        const double utilisation = (wall_s + work.beyond_one()) / (threads * wall_s);
        EXPECT_GT(utilisation, 0);
        EXPECT_LE(utilisation, 1);
    }
}

// The addresses of all arrays that grow with the mesh.
std::vector<const void*> storage_of(Complex<double>& complex) {
    return {complex.vertices.data(), complex.triangles.data(),
            complex.attributes.get<Vertex, double>("at vertices").data().data(),
            complex.attributes.get<Edge, double>("at edges").data().data(),
            complex.attributes.get<Triangle, double>("at triangles").data().data()};
}

// Attributes of all kinds exist before the executor is made, which reserves memory for them too.
void add_attributes(Complex<double>& complex) {
    complex.attributes.add<Vertex, double>("at vertices");
    complex.attributes.add<Edge, double>("at edges");
    complex.attributes.add<Triangle, double>("at triangles");
}

// The work that grows with the size of the mesh is done at construction.
TEST(SubmeshExecutor, CopiesNoArrayOfTheMeshInItsFirstStep) {
    for (const NamedPartitioner& way : ways_to_divide(8)) {
        SCOPED_TRACE(way.name);
        Growing disc(way.make(), 1, default_algorithm<double>(), &add_attributes);
        const auto before = storage_of(disc.complex);
        const auto vertices = disc.complex.vertex_bound();
        const auto triangles = disc.complex.triangle_bound();
        const StepReport report = disc.simulation->step(disc.grow, 0, Growing::h);
        EXPECT_GT(report.operations.interface_splits, 0U) << "nobody asked for an id";
        EXPECT_EQ(storage_of(disc.complex), before);
        // Submeshes have their own ids; only the serial rest of the work takes a few more.
        EXPECT_LT(disc.complex.vertex_bound(), vertices + 32) << "ids were lent in the step";
        EXPECT_LT(disc.complex.triangle_bound(), triangles + 64) << "ids were lent in the step";
        disc.expect_good();
    }
}

} // namespace
} // namespace dsc::submesh_executor_test
