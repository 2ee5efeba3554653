// SPDX-License-Identifier: MIT
// Films that open at a contact distance of several edge lengths: as one event, at the right time,
// without holes; and what is thin but no film stays as it is.
#include "dsc/topology/change.h"

#include "support/random_scene.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/parallel.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/hash.h"
#include "dsc/queries/outlines.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc {
namespace {

constexpr double h = 0.02;
constexpr double pi = std::numbers::pi;

Options<double> wide(double contact, double edge_length = h) {
    Options<double> result;
    result.edge_length = edge_length;
    result.topology.rule = Topology::change;
    result.topology.contact = contact;
    return result;
}

// Two discs of radius 0.1, `gap` apart, the second of phase `second`.
Complex<double> two_discs(double gap, Phase second = 1, double edge_length = h) {
    const int n = static_cast<int>(std::ceil(0.2 * pi / edge_length));
    const std::vector<Shape> shapes{{test::circle_points({0.4 - gap / 2, 0.5}, 0.1, n), 1},
                                    {test::circle_points({0.6 + gap / 2, 0.5}, 0.1, n), second}};
    return initial_complex<double>({}, shapes, {.edge_length = edge_length});
}

// Each disc grows about its own centre at this speed.
Velocity<double> grow(double gap, double speed = 1) {
    return
        [=](std::span<const Point<double>> positions, double, std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const double away = positions[i].x() < 0.5 ? -1 : 1;
                const Point<double> centre(0.5 + away * (0.1 + gap / 2), 0.5);
                velocities[i] = speed * (positions[i] - centre).normalized();
            }
        };
}

using Events = std::vector<Event>;

Events run(Complex<double>& complex, Simulation<double>& simulation,
           const Velocity<double>& velocity, double dt, double duration) {
    Events events;
    for (double time = 0; time < duration; time += dt) {
        const StepReport report = simulation.step(velocity, time, dt);
        events.insert(events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(validate(complex).problem, "") << "at " << time;
    }
    return events;
}

std::size_t count(const Events& events, EventKind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

class WideContact : public testing::TestWithParam<Division> {};

TEST_P(WideContact, TwoDiscsMergeOnce) {
    constexpr double gap = 0.12;
    constexpr double dt = 0.3 * h;
    for (const double contact : {2 * h, 4 * h}) {
        std::uint64_t hash = 0;
        for (const std::uint32_t threads : {1U, 3U}) {
            auto complex = two_discs(gap);
            Simulation<double> simulation(
                complex, wide(contact),
                Parallel{.threads = threads, .division = GetParam(), .always_all_threads = true});
            const Events events = run(complex, simulation, grow(gap), dt, 0.07);
            ASSERT_EQ(count(events, EventKind::merge), 1U);
            EXPECT_EQ(count(events, EventKind::widen) + 1, events.size());
            const Event& merge = events.front();
            EXPECT_EQ(merge.kind, EventKind::merge);
            EXPECT_NEAR(merge.time, (gap - contact) / 2, dt);
            EXPECT_NEAR(merge.x, 0.5, h);
            EXPECT_NEAR(merge.y, 0.5, h);
            EXPECT_EQ(merge.lost, exterior_phase);
            EXPECT_EQ(outlines(complex, 1).size(), 1U) << "a hole";
            hash = hash == 0 ? mesh_hash(complex) : hash;
            EXPECT_EQ(mesh_hash(complex), hash) << "the number of threads makes a difference";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Topology, WideContact,
                         testing::Values(Division::fixed, Division::counting, Division::active,
                                         Division::blocks, Division::cells, Division::copy),
                         [](const auto& one) {
                             return std::string(
                                 divisions().at(static_cast<std::size_t>(one.param)).name);
                         });

} // namespace
} // namespace dsc
