// SPDX-License-Identifier: MIT
// Threads in three dimensions change nothing but the time.
#include "dsc3/space_testing.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <vector>

namespace dsc3::test::parallel_test {
namespace {

constexpr double h = 1.0 / 24;
constexpr double dt = 1.0 / 16;

struct Tracked {
    explicit Tracked(const Parallel& parallel, double radius = 0.25)
        : complex(initial_complex({}, {{ball({0.35, 0.35, 0.35}, radius), 1}}, {.edge_length = h})),
          simulation(complex, {.edge_length = h}, parallel) {
        complex.attributes.add<Vertex>("heat", 20.0);
        number_tets(complex, complex.attributes.add<Tet>("number", std::uint32_t{0}));
    }
    // The mesh, ids, free ids, attributes, and all else that later steps depend on.
    [[nodiscard]] std::string bytes() {
        dsc::Archive archive;
        simulation.archive(archive);
        return archive.bytes();
    }
    [[nodiscard]] bool are_renumbered() const {
        return test::are_renumbered(complex, complex.attributes.get<Tet, std::uint32_t>("number"));
    }
    StepReport step(int k) { return simulation.step(swirl, k * dt, dt); }

    Complex complex;
    Simulation simulation;
};

TEST(Parallel3, TheSameBitsForAnyNumberOfThreads) {
    const bool few = dsc::test::are_asked_for("few");
    const int steps = few ? 3 : 6;
    Tracked one({.threads = 1});
    std::vector<std::unique_ptr<Tracked>> others;
    for (const std::uint32_t threads : {2U, 3U, 4U}) {
        others.push_back(std::make_unique<Tracked>(Parallel{.threads = threads}));
    }
    StepReport sum;
    for (int k = 0; k < steps; ++k) {
        const StepReport report = one.step(k);
        sum.treated += report.treated;
        sum.treated_together += report.treated_together;
        sum.operations += report.operations;
        EXPECT_EQ(report.unreached, 0U);
        const ValidationReport valid = validate(one.complex);
        ASSERT_TRUE(valid.ok()) << "step " << k << ": " << valid.problem;
        const std::string bytes = one.bytes();
        for (const auto& other : others) {
            EXPECT_EQ(other->step(k).treated_together, report.treated_together);
            ASSERT_EQ(other->bytes(), bytes) << "step " << k;
        }
    }
    // Most of the repair is shared, else this would prove nothing.
    EXPECT_GT(sum.treated_together, 0.5 * double(sum.treated));
    EXPECT_GT(sum.operations.interface_splits, 20U);
    EXPECT_NE(one.are_renumbered(), few);
}

TEST(Parallel3, AVelocityAtOnceIsCalledForTheWholeInterfaceByThisThread) {
    Tracked plain({.threads = 2});
    Tracked at_once({.threads = 2});
    const auto here = std::this_thread::get_id();
    std::size_t calls = 0;
    const VelocityAtOnce velocity{[&](auto positions, double time, auto velocities) {
        ++calls;
        EXPECT_EQ(std::this_thread::get_id(), here);
        EXPECT_EQ(positions.size(), at_once.simulation.interface().size());
        swirl(positions, time, velocities);
    }};
    for (int k = 0; k < 2; ++k) {
        calls = 0;
        EXPECT_EQ(plain.step(k).unreached, 0U);
        const StepReport report = at_once.simulation.step(velocity, k * dt, dt);
        EXPECT_EQ(calls, 4U * report.sub_steps);
        EXPECT_EQ(at_once.bytes(), plain.bytes());
    }
}

// Shells around the ball's centre, which no tree of planes makes.
const Partition shells = [](const Point& p) {
    return static_cast<std::uint32_t>((p - Point(0.35, 0.35, 0.35)).norm() / 0.1);
};

// Another division gives another mesh, which is as good.
TEST(Parallel3, AnyDivisionWillDo) {
    const int steps = dsc::test::are_asked_for("few") ? 2 : 5;
    for (const Parallel& way :
         {Parallel{.submeshes = 1}, Parallel{.submeshes = 2}, Parallel{.submeshes = 8},
          Parallel{.submeshes = 64}, Parallel{.division = Division::fixed},
          Parallel{.submeshes = 8, .division = Division::active},
          Parallel{.division = Division::blocks}, Parallel{.partition = shells}}) {
        Parallel on_three = way;
        on_three.threads = 3;
        Tracked one(way);
        Tracked three(on_three);
        const double volume = phase_volume(one.complex, 1);
        StepReport sum;
        for (int k = 0; k < steps; ++k) {
            const StepReport report = one.step(k);
            sum.treated += report.treated;
            sum.treated_together += report.treated_together;
            EXPECT_EQ(report.unreached, 0U);
            ASSERT_TRUE(validate(one.complex).ok()) << "step " << k;
            three.step(k);
            ASSERT_EQ(three.bytes(), one.bytes()) << "step " << k;
            EXPECT_EQ(three.simulation.mesh_quality(), mesh_quality(one.complex));
        }
        EXPECT_GT(sum.treated_together, 0.5 * double(sum.treated));
        EXPECT_NEAR(phase_volume(one.complex, 1) / volume, 1, 0.01);
        EXPECT_GT(mesh_quality(one.complex).min_dihedral, 2);
    }
}

// The sections of a step, with a time for each task.
TEST(Parallel3, AProfileHasTheTimesOfAllTasks) {
    Tracked plain({.threads = 2});
    plain.step(0);
    EXPECT_TRUE(plain.simulation.profile().sections.empty());
    Tracked run({.threads = 2, .profile = true});
    for (int k = 0; k < 2; ++k) { // each step begins anew
        run.step(k);
        const StepProfile& profile = run.simulation.profile();
        ASSERT_GT(profile.sections.size(), 20U);
        ASSERT_EQ(profile.sections.front().first_task, 0U);
        for (std::size_t i = 0; i < profile.sections.size(); ++i) {
            const bool is_last = i + 1 == profile.sections.size();
            const std::size_t end =
                is_last ? profile.tasks.size() : profile.sections[i + 1].first_task;
            double sum = 0;
            for (std::size_t task = profile.sections[i].first_task; task < end; ++task) {
                EXPECT_GT(profile.tasks[task], 0);
                EXPECT_LE(profile.tasks[task], profile.sections[i].wall);
                sum += profile.tasks[task];
            }
            EXPECT_LE(sum, 2 * profile.sections[i].wall);
        }
    }
    EXPECT_EQ(mesh_hash(run.complex), (plain.step(1), mesh_hash(plain.complex)));
    dsc::Archive saved(plain.bytes(), "saved");
    run.simulation.archive(saved);
    EXPECT_TRUE(run.simulation.profile().sections.empty());
}

TEST(Parallel3, ACheckpointGoesOnToTheSameBits) {
    Tracked first({.threads = 2});
    for (int k = 0; k < 3; ++k) {
        first.step(k);
    }
    ASSERT_FALSE(first.are_renumbered());
    dsc::Archive saved(first.bytes(), "saved");
    Tracked second({.threads = 3});
    second.step(0); // what is read takes the place of all that was
    second.simulation.archive(saved);
    saved.expect_end();
    for (int k = 3; k < 6; ++k) {
        first.step(k);
        second.step(k);
    }
    EXPECT_EQ(first.bytes(), second.bytes());
    EXPECT_TRUE(first.are_renumbered());
    for (const Parallel& way :
         {Parallel{.submeshes = 2}, Parallel{.submeshes = 4},
          Parallel{.division = Division::active}, Parallel{.partition = shells}}) {
        Tracked other(way);
        const std::string before = other.bytes();
        dsc::Archive archive(first.bytes(), "saved");
        EXPECT_THROW(other.simulation.archive(archive), FileError);
        EXPECT_EQ(other.bytes(), before);
    }
}

TEST(Parallel3, ACheckpointIsForOnePartition) {
    const Partition halves = [](const Point& p) { return p.x() < 0.35 ? 0U : 1U; };
    Tracked first({.partition = shells});
    first.step(0);
    for (const auto& [partition, is_same] : {std::pair(shells, true), std::pair(halves, false)}) {
        Tracked other({.threads = 2, .partition = partition});
        dsc::Archive archive(first.bytes(), "saved");
        if (is_same) {
            other.simulation.archive(archive);
            EXPECT_EQ(other.bytes(), first.bytes());
        } else {
            EXPECT_THROW(other.simulation.archive(archive), FileError);
        }
    }
}

TEST(Parallel3, APartitionDividesTheDomainAndALittleAround) {
    const Box domain{.low = {2, 2, 2}, .high = {3, 3, 3}};
    Complex complex =
        initial_complex(domain, {{ball({2.5, 2.5, 2.5}, 0.2), 1}}, {.edge_length = 0.1});
    double farthest = 0;
    const Partition partition = [&](const Point& p) {
        farthest = std::max(farthest, (p - Point(2.5, 2.5, 2.5)).cwiseAbs().maxCoeff() - 0.5);
        return p.x() < 2.5 ? 0U : 1U;
    };
    Simulation simulation(complex, {.edge_length = 0.1}, {.partition = partition});
    const Velocity grow = [](std::span<const Point> p, double, std::span<Point> v) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            v[i] = p[i] - Point(2.5, 2.5, 2.5);
        }
    };
    for (int k = 0; k < 4; ++k) {
        simulation.step(grow, 0, 0.1);
    }
    dsc::Archive archive;
    simulation.archive(archive);
    EXPECT_GT(farthest, 0);
    EXPECT_LT(farthest, 5 * 0.1);
}

TEST(Parallel3, WhatAVelocityThrowsComesOutOfTheStep) {
    Tracked run({.threads = 3});
    const Velocity bad = [](std::span<const Point> p, double, std::span<Point> w) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p[i].x() > 0.5) {
                throw std::runtime_error("no velocity there");
            }
            w[i].setZero();
        }
    };
    EXPECT_THROW(run.simulation.step(bad, 0, dt), std::runtime_error);
    EXPECT_TRUE(validate(run.complex).ok());
    EXPECT_EQ(run.step(0).unreached, 0U);
}

TEST(Parallel3, EditsBetweenStepsAreTakenAccountOf) {
    Tracked run({.threads = 2});
    run.step(0);
    renumber(run.complex);
    Workspace work;
    for (std::uint32_t v = 0; v < run.complex.vertex_bound(); ++v) {
        Star star;
        gather(run.complex, v, star);
        const auto corner = star.corners.front();
        const std::uint32_t other = run.complex.face(corner)[0];
        (void)edge_split(run.complex, work, {tet_of(corner), v, other},
                         midpoint(run.complex.at(v), run.complex.at(other)));
        v += 100;
    }
    EXPECT_EQ(run.step(1).unreached, 0U);
    EXPECT_TRUE(validate(run.complex).ok());
}

TEST(Parallel3, RefusesWrongArguments) {
    Complex complex = initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.2), 1}}, {.edge_length = 0.1});
    for (const Parallel& bad : {Parallel{.threads = 0}, Parallel{.threads = 1025},
                                Parallel{.submeshes = 3}, Parallel{.submeshes = 128}}) {
        EXPECT_THROW(Simulation(complex, {.edge_length = 0.1}, bad), InputError);
    }
    Simulation simulation(complex, {.edge_length = 0.1}, Parallel{});
    EXPECT_EQ(simulation.step(swirl, 0, 0).sub_steps, 0U);
}

} // namespace
} // namespace dsc3::test::parallel_test
