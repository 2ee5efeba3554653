// SPDX-License-Identifier: MIT
// Interfaces that end on the sides of the domain, and slide there: parts of balls around a point of
// a side, of an edge, and of a corner; foams.
#include "dsc3/space_testing.h"
#include "support/environment.h"
#include "support/random/complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc3::test::sides_test {
namespace {

constexpr double radius = 0.2;
const bool is_quick = dsc::test::are_asked_for("few");

// A ball; with two phases, divided by a plane through its centre that is tilted away from the
// lattice.
struct Ball {
    Point centre;
    int phases = 1;

    [[nodiscard]] Distance plane() const {
        const Point normal = Point(0.9, 0.3, 0.2).normalized();
        return [normal, c = centre](const Point& p) { return (p - c).dot(normal); };
    }
    [[nodiscard]] Complex complex(double h) const {
        const std::vector<Shape> shapes{{ball(centre, radius), 1}, {plane(), 1, {{1, 2}}}};
        return initial_complex({}, std::span(shapes).first(std::size_t(phases)),
                               {.edge_length = h});
    }
    // The largest distance, of vertices on sides, from the sphere or from the plane.
    [[nodiscard]] double off_on_sides(const Complex& complex, const Point& moved) const {
        double most = 0;
        for_each_interface_star(complex, [&](std::uint32_t v, const InterfaceStar&, Stratum s) {
            if (complex.is_boundary(Vertex{v})) {
                const Point p = complex.at(v) - moved;
                const double of_sphere = std::abs((p - centre).norm() - radius);
                const double of_plane = phases == 1 ? 1 : std::abs(plane()(p));
                EXPECT_NE(s, Stratum::sheet);
                most = std::max(most, std::min(of_sphere, of_plane));
            }
        });
        return most;
    }
};

const Ball half{{0.3, 0.36, 0}};
const Ball half_above{{0.3, 0.36, 1}};
const Ball quarter{{0, 0.25, 0}};

TEST(Sides3, ShapesEndOnThemExactly) {
    struct Case {
        Ball ball;
        double share;         // of the whole ball
        std::uint32_t points; // where the end crosses an edge of the domain, or two ends meet
    };
    for (const auto& [ball, share, points] :
         {Case{half, 0.5, 0}, Case{half_above, 0.5, 0}, Case{quarter, 0.25, 2},
          Case{{{1, 1, 1}}, 0.125, 3}, Case{{half.centre, 2}, 0.5, 2},
          Case{{quarter.centre, 2}, 0.25, 5}}) {
        const Complex complex = ball.complex(1.0 / 20);
        const ValidationReport report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        const double whole = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
        const double volume = phase_volume(complex, 1) + phase_volume(complex, 2);
        EXPECT_NEAR(volume / (share * whole), 1, 0.04);
        EXPECT_EQ(count_strata(complex).point, points);
        EXPECT_LT(ball.off_on_sides(complex, Point::Zero()), 1e-12);
        EXPECT_GT(mesh_quality(complex).min_dihedral, 3);
    }
}

TEST(Sides3, PartsOfBallsSlideAlongThemExactly) {
    const double h = is_quick ? 1.0 / 12 : 1.0 / 24;
    struct Case {
        Ball ball;
        Point velocity; // the first component across a side does nothing
    };
    for (const Case& one : {Case{half, {0.4, 0.3, -1}}, Case{{half_above.centre, 2}, {0.4, 0.3, 1}},
                            Case{quarter, {-1, 0.5, 1}}, Case{{quarter.centre, 2}, {0, 0.5, 0}}}) {
        const Ball& ball = one.ball;
        const Point& velocity = one.velocity;
        Complex complex = ball.complex(h);
        const std::uint32_t points = count_strata(complex).point;
        Point along = velocity;
        along[2] = 0;
        along[0] = ball.centre.x() == 0 ? 0 : along[0];
        Simulation simulation(complex, {.edge_length = h});
        const int steps = is_quick ? 2 : 30;
        std::uint64_t unreached = 0;
        for (int k = 0; k < steps; ++k) {
            // Vertices inside move along the sides, too: the ball keeps its shape.
            unreached += simulation
                             .step(
                                 [&](std::span<const Point> p, double, std::span<Point> v) {
                                     for (std::size_t i = 0; i < p.size(); ++i) {
                                         const bool on_z = p[i].z() == 0 || p[i].z() == 1;
                                         const bool on_x = p[i].x() == 0;
                                         v[i] = along;
                                         v[i].z() = on_z ? velocity.z() : 0;
                                         v[i].x() = on_x ? velocity.x() : along.x();
                                     }
                                 },
                                 double(k) / steps, 1.0 / steps)
                             .unreached;
            const ValidationReport report = validate(complex);
            ASSERT_TRUE(report.ok()) << report.problem;
        }
        EXPECT_EQ(unreached, 0U);
        EXPECT_EQ(count_strata(complex).point, points);
        EXPECT_LT(ball.off_on_sides(complex, along), 1e-12);
        EXPECT_GT(mesh_quality(complex).min_dihedral, 3);
    }
}

// What a flow would carry across a side stays in front of it and is counted; it never ends there.
TEST(Sides3, AnInterfaceStaysInFrontOfASideThatItMeets) {
    const double h = 1.0 / 12;
    const Velocity towards_x = [](std::span<const Point> p, double, std::span<Point> v) {
        std::fill_n(v.begin(), p.size(), Point(-1, 0, 0));
    };
    std::vector<Point> centres{{0.3, 0, 0}};
    if (!is_quick) {
        centres.insert(centres.end(), {{0.3, 0.5, 0.5}, {0.3, 0.5, 0}});
    }
    for (const Point& centre : centres) {
        Complex complex = Ball{centre}.complex(h);
        Simulation simulation(complex, {.edge_length = h});
        for (int k = 0; k < 8; ++k) {
            const StepReport report = simulation.step(towards_x, 0, h / 4);
            const double beyond = radius - centre.x() + (k + 1) * h / 4;
            if (beyond < 0) {
                EXPECT_EQ(report.unreached, 0U) << "step " << k;
            } else if (beyond > h / 4) {
                EXPECT_GT(report.unreached, 0U) << "step " << k;
            }
            const ValidationReport valid = validate(complex);
            ASSERT_TRUE(valid.ok()) << valid.problem;
            for (const std::uint32_t v : simulation.interface()) {
                EXPECT_GT(complex.at(v).x(), 0);
            }
        }
    }
}

std::vector<Point> sites_apart(std::size_t count, double distance, std::uint64_t seed) {
    dsc::test::Random random(seed);
    std::vector<Point> sites;
    while (sites.size() < count) {
        const Point site(random.unit(), random.unit(), random.unit());
        if (std::all_of(sites.begin(), sites.end(),
                        [&](const Point& other) { return (site - other).norm() > distance; })) {
            sites.push_back(site);
        }
    }
    return sites;
}

// A foam that fills the domain, in a flow along all of its sides that turns back.
TEST(Sides3, AFoamComesBack) {
    const double h = is_quick ? 1.0 / 8 : 1.0 / 16;
    const std::vector<Point> sites = sites_apart(6, 0.45, 2);
    Complex complex = initial_complex({}, voronoi_cells(sites), {.edge_length = h});
    // The distance of the faces from the bisectors where they should be, integrated by the vertices
    // of four parts.
    const auto difference = [&] {
        double sum = 0;
        for (const InterfaceFace& face : interface_faces(complex)) {
            const Point& one = sites[face.inside];
            const Point& other = sites[face.outside];
            const auto off = [&](const Point& p) {
                return std::abs((p - midpoint(one, other)).dot((one - other).normalized()));
            };
            const auto [a, b, c] = face.v;
            const Point ab = complex.at(b) - complex.at(a);
            const Point ac = complex.at(c) - complex.at(a);
            sum += ab.cross(ac).norm() / 2 *
                   (off(complex.at(a)) + off(complex.at(b)) + off(complex.at(c))) / 3;
        }
        return sum;
    };
    const std::uint32_t points = count_strata(complex).point; // where curves meet or reach a side
    EXPECT_GT(points, 15U);
    ASSERT_LT(difference(), 1e-5);
    EXPECT_GT(mesh_quality(complex).min_dihedral, 5);
    Simulation simulation(complex, {.edge_length = h});
    const double period = 0.5;
    const int steps = is_quick ? 2 : 16;
    std::uint64_t unreached = 0;
    for (int k = 0; k < steps; ++k) {
        unreached += simulation
                         .step(
                             [&](std::span<const Point> p, double t, std::span<Point> v) {
                                 swirl(p, t, v);
                                 const double factor = std::cos(std::numbers::pi * t / period);
                                 for (Point& each : v) {
                                     each *= factor;
                                 }
                             },
                             period * k / steps, period / steps)
                         .unreached;
        const ValidationReport report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
    }
    EXPECT_EQ(unreached, 0U);
    EXPECT_EQ(count_strata(complex).point, points);
    EXPECT_LT(difference(), is_quick ? 1e-3 : 2e-4);
    EXPECT_GT(mesh_quality(complex).min_dihedral, 3);
}

// Cells of a few edges: curves and sheets run beside vertices and beside each other.
TEST(Sides3, AFoamBeginsInACoarseMesh) {
    if (is_quick) {
        GTEST_SKIP() << "a large mesh";
    }
    const Complex complex =
        initial_complex({}, voronoi_cells(sites_apart(24, 0.25, 1)), {.edge_length = 1.0 / 12});
    const ValidationReport report = validate(complex);
    ASSERT_TRUE(report.ok()) << report.problem;
    EXPECT_EQ(report.surfaces.size(), 24U);
    EXPECT_GT(mesh_quality(complex).min_dihedral, 1);
}

TEST(Sides3, SitesOfCellsAreFiniteAndDiffer) {
    const std::vector<Point> twice{{0.2, 0.2, 0.2}, {0.4, 0.2, 0.2}, {0.2, 0.2, 0.2}};
    EXPECT_THROW((void)voronoi_cells(twice), InputError);
    const std::vector<Point> infinite{{0.2, 0.2, 0.2}, {0.4, 0.2, INFINITY}};
    EXPECT_THROW((void)voronoi_cells(infinite), InputError);
}

TEST(Sides3, TheSameBitsForAnyNumberOfThreads) {
    const double h = 1.0 / 16;
    std::uint64_t expected = 0;
    for (const std::uint32_t threads : {1U, 2U, 3U}) {
        Complex complex = Ball{half.centre, 2}.complex(h);
        Simulation simulation(complex, {.edge_length = h}, {.threads = threads, .submeshes = 4});
        std::uint64_t treated = 0;
        std::uint64_t together = 0;
        for (int k = 0; k < (is_quick ? 2 : 12); ++k) {
            const StepReport report = simulation.step(swirl, 0, 0.5 * h);
            treated += report.treated;
            together += report.treated_together;
        }
        EXPECT_GT(together, treated / 4) << "else this would prove nothing";
        const ValidationReport report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        expected = threads == 1 ? mesh_hash(complex) : expected;
        EXPECT_EQ(mesh_hash(complex), expected) << threads;
    }
}

} // namespace
} // namespace dsc3::test::sides_test
