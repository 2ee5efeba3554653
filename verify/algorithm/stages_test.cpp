// SPDX-License-Identifier: MIT
// Stages: to which simulation they belong, when they run again, and the targets of what they edit.
#include "support/courses.h"

#include "dsc/algorithm/stage.h"
#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/motion/time_ahead.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>

namespace dsc::stages_test {
namespace {

using test::disc;
using test::disc_h;

class Idle final : public Stage<double> {
public:
    void run(const Between<double>& /*between*/) override {}
};

TEST(Stages, BelongToOneSimulationAtATime) {
    Complex<double> one = disc();
    Complex<double> other = disc();
    const Options<double> options{.edge_length = disc_h};
    const auto stage = std::make_shared<Idle>();
    auto first = std::make_unique<Simulation<double>>(one, options);
    Simulation<double> second(other, options);
    first->add_stage(stage);
    EXPECT_THROW(first->add_stage(stage), InputError);
    EXPECT_THROW(second.add_stage(stage), InputError);
    first.reset();
    EXPECT_NO_THROW(second.add_stage(stage));
}

// Edits the complex once a sub-step, and counts the calls.
class Editing final : public Stage<double> {
public:
    explicit Editing(std::function<void(const Between<double>&)> edit) : edit_(std::move(edit)) {}
    void run(const Between<double>& between) override { edit_(between); }
    void run_again(const Between<double>& between) override {
        ++again;
        EXPECT_EQ(between.unreached, 1U);
    }
    int again = 0;

private:
    std::function<void(const Between<double>&)> edit_;
};

// A vertex of a small disc is sent through its other side, where it is blocked, while the rest
// stays.
void send_through(const std::shared_ptr<Editing>& stage, std::uint64_t unreached) {
    Complex<double> complex = test::disc_complex<double>(disc_h, {0.5, 0.7}, 0.7 * disc_h);
    Simulation<double> simulation(
        complex, {.edge_length = disc_h, .integrator = Integrator::euler, .sub_step = 2});
    simulation.add_stage(stage);
    const Point<double> sent = complex.position(Vertex{simulation.interface()[0]});
    const Point<double> way = 2.5 * (Point<double>(0.5, 0.7) - sent);
    const Velocity<double> send = [&](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = positions[i] == sent ? way : Point<double>(0, 0);
        }
    };
    EXPECT_EQ(simulation.step(send, 0, 1).unreached, unreached);
    test::expect_sound(complex, simulation);
}

TEST(Stages, RunAgainIfAVertexIsStillBlockedAfterTheirEdits) {
    const auto stage = std::make_shared<Editing>([](const Between<double>& between) {
        const Corner inside =
            find_corner(between.complex, Vertex{between.interface[0]},
                        [&](Corner c) { return !is_border(between.complex.twin(c)); });
        EXPECT_EQ(edge_split(between.complex, between.complex.edge(inside)).verdict,
                  Verdict::legal);
    });
    send_through(stage, 1);
    EXPECT_EQ(stage->again, 1) << "once, because it changes nothing then";
}

// A vertex that a stage moves is where it belongs: its target was found for another place.
TEST(Stages, TakeTheTargetFromAVertexThatTheyMove) {
    const auto stage = std::make_shared<Editing>([](const Between<double>& between) {
        Complex<double>& complex = between.complex;
        for (const std::uint32_t v : between.interface) {
            if ((complex.vertices[v].flags & vertex_missed) != 0) {
                const Point<double> place = complex.position(Vertex{v}) + Point<double>(1e-9, 0);
                rewire::move(complex, complex.journal, v, place.x(), place.y(),
                             MoveReason::smoothing);
            }
        }
    });
    send_through(stage, 0);
    EXPECT_EQ(stage->again, 0);
}

// A vertex that is no longer on the border of a phase has a target that was for such a border.
TEST(Stages, TakeTheTargetFromAVertexThatTheyTakeOffAPhase) {
    const auto stage = std::make_shared<Editing>([](const Between<double>& between) {
        Complex<double>& complex = between.complex;
        for (const std::uint32_t v : between.interface) {
            for_each_corner(complex, Vertex{v}, [&](Corner c) {
                if ((complex.vertices[v].flags & vertex_missed) != 0 && complex.phase_at(c) == 0) {
                    rewire::relabel(complex, complex.journal, Triangle{triangle_of(c)}, 2);
                }
            });
        }
    });
    send_through(stage, 0);
    EXPECT_EQ(stage->again, 0);
}

// A vertex that a stage puts where it will be later waits for the time to come; one that is late
// makes up for it.
TEST(Stages, MayPutAVertexAheadOfTheTime) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h, .sub_step = 1});
    const std::vector<std::uint32_t> interface = simulation.interface();
    const std::array vertices{Vertex{interface[0]}, Vertex{interface[5]}, Vertex{interface[10]}};
    const double dt = 0.4 * disc_h;
    bool is_first = true;
    simulation.add_stage(std::make_shared<Editing>([&](const Between<double>& between) {
        if (std::exchange(is_first, false)) {
            times_ahead_of(between.complex)[vertices[0]].time = 1.75 * dt;
            times_ahead_of(between.complex)[vertices[1]].time = -0.5 * dt;
        }
    }));
    const Velocity<double> right = [](auto positions, double, auto velocities) {
        std::ranges::fill(velocities.subspan(0, positions.size()), Point<double>(1, 0));
    };
    const std::array<std::array<double, 3>, 4> ways{
        {{1, 1, 1}, {0, 1.5, 1}, {0.25, 1, 1}, {1, 1, 1}}}; // of dt, in each step
    for (std::size_t step = 0; step < ways.size(); ++step) {
        std::array<Point<double>, 3> before;
        std::ranges::transform(vertices, before.begin(),
                               [&](Vertex v) { return complex.position(v); });
        EXPECT_EQ(simulation.step(right, static_cast<double>(step) * dt, dt).unreached, 0U);
        for (std::size_t i = 0; i < 3; ++i) {
            const Point<double> way = complex.position(vertices[i]) - before[i];
            EXPECT_NEAR(way.x(), ways[step][i] * dt, 1e-15) << step << ", " << i;
            EXPECT_EQ(way.y(), 0) << step << ", " << i;
        }
    }
}

// A flow sees a vertex that is ahead where it is now: the normals beside it do not lean.
TEST(Stages, AVertexAheadOfTheTimeDoesNotHoldItsNeighboursUp) {
    Complex<double> complex = disc();
    Simulation<double> simulation(complex, {.edge_length = disc_h, .sub_step = 1});
    const Point<double> centre(0.5, 0.7);
    const auto radius_of = [&](Vertex v) { return (complex.position(v) - centre).norm(); };
    const Vertex ahead{simulation.interface()[0]};
    const double dt = 0.4 * disc_h;
    const double before = radius_of(ahead);
    bool is_first = true;
    simulation.add_stage(std::make_shared<Editing>([&](const Between<double>& between) {
        if (std::exchange(is_first, false)) {
            const double time = 0.75 * dt;
            const Point<double> to =
                centre + (1 + time / radius_of(ahead)) * (complex.position(ahead) - centre);
            rewire::move(complex, complex.journal, ahead.id, to.x(), to.y(), MoveReason::flow);
            times_ahead_of(between.complex)[ahead].time = time;
        }
    }));
    const InterfaceFlow<double> grow = [](const InterfaceView<double>& view, std::size_t begin,
                                          std::size_t end, double, auto velocities) {
        for (std::size_t i = begin; i < end; ++i) {
            velocities[i] = normal(view, i);
        }
    };
    for (int step = 0; step < 2; ++step) {
        EXPECT_EQ(simulation.step(grow, step * dt, dt).unreached, 0U);
    }
    for (const std::uint32_t v : simulation.interface()) {
        EXPECT_NEAR(radius_of(Vertex{v}), before + 2 * dt, 1e-3 * disc_h) << v;
    }
}

} // namespace
} // namespace dsc::stages_test
