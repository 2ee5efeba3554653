// SPDX-License-Identifier: MIT
// Films between the interface and the domain boundary open like films between two sheets; thin
// regions of other kinds stay.
#include "support/topology/growing_discs.h"

#include "dsc/queries/phases.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"

#include <array>
#include <cmath>
#include <numbers>

namespace dsc::boundary_films_test {
namespace {

using namespace test::growing_discs;

using P = Point<double>;

constexpr double radius = 0.2;
constexpr int steps = 60;

// A disc that approaches the domain boundary, or two sides of it.
struct Approach {
    P centre;
    P way;       ///< displacement of the disc
    double rise; ///< growth of the radius
    std::size_t sides;
};
const Approach falls{{0.5, 0.4}, {0, -0.3}, 0, 1};
const Approach grows{{0.5, 0.3}, {0, 0}, 0.16, 1};
const Approach grows_to_corner{{0.28, 0.3}, {0, 0}, 0.16, 2};

struct Wetted {
    Complex<double> complex;
    std::vector<Event> events;
    std::uint64_t unreached = 0;
};

Wetted run(const Approach& approach, const test::ChangingOptions<double>& options) {
    const double length = options.edge_length;
    const int vertices = static_cast<int>(3 * std::numbers::pi * radius / length);
    const std::vector<Shape> shapes{{test::circle_points(approach.centre, radius, vertices), 1}};
    Wetted result{initial_complex<double>({}, shapes, {.edge_length = length}), {}};
    test::ChangingSimulation<double> simulation(result.complex, options);
    const auto velocity = test::pointwise([&](const P& p) {
        const P outwards = (p - approach.centre).normalized();
        return approach.rise > 0 ? P(approach.way + approach.rise * outwards) : approach.way;
    });
    for (int step = 0; step < steps; ++step) {
        const test::ChangingReport report = simulation.step(velocity, step / 60.0, 1 / 60.0);
        result.events.insert(result.events.end(), report.events.begin(), report.events.end());
        result.unreached += report.unreached;
        EXPECT_EQ(validate(result.complex).problem, "");
    }
    return result;
}

void expect_clipped(const Wetted& run, const Approach& approach, double edge_length) {
    EXPECT_EQ(run.unreached, 0U);
    EXPECT_EQ(count(run.events, EventKind::meet), approach.sides);
    EXPECT_EQ(count(run.events, EventKind::fill) + count(run.events, EventKind::split), 0U);
    // If the disc reaches two sides, it cuts off a corner of the exterior.
    std::array<std::size_t, 2> pieces{};
    for (const auto& component : components(run.complex).list) {
        ++pieces.at(component.phase);
    }
    EXPECT_EQ(pieces, (std::array<std::size_t, 2>{approach.sides, 1}));
    // No thin region is left along the sides of the domain.
    for (const Vertex v : vertices(run.complex)) {
        const P p = run.complex.position(v);
        EXPECT_FALSE(std::min(p.x(), p.y()) > 0 && std::min(p.x(), p.y()) < 1e-3 * edge_length);
    }
    // The part of the disc that is inside the domain.
    const auto found = scenes::interface_outlines(run.complex, {.phase = 1});
    const std::vector<scenes::Outline> disc{
        test::circle_points(approach.centre + approach.way, radius + approach.rise, 4000)};
    const std::vector<scenes::Outline> domain{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const scenes::OverlapAreas there = scenes::overlap_areas({found}, {disc});
    const double missing = scenes::overlap_areas({disc}, {domain}).both - there.both;
    EXPECT_LT(there.only_first + missing, 0.25 * edge_length * edge_length);
}

TEST(BoundaryFilms, ADiscWetsTheBoundaryThatItComesTo) {
    for (const double length : {0.04, 0.02, 0.01}) {
        for (const auto& approach : {falls, grows, grows_to_corner}) {
            SCOPED_TRACE(testing::Message() << length << ", " << approach.centre.transpose());
            expect_clipped(run(approach, wide(0, length)), approach, length);
        }
    }
}

TEST(BoundaryFilms, OpenAtAContactOfSeveralEdges) {
    for (const auto& approach : {falls, grows}) {
        const Wetted result = run(approach, wide(3 * h));
        expect_clipped(result, approach, h);
        ASSERT_FALSE(result.events.empty());
        // The disc touches the boundary at two thirds and at five eighths of the time; the event is
        // earlier by the contact distance over the speed.
        const bool is_fall = approach.rise == 0;
        const double expected = is_fall ? (0.2 - 3 * h) / 0.3 : (0.1 - 3 * h) / 0.16;
        EXPECT_NEAR(result.events.front().time, expected, 0.1);
    }
}

TEST(BoundaryFilms, StayWhereTheApplicationSaysNo) {
    auto asked = wide(0);
    int times = 0;
    asked.topology.may_change = [&](const Contact& contact) {
        ++times;
        EXPECT_EQ(contact.film, exterior_phase);
        EXPECT_EQ(contact.sides, (std::array<Phase, 2>{1, border_phase}));
        EXPECT_LE(contact.thickness, default_contact * h);
        return false;
    };
    EXPECT_TRUE(run(falls, asked).events.empty());
    EXPECT_GT(times, 0);
    auto kept = wide(0);
    kept.topology.pairs = {{.one = 0, .other = 1, .rule = Topology::keep}};
    EXPECT_TRUE(run(falls, kept).events.empty());
}

// A cap on the domain boundary that is pressed against it spreads, unless the application refuses.
TEST(BoundaryFilms, NoVertexWetsTheBoundaryWhereTheApplicationSaysNo) {
    for (const bool refuses : {false, true}) {
        std::vector<P> arc;
        for (int i = 0; i <= 30; ++i) {
            const double angle = std::numbers::pi * (-0.1 + 1.2 * i / 30);
            arc.emplace_back(0.5 + 0.2 * std::cos(angle),
                             i % 30 == 0 ? 0.0 : 0.062 + 0.2 * std::sin(angle));
        }
        const std::vector<Curve> curves{{arc, 1, 0}};
        auto complex = initial_complex<double>({}, curves, {.edge_length = h});
        test::ChangingOptions<double> options = wide(0);
        int times = 0;
        options.topology.may_change = [&](const Contact& contact) {
            ++times;
            EXPECT_EQ(contact.film, exterior_phase);
            EXPECT_EQ(contact.sides, (std::array<Phase, 2>{1, border_phase}));
            return !refuses;
        };
        test::ChangingSimulation<double> simulation(complex, options);
        const std::vector<Event> events =
            run_on(complex, simulation, test::constant(0, -0.3), 1 / 60.0, 20);
        EXPECT_GT(times, 0);
        EXPECT_EQ(count(events, EventKind::widen) == 0, refuses);
    }
}

// --- thin regions that are not squeezed films -------------------------------------------------

// Checks that no film opens between the domain boundary and a curve with phase 1 below it, which
// stays or slides along the boundary.
void expect_left_alone(const std::vector<P>& curve, double speed, double contact) {
    const std::vector<Curve> curves{{curve, 0, 1}};
    auto complex = initial_complex<double>({}, curves, {.edge_length = h});
    const double before = phase_area(complex, 1);
    test::ChangingSimulation<double> simulation(complex, wide(contact));
    const auto slide = test::constant(speed, 0);
    std::uint64_t unreached = 0;
    for (int step = 0; step < 20; ++step) {
        const test::ChangingReport report = simulation.step(slide, 0, 0.4 * h);
        // The end of a curve close to a corner of the domain moves there.
        EXPECT_EQ(count(report.events, EventKind::t1), report.events.size());
        unreached += report.unreached;
    }
    EXPECT_EQ(unreached, 0U);
    EXPECT_NEAR(phase_area(complex, 1), before, 0.2 * h * h);
}

TEST(BoundaryFilms, ALayerOnTheBoundaryStays) {
    for (const double thickness : {0.1 * h, 0.3 * h, 3 * h}) {
        for (const double contact : {0.0, 2 * h}) {
            SCOPED_TRACE(testing::Message() << thickness / h << ", " << contact / h);
            expect_left_alone({{0, thickness}, {0.5, thickness}, {1, thickness}}, 0, contact);
        }
    }
}

TEST(BoundaryFilms, TheWedgeAtTheEndOfACurveStays) {
    for (const double degrees : {30.0, 20.0, 10.0}) {
        for (const double speed : {0.0, 1.0}) {
            SCOPED_TRACE(testing::Message() << degrees << ", " << speed);
            const double height = 0.3 * std::tan(degrees * std::numbers::pi / 180);
            expect_left_alone({{0.1, 0}, {0.4, height}, {0.7, 0}}, speed, 0);
        }
    }
}

} // namespace
} // namespace dsc::boundary_films_test
