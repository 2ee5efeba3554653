// SPDX-License-Identifier: MIT
// Starts and steps in three dimensions, where the answers are known.
#include "dsc3/space_testing.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace dsc3::test::simulation_test {
namespace {

const Point centre(0.4, 0.4, 0.4);
constexpr double radius = 0.2;

Complex ball_complex(double h) {
    return initial_complex({}, {{ball(centre, radius), 1}}, {.edge_length = h});
}

Velocity uniform(const Point& v) {
    return [v](std::span<const Point> p, double, std::span<Point> w) {
        std::fill_n(w.begin(), p.size(), v);
    };
}

// The largest distance of an interface vertex from the sphere around c.
double farthest(const Complex& complex, const Simulation& simulation, const Point& c) {
    double most = 0;
    for (const std::uint32_t v : simulation.interface()) {
        most = std::max(most, std::abs((complex.at(v) - c).norm() - radius));
    }
    return most;
}

TEST(Initial3, ABallIsExactAtItsVertices) {
    double before = 1;
    for (const double h : {0.1, 0.05}) {
        Complex complex = ball_complex(h);
        const ValidationReport report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        ASSERT_EQ(report.surfaces.size(), 2U);
        EXPECT_EQ(report.surfaces[1].euler_characteristic, 2);
        EXPECT_GE(mesh_quality(complex).min_dihedral, 15);
        Simulation simulation(complex, {.edge_length = h});
        EXPECT_LT(farthest(complex, simulation, centre), 0.02 * h);
        // The error of the chords is of second order.
        const double exact = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
        const double missing = 1 - phase_volume(complex, 1) / exact;
        EXPECT_GT(missing, 0);
        EXPECT_LT(missing, 0.3 * before);
        before = missing;
    }
}

TEST(Initial3, ShapesWithinEachOtherAndApart) {
    const Complex complex = initial_complex({{0, 0, 0}, {2, 1, 1}},
                                            {{ball({0.5, 0.5, 0.5}, 0.35), 1},
                                             {ball({0.5, 0.5, 0.5}, 0.15), 2},
                                             {ball({1.5, 0.5, 0.5}, 0.2), 2}},
                                            {.edge_length = 0.06});
    const ValidationReport report = validate(complex);
    ASSERT_TRUE(report.ok()) << report.problem;
    ASSERT_EQ(report.surfaces.size(), 3U);
    EXPECT_EQ(report.surfaces[0].euler_characteristic, 6);
    EXPECT_EQ(report.surfaces[1].euler_characteristic, 4);
    EXPECT_EQ(report.surfaces[2].euler_characteristic, 4);
    const double volume = 4.0 / 3 * std::numbers::pi;
    EXPECT_NEAR(phase_volume(complex, 1), volume * (0.042875 - 0.003375), 2e-3);
    EXPECT_NEAR(phase_volume(complex, 2), volume * (0.003375 + 0.008), 2e-3);
}

TEST(Initial3, RefusesWhatItCannotBegin) {
    const auto make = [](std::initializer_list<Shape> shapes, double h) {
        return initial_complex({}, shapes, {.edge_length = h});
    };
    const Point middle(0.5, 0.5, 0.5);
    EXPECT_THROW(make({{ball(middle, 1e-4), 1}}, 0.1), InputError);
    EXPECT_THROW(make({{ball(middle, 0.3), 1}, {ball(middle, 0.29), 2}}, 0.1), InputError);
    EXPECT_THROW(make({{ball(middle, std::nan("")), 1}}, 0.1), InputError);
    EXPECT_THROW(make({{Distance(), 1}}, 0.1), InputError);
    EXPECT_THROW(make({{ball(middle, 0.2), border_phase}}, 0.1), InputError);
    EXPECT_THROW(make({}, 0), InputError);
    EXPECT_THROW(make({}, 0.5), InputError);
    EXPECT_THROW((void)initial_complex({{0, 0, 0}, {1, 0, 1}}, {}), InputError);
    EXPECT_NEAR(phase_volume(make({}, 0.25), 0), 1, 1e-14);
}

TEST(Motion3, IntegratorsHaveTheirOrder) {
    // A rotation that accelerates, about an axis that is not parallel to a coordinate axis.
    const Point axis = Point(1, 2, 2) / 3.0;
    const Velocity velocity = [&](std::span<const Point> p, double t, std::span<Point> w) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            w[i] = 2 * t * axis.cross(p[i]);
        }
    };
    const std::vector<Point> start{{1, 0, 0}, {0, 1, -1}};
    const auto error = [&](Integrator integrator, int steps) {
        std::vector<Point> p = start;
        std::vector<Point> q(p.size());
        IntegratorScratch scratch;
        for (int k = 0; k < steps; ++k) {
            scratch.first.resize(p.size());
            const double t = double(k) / steps;
            velocity(p, t, scratch.first);
            integrate(integrator, velocity, p, t, 1.0 / steps, q, scratch);
            p.swap(q);
        }
        double most = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            most = std::max(most, (p[i] - Eigen::AngleAxisd(1, axis) * start[i]).norm());
        }
        return most;
    };
    const auto order = [&](Integrator integrator) {
        return std::log2(error(integrator, 32) / error(integrator, 64));
    };
    EXPECT_NEAR(order(Integrator::euler), 1, 0.2);
    EXPECT_NEAR(order(Integrator::midpoint), 2, 0.2);
    EXPECT_NEAR(order(Integrator::rk4), 4, 0.2);
    EXPECT_EQ(error(Integrator::adaptive, 32), error(Integrator::rk4, 32));
}

// For p' = p both methods are polynomials of the step z; they differ by z^4/72 - z^5/144.
TEST(Motion3, TheAdaptiveErrorIsTheDifferenceOfTwoMethods) {
    const Velocity velocity = [](std::span<const Point> p, double, std::span<Point> w) {
        std::copy(p.begin(), p.end(), w.begin());
    };
    const std::vector<Point> start{{0.5, 0, 0}, {0, 0, 2}, {1, 0, 0}};
    std::vector<Point> targets(start.size());
    IntegratorScratch scratch;
    scratch.first = start;
    const double z = 0.5;
    EXPECT_NEAR(integrate(Integrator::adaptive, velocity, start, 0, z, targets, scratch),
                2 * (std::pow(z, 4) / 72 - std::pow(z, 5) / 144), 1e-15);
}

TEST(Motion3, CurvedInsertionLiesOnTheSphere) {
    const Complex complex = ball_complex(0.1);
    Workspace work;
    double straight = 0;
    double curved = 0;
    for (const InterfaceFace& face : interface_faces(complex)) {
        const Point chord = midpoint(complex.at(face.v[0]), complex.at(face.v[1]));
        const Point place = curved_middle(complex, work, face.v[0], face.v[1]);
        straight = std::max(straight, std::abs((chord - centre).norm() - radius));
        curved = std::max(curved, std::abs((place - centre).norm() - radius));
    }
    EXPECT_GT(straight, 5e-3);
    EXPECT_LT(curved, 1e-12) << "exact";
}

// The curvature of this spheroid changes by a factor of 12 within a few edges of its rim.
TEST(Motion3, CurvedInsertionDoesNotOvershootWhereTheCurvatureChanges) {
    constexpr double h = 0.04;
    const Point half(0.35, 0.35, 0.1);
    const Complex complex =
        initial_complex({}, {{ellipsoid({0.5, 0.5, 0.5}, half), 1}}, {.edge_length = h});
    const auto off = [&](const Point& p) { // its distance, to second order
        const Point q = (p - Point(0.5, 0.5, 0.5)).array() / half.array();
        return (q.norm() - 1) * q.norm() / (q.array() / half.array()).matrix().norm();
    };
    Workspace work;
    double outwards = 0;
    for (const InterfaceFace& face : interface_faces(complex)) {
        const Point place = curved_middle(complex, work, face.v[0], face.v[1]);
        outwards = std::max(outwards, off(place));
    }
    EXPECT_LT(outwards, 0.007 * h) << "a third of what the arithmetic mean of the rises gives";
}

TEST(Simulation3, ATranslationIsExact) {
    constexpr double h = 0.05;
    Complex complex = ball_complex(h);
    const double volume = phase_volume(complex, 1);
    Simulation simulation(complex, {.edge_length = h});
    const Velocity velocity = uniform({0.2, 0.15, 0.1});
    std::uint64_t unreached = 0;
    double angle = 180;
    const int steps = dsc::test::are_asked_for("few") ? 4 : 20;
    for (int k = 0; k < steps; ++k) {
        const StepReport report = simulation.step(velocity, 0.05 * k, 0.05);
        unreached += report.unreached;
        EXPECT_EQ(report.gave_up, GiveUp::none);
        EXPECT_NEAR(report.reached, 0.05 * (k + 1), 1e-15);
        const ValidationReport valid = validate(complex);
        ASSERT_TRUE(valid.ok()) << valid.problem;
        angle = std::min(angle, mesh_quality(complex).min_dihedral);
    }
    EXPECT_EQ(unreached, 0U);
    EXPECT_GE(angle, 7);
    EXPECT_LT(farthest(complex, simulation, centre + 0.05 * steps * Point(0.2, 0.15, 0.1)), 1e-13);
    EXPECT_NEAR(phase_volume(complex, 1) / volume, 1, 1e-3);
}

TEST(Simulation3, AVertexWithoutRoomForItsInsertionArrivesLater) {
    Complex complex = ball_complex(0.1);
    Options options{.edge_length = 0.06};
    std::vector<Point> places; // farther off the interface than some tets allow
    options.insertion = [&](const Complex& mesh, Workspace& work, std::uint32_t a,
                            std::uint32_t b) {
        const Point middle = curved_middle(mesh, work, a, b);
        const double off = (places.size() % 2 == 0 ? 0.1 : -0.1) * (mesh.at(a) - mesh.at(b)).norm();
        places.push_back(middle + off * (middle - centre).normalized());
        return places.back();
    };
    Simulation simulation(complex, options);
    EXPECT_EQ(simulation.step(uniform({0, 0, 0}), 0, 1).unreached, 0U);
    ASSERT_GT(places.size(), 50U);
    for (const Point& place : places) {
        EXPECT_TRUE(std::any_of(simulation.interface().begin(), simulation.interface().end(),
                                [&](std::uint32_t v) { return complex.at(v) == place; }));
    }
    EXPECT_TRUE(validate(complex).ok());
}

// Edges beside late vertices are long, and are split: the new vertices are late, too.
TEST(Simulation3, AVertexThatDoesNotArriveArrivesInALaterStep) {
    std::uint64_t splits = 0;
    for (const auto& [way, passes] : {std::pair(0.085, 3), std::pair(0.085, 4), std::pair(0.095, 3),
                                      std::pair(0.095, 4), std::pair(0.1, 3), std::pair(0.1, 4)}) {
        Complex complex = ball_complex(0.1);
        const Options options{.edge_length = 0.1, .sub_step = 1, .max_passes = passes};
        Simulation simulation(complex, options);
        std::uint64_t unreached = simulation.step(uniform({0, way, 0}), 0, 1).unreached;
        EXPECT_GT(unreached, 0U);
        for (int step = 0; step < 20 && unreached > 0; ++step) {
            const StepReport report = simulation.step(uniform({0, 0, 0}), 0, 1);
            unreached = report.unreached;
            splits += report.operations.interface_splits;
        }
        EXPECT_EQ(unreached, 0U);
        EXPECT_LT(farthest(complex, simulation, centre + Point(0, way, 0)), 1e-12);
        EXPECT_TRUE(validate(complex).ok());
    }
    EXPECT_GT(splits, 50U);
}

TEST(Simulation3, LateVerticesArriveThoughTetsAreRenumbered) {
    const Box domain{.low = {0.15, 0.15, 0.15}, .high = {0.65, 0.75, 0.65}};
    Complex complex = initial_complex(domain, {{ball(centre, radius), 1}}, {.edge_length = 0.1});
    auto& number = complex.attributes.add<Tet>("number", no_id);
    const Options options{.edge_length = 0.1, .sub_step = 1, .max_passes = 4};
    Simulation simulation(complex, options);
    std::uint64_t unreached = simulation.step(uniform({0, 0.1, 0}), 0, 1).unreached;
    int renumbered = 0;
    for (int step = 0; step < 10; ++step) { // to and fro, for many operations
        const bool has_late = unreached > 0;
        number_tets(complex, number);
        unreached = simulation.step(uniform({0, step % 2 == 0 ? 0.03 : -0.03, 0}), 0, 1).unreached;
        renumbered += has_late && are_renumbered(complex, number) ? 1 : 0;
    }
    EXPECT_GT(renumbered, 0);
    EXPECT_EQ(unreached, 0U);
    EXPECT_LT(farthest(complex, simulation, centre + Point(0, 0.1, 0)), 1e-12);
    EXPECT_TRUE(validate(complex).ok());
}

TEST(Simulation3, TheSameInputGivesTheSameBits) {
    std::array<std::uint64_t, 2> hashes{};
    for (std::uint64_t& hash : hashes) {
        Complex complex = ball_complex(0.08);
        Simulation simulation(complex, {.edge_length = 0.08});
        for (int k = 0; k < 4; ++k) {
            simulation.step(uniform({0.5, 0, 0}), 0, 0.1);
        }
        hash = mesh_hash(complex);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Simulation3, ABallGrowsAndItsEdgesAreSplit) {
    constexpr double h = 0.05;
    Complex complex = initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.15), 1}}, {.edge_length = h});
    Simulation simulation(complex, {.edge_length = h});
    const std::size_t before = simulation.interface().size();
    const Velocity growth = [](std::span<const Point> p, double, std::span<Point> w) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            w[i] = 0.1 * (p[i] - Point(0.5, 0.5, 0.5)).normalized();
        }
    };
    OperationCounts counts;
    for (int k = 0; k < 10; ++k) {
        const StepReport report = simulation.step(growth, 0, 0.1);
        EXPECT_EQ(report.unreached, 0U);
        counts.interface_splits += report.operations.interface_splits;
        ASSERT_TRUE(validate(complex).ok()) << validate(complex).problem;
    }
    EXPECT_GT(counts.interface_splits, 50U);
    EXPECT_EQ(simulation.interface().size(), before + counts.interface_splits);
    double most = 0;
    for (const std::uint32_t v : simulation.interface()) {
        most = std::max(most, std::abs((complex.at(v) - Point(0.5, 0.5, 0.5)).norm() - 0.25));
    }
    EXPECT_LT(most, 0.02 * h);
}

TEST(Simulation3, SubStepsAreShortWhereTheFlowSpeedsUp) {
    constexpr double h = 0.08;
    const Velocity from_rest = [](std::span<const Point> p, double time, std::span<Point> w) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            w[i] = {20 * time, 0, 0};
        }
    };
    Complex complex = ball_complex(h);
    Simulation simulation(complex, {.edge_length = h});
    EXPECT_GE(simulation.step(from_rest, 0, 0.1).sub_steps, 3U) << "0.1 / (0.4 * 1.25 h)";
    const Velocity turning = [](std::span<const Point> p, double, std::span<Point> w) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            w[i] = 5 * Point(centre.y() - p[i].y(), p[i].x() - centre.x(), 0);
        }
    };
    const Options options{.edge_length = h, .integrator = Integrator::adaptive, .tolerance = 1e-7};
    Complex other = ball_complex(h);
    const StepReport report = Simulation(other, options).step(turning, 0, 0.05);
    EXPECT_GT(report.error, 0);
    EXPECT_LE(report.error, options.tolerance * h);
    EXPECT_GE(report.sub_steps, 4U);
}

class Held3 : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Integrators, Held3,
                         testing::Values(Integrator::euler, Integrator::midpoint, Integrator::rk4));

TEST_P(Held3, ANonFiniteVelocityHoldsItsVertex) {
    Complex complex = ball_complex(0.08);
    Simulation simulation(complex, {.edge_length = 0.08, .integrator = GetParam()});
    const std::uint32_t held = simulation.interface().front();
    const Point place = complex.at(held);
    const Velocity velocity = [&](std::span<const Point> p, double, std::span<Point> w) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            w[i] = {0.01, 0, p[i] == place ? std::numeric_limits<double>::quiet_NaN() : 0};
        }
    };
    const StepReport report = simulation.step(velocity, 0, 0.1);
    EXPECT_EQ(report.held, 1U);
    EXPECT_EQ(report.unreached, 1U);
    EXPECT_EQ(complex.at(held), place);
    EXPECT_TRUE(validate(complex).ok());
}

TEST(Simulation3, EditsBetweenStepsAreTakenAccountOf) {
    Complex complex = ball_complex(0.08);
    Simulation simulation(complex, {.edge_length = 0.08});
    simulation.step(uniform({0.1, 0, 0}), 0, 0.1);
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(Tet{t}) && complex.phase(Tet{t}) == 1) {
            complex.set_phase(Tet{t}, 0);
        }
    }
    EXPECT_EQ(simulation.step(uniform({0.1, 0, 0}), 0.1, 0.1).interface_vertices, 0U);
    EXPECT_TRUE(validate(complex).ok());
    std::uint32_t inside = 1; // a new interface
    while (!complex.is_alive(Tet{inside}) ||
           std::any_of(complex.tets[inside].v.begin(), complex.tets[inside].v.end(),
                       [&](std::uint32_t v) { return complex.is_boundary(Vertex{v}); })) {
        ++inside;
    }
    complex.set_phase(Tet{inside}, 1);
    EXPECT_GE(simulation.step(uniform({0, 0, 0}), 0.2, 0.1).moves, 4U);
}

TEST(Simulation3, RefusesWrongArguments) {
    Complex complex = ball_complex(0.1);
    EXPECT_THROW(Simulation(complex, {}), InputError);
    EXPECT_THROW(Simulation(complex, {.edge_length = 0.1, .quality = 0.9}), InputError);
    EXPECT_THROW(Simulation(complex, {.edge_length = 0.1, .layers = -1}), InputError);
    Simulation simulation(complex, {.edge_length = 0.1});
    EXPECT_THROW(Simulation(complex, {.edge_length = 0.1}), InputError);
    EXPECT_THROW(simulation.step(uniform({0, 0, 0}), 0, -1), InputError);
    EXPECT_THROW(simulation.step(uniform({0, 0, 0}), std::nan(""), 1), InputError);
    EXPECT_EQ(simulation.step(uniform({0, 0, 0}), 0, 0).sub_steps, 0U);
    EXPECT_EQ(simulation.step(uniform({1e9, 0, 0}), 0, 1).gave_up, GiveUp::too_many_sub_steps);
}

} // namespace
} // namespace dsc3::test::simulation_test
