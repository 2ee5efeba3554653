// SPDX-License-Identifier: MIT
// Attributes in three dimensions follow every edit, and runs resumed from checkpoints are bitwise
// identical.
#include "dsc/complex/numbering.h"
#include "dsc3/space_testing.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace dsc3::test::attributes_test {
namespace {

constexpr double h = 0.08;
const Point centre(0.35, 0.35, 0.35);

Complex ball_complex() { return initial_complex({}, {{ball(centre, 0.2), 1}}, {.edge_length = h}); }

std::string bytes_of(Complex& complex) {
    dsc::Archive archive;
    dsc3::archive(archive, complex);
    return archive.bytes();
}

std::string bytes_of(Simulation& simulation) {
    dsc::Archive archive;
    simulation.archive(archive);
    return archive.bytes();
}

TEST(Attributes3, FollowEveryEdit) {
    Complex complex = ball_complex();
    // `height` is advected by the flow; `phase` shows whether the value of a tet fits the tet's
    // phase.
    auto& height = complex.attributes.add<Vertex>("height", 0.0);
    auto& phase = complex.attributes.add<Tet>("phase", std::int32_t{-1});
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        height[Vertex{v}] = complex.at(v).z();
    }
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        phase[Tet{t}] = std::int32_t(complex.phase(Tet{t}));
    }
    Simulation simulation(complex, {.edge_length = h});
    OperationCounts done;
    const Velocity along = [](std::span<const Point> p, double t, std::span<Point> w) {
        swirl(p, t, w);
        for (Point& velocity : w) { // the height stays
            velocity.z() = 0;
        }
    };
    const unsigned steps = dsc::test::are_asked_for("few") ? 12 : 30;
    for (unsigned k = 0; k < steps; ++k) {
        done += simulation.step(along, 0.04 * k, 0.04).operations;
    }
    ASSERT_TRUE(validate(complex).ok());
    EXPECT_GT(done.interface_splits, 50U * steps / 30);
    EXPECT_GT(done.edge_removals + done.face_flips, 50U * steps / 30);
    EXPECT_GT(done.interface_collapses, 10U * steps / 30);
    ASSERT_EQ(height.size(), complex.vertex_bound());
    ASSERT_EQ(phase.size(), complex.tet_bound());
    renumber(complex);
    ASSERT_EQ(height.size(), complex.vertex_bound());
    double squares = 0;
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.is_interface(Vertex{v})) {
            squares += std::pow(height[Vertex{v}] - complex.at(v).z(), 2);
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.1 * h); // new vertices lie on curves, values on chords
    EXPECT_EQ(phase[Tet{border_tet}], -1);
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        ASSERT_EQ(phase[Tet{t}], std::int32_t(complex.phase(Tet{t}))) << "tet " << t;
    }
}

// By the rule itself, before anything is overwritten.
TEST(Attributes3, ANewTetInheritsFromTheNearestOneOfItsPhase) {
    Complex complex = ball_complex();
    auto& name = complex.attributes.add<Tet>("name", std::uint32_t{0});
    Workspace work;
    std::uint32_t edits = 0;
    std::uint32_t permuted = 0; // tets whose own value went to another one
    const std::uint32_t stride = dsc::test::are_asked_for("few") ? 4 : 1;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); v += stride) {
        for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
            name[Tet{t}] = t;
        }
        const Complex old = complex;
        work.rewiring.changed.clear();
        Star star;
        gather(complex, v, star);
        const Corner corner = star.corners[v % star.corners.size()];
        const std::uint32_t other = complex.face(corner)[v % 3];
        const EdgeAt edge{tet_of(corner), v, other};
        if (edge_removal(complex, work, edge, 0) != Verdict::legal &&
            edge_collapse(complex, work, Vertex{v}, Vertex{other}) != Verdict::legal) {
            (void)edge_split(complex, work, edge, midpoint(complex.at(v), complex.at(other)));
        }
        // Old tets are those whose ids or records have changed.
        std::vector<std::uint32_t> replaced;
        for (std::uint32_t t = 1; t < old.tet_bound(); ++t) {
            if (old.is_alive(Tet{t}) && complex.tets[t].v != old.tets[t].v) {
                replaced.push_back(t);
            }
        }
        const auto middle = [](const Complex& of, std::uint32_t t) {
            const auto p = of.positions_of(Tet{t});
            return Point((p[0] + p[1] + p[2] + p[3]) / 4);
        };
        for (const std::uint32_t t : work.rewiring.changed) {
            double least = 1;
            double of_heir = 1;
            for (const std::uint32_t o : replaced) {
                const double way = (middle(complex, t) - middle(old, o)).norm();
                if (old.phase(Tet{o}) == complex.phase(Tet{t})) {
                    least = std::min(least, way);
                    of_heir = name[Tet{t}] == o ? way : of_heir;
                }
            }
            ASSERT_LE(of_heir, least + 1e-12) << "tet " << t << " has that of " << name[Tet{t}];
            permuted += name[Tet{t}] != t && t < old.tet_bound() ? 1U : 0U;
        }
        edits += work.rewiring.changed.empty() ? 0U : 1U;
    }
    EXPECT_GT(edits, 200U);
    EXPECT_GT(permuted, 200U);
    EXPECT_EQ(name.size(), complex.tet_bound());
}

TEST(Attributes3, AreCopiedAndRefusedByName) {
    Complex complex = ball_complex();
    complex.attributes.add<Vertex>("heat", 20.0)[Vertex{3}] = 7;
    const Complex copy = complex;
    complex.attributes.get<Vertex, double>("heat")[Vertex{3}] = 8;
    EXPECT_EQ((copy.attributes.get<Vertex, double>("heat")[Vertex{3}]), 7);
    EXPECT_EQ((copy.attributes.get<Vertex, double>("heat")[Vertex{4}]), 20);
    EXPECT_THROW((void)(complex.attributes.get<Tet, double>("heat")), InputError);
    EXPECT_THROW(complex.attributes.add<Tet>("heat", 1), InputError);
    complex.attributes.get<Vertex, double>("heat").set_field(true);
    Simulation simulation(complex, {.edge_length = h});
    EXPECT_THROW(simulation.step(swirl, 0, 0.01), InputError);
}

TEST(Attributes3, WhatOneThrowsComesOutOfTheStep) {
    Complex complex = ball_complex();
    complex.attributes.add<Vertex>(
        "bad", 0.0, [](double, double, double) -> double { throw std::runtime_error("no blend"); });
    Simulation simulation(complex, {.edge_length = h});
    const auto steps = [&] {
        for (int k = 0; k < 20; ++k) {
            simulation.step(swirl, 0.04 * k, 0.04);
        }
    };
    EXPECT_THROW(steps(), std::runtime_error);
    EXPECT_TRUE(validate(complex).ok());
}

TEST(Simulation3, TellsHowFarAStepCameThatAVelocityEnded) {
    Complex complex = ball_complex();
    Simulation simulation(complex, {.edge_length = h});
    const Velocity velocity = [](auto positions, double time, auto velocities) {
        if (time > 0.5) {
            throw std::runtime_error("enough");
        }
        swirl(positions, time, velocities);
    };
    EXPECT_THROW(simulation.step(velocity, 0, 1), std::runtime_error);
    const StepReport& report = simulation.report();
    EXPECT_GT(report.sub_steps, 0U);
    EXPECT_GT(report.reached, 0);
    EXPECT_LE(report.reached, 0.5);
    // From there a step goes on.
    EXPECT_EQ(simulation.step(swirl, report.reached, 0.1).unreached, 0U);
    EXPECT_TRUE(validate(complex).ok());
}

TEST(Checkpoints3, GoOnToTheSameBits) {
    Complex one = ball_complex();
    one.attributes.add<Vertex>("number", 1.5);
    one.attributes.add<Vertex>("origin", Point(1, 2, 3));
    one.attributes.add<Tet>("tag", std::uint32_t{7});
    Simulation first(one, {.edge_length = h});
    for (int k = 0; k < 5; ++k) {
        first.step(swirl, 0.05 * k, 0.05);
    }
    dsc::Archive saved;
    first.archive(saved);

    Complex two = ball_complex();
    auto& number = two.attributes.add<Vertex>("number", 1.5);
    two.attributes.add<Vertex>("origin", Point(4, 5, 6));
    two.attributes.add<Tet>("tag", std::uint32_t{7});
    Simulation second(two, {.edge_length = h});
    second.step(swirl, 0, 0.1); // the archive replaces the whole state
    dsc::Archive again(saved.bytes(), "saved");
    second.archive(again);
    again.expect_end();
    EXPECT_EQ(number.size(), two.vertex_bound());
    std::size_t edits = 0;
    for (int k = 5; k < 10; ++k) {
        const StepReport a = first.step(swirl, 0.05 * k, 0.05);
        const StepReport b = second.step(swirl, 0.05 * k, 0.05);
        ASSERT_EQ(a.moves, b.moves);
        edits += a.operations.interface_splits + a.operations.edge_removals;
    }
    EXPECT_GT(edits, 20U); // on ids that were free
    EXPECT_EQ(bytes_of(one), bytes_of(two));
    EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(Checkpoints3, AreReadWholeOrNotAtAll) {
    Complex complex = initial_complex({}, {{ball(centre, 0.2), 1}}, {.edge_length = 0.2});
    Simulation simulation(complex, {.edge_length = 0.2});
    simulation.step(swirl, 0, 0.1);
    const std::string good = bytes_of(simulation);
    const auto refuse = [&](const std::string& bad) {
        dsc::Archive archive(bad, "bad");
        const auto read = [&] {
            simulation.archive(archive);
            archive.expect_end();
        };
        try {
            read();
            return false;
        } catch (const FileError&) {
            EXPECT_EQ(bytes_of(simulation), good);
            return true;
        }
    };
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_TRUE(refuse(good.substr(0, good.size() * i / 100))) << "cut at " << i << " %";
    }
    // Bytes with a changed bit are refused, or, if it is a bit of a coordinate, may hold another
    // valid complex.
    int refused = 0;
    for (std::size_t i = 0; i < 100; ++i) {
        std::string bad = good;
        bad[good.size() * i / 100] = static_cast<char>(bad[good.size() * i / 100] ^ 0x40);
        if (refuse(bad)) {
            ++refused;
        } else { // to read a complex takes as long as to validate it
            ASSERT_TRUE(validate(complex).ok());
            EXPECT_FALSE(refuse(good));
        }
    }
    EXPECT_GT(refused, 50);
    Complex other = complex;
    other.attributes.add<Vertex>("more", 1.0);
    dsc::Archive archive(bytes_of(complex), "other");
    EXPECT_THROW(dsc3::archive(archive, other), FileError);
}

} // namespace
} // namespace dsc3::test::attributes_test
