// SPDX-License-Identifier: MIT
// Curves that end on walls, where the ends move along the wall each way: whatever the length of the
// edges there, no wall vertex may stop them.
#include "support/random/scene.h"
#include "support/simulation_testing.h"
#include "support/ways.h"

#include "dsc/initial/initial_complex.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/growth_corners.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace dsc::wall_contacts_test {
namespace {

using std::numbers::pi;

/// A part of a disc about a place on the wall, phase 1, in the unit square.
struct Piece {
    Point<double> centre{0, 0};
    double radius = 0;
    int quarters = 2; ///< 1: in the corner of the domain
    int turns = 0;    ///< by 90 degrees about the middle of the square: on which wall it is
};

/// A place of the unit square that has been turned.
Point<double> turned(Point<double> p, int turns) {
    for (int i = 0; i < turns; ++i) {
        p = {1 - p.y(), p.x()};
    }
    return p;
}

template <class Real = double>
struct Course {
    Course(const Piece& piece, double h, double growth, const Parallel* parallel = nullptr,
           const GrowthOptions<Real>* growing = nullptr)
        : options(options_of(h, growth)), complex(complex_of(piece, options)),
          simulation(complex, options, executor(parallel, growing)) {}

    static Options<Real> options_of(double h, double growth) {
        auto options = test::options_for<Real>(h);
        options.sizes.growth = growth;
        return options;
    }

    static Complex<Real> complex_of(const Piece& piece, const Options<Real>& options) {
        constexpr int chords = 30; // of a quarter
        const int edges = chords * piece.quarters;
        Curve curve;
        for (int i = 0; i <= edges; ++i) {
            const double angle = pi / 2 * i / chords;
            Point<double> from = piece.radius * Point<double>(std::cos(angle), std::sin(angle));
            if (i % edges == 0) {
                from = i == 0                ? Point<double>(piece.radius, 0)
                       : piece.quarters == 2 ? Point<double>(-piece.radius, 0)
                                             : Point<double>(0, piece.radius);
            }
            curve.points.push_back(turned(piece.centre + from, piece.turns));
        }
        curve.left = 1;
        const std::vector<Curve> curves{curve};
        return initial_complex<Real>({{0, 0}, {1, 1}}, curves,
                                     {.edge_length = static_cast<double>(options.edge_length),
                                      .sizes = sizes_in<double>(options.sizes)});
    }

    std::unique_ptr<Executor<Real>> executor(const Parallel* parallel,
                                             const GrowthOptions<Real>* growing) {
        auto algorithm =
            growing != nullptr ? growth_algorithm(complex, *growing) : default_algorithm<Real>();
        if (parallel != nullptr) {
            return make_executor(complex, options, *parallel, std::move(algorithm));
        }
        return std::make_unique<Executor<Real>>(complex, options, std::move(algorithm));
    }

    template <class AnyFlow>
    void steps(const AnyFlow& flow, double duration, int count) {
        for (int i = 0; i < count; ++i) {
            unreached += simulation
                             .step(flow, static_cast<Real>(duration * i / count),
                                   static_cast<Real>(duration / count))
                             .unreached;
        }
        test::expect_sound(complex, simulation);
        EXPECT_EQ(unreached, 0U);
    }

    /// Farthest along the direction among the interface vertices on its side of the domain.
    double contact(const Point<double>& along) const {
        double farthest = -1;
        for (const std::uint32_t v : simulation.interface()) {
            const Point<double> p =
                complex.position(Vertex{v}).template cast<double>() - Point<double>(0.5, 0.5);
            const double off = std::abs(p.x() * along.y() - p.y() * along.x());
            farthest = off == 0.5 ? std::max(farthest, p.dot(along)) : farthest;
        }
        return farthest;
    }

    Options<Real> options;
    Complex<Real> complex;
    Simulation<Real> simulation;
    std::uint64_t unreached = 0;
};

/// The direction along a wall, counter-clockwise or clockwise around the domain.
Point<double> along(int wall, double way) {
    return way * (turned({1, 0}, wall) - turned({0, 0}, wall));
}

/// A half disc that slides by 0.4, with chords that need neither splits nor collapses.
template <class Real>
std::uint64_t slide(int wall, double way, double growth, const Parallel* parallel, Real most_off) {
    constexpr double distance = 0.4;
    constexpr double h = 0.025;
    const Piece piece{.centre = {0.5 - way * distance / 2, 0}, .radius = 0.2, .turns = wall};
    Course<Real> run(piece, h, growth, parallel);
    const double area = phase_area(run.complex, 1);
    const Point<double> velocity = along(wall, way);
    run.steps(test::constant<Real>(velocity.x(), velocity.y()), distance, 32);
    EXPECT_NEAR(run.contact(velocity), distance / 2 + piece.radius, most_off);
    EXPECT_NEAR(run.contact(-velocity), piece.radius - distance / 2, most_off);
    EXPECT_NEAR(phase_area(run.complex, 1) / area, 1, 10 * most_off);
    return mesh_hash(run.complex);
}

class WallContacts : public testing::TestWithParam<test::Way> {};

TEST_P(WallContacts, SlideAlongEachWallEachWay) {
    Parallel parallel{.submeshes = 4, .always_all_threads = true};
    parallel.division = GetParam().value_or(parallel.division);
    constexpr std::array growths{1.3, 0.0, 1.1, 2.0};
    for (const double growth : std::span(growths).first(test::seeds_or_fewer(growths.size()))) {
        for (int wall = 0; wall < 4; ++wall) {
            for (const double way : {1.0, -1.0}) {
                SCOPED_TRACE(testing::Message()
                             << "growth " << growth << ", wall " << wall << ", way " << way);
                if (!GetParam()) {
                    slide<double>(wall, way, growth, nullptr, 1e-14);
                    slide<float>(wall, way, growth, nullptr, 1e-5F);
                    continue;
                }
                parallel.threads = 1;
                const std::uint64_t one = slide<double>(wall, way, growth, &parallel, 1e-14);
                parallel.threads = 3;
                EXPECT_EQ(slide<double>(wall, way, growth, &parallel, 1e-14), one);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Strategies, WallContacts,
                         testing::Values(std::nullopt, Division::cells, Division::blocks,
                                         copy_division),
                         [](const auto& one) { return test::name_of(one.param); });

TEST(WallContact, ADropSpreadsToItsContactAngle) {
    constexpr double angle = pi / 6;
    for (const double growth : {0.0, 1.3}) {
        SCOPED_TRACE(growth);
        Course<double> run({.centre = {0.5, 0}, .radius = 0.2}, 0.02, growth);
        const double area = phase_area(run.complex, 1);
        CurvatureFlowOptions options{.walls = {{1, -std::cos(angle)}}, .kept_areas = {{1, area}}};
        run.steps(curvature_flow<double>(options), 0.4, 100);
        // The segment of a circle of this area that meets the wall at the angle.
        const double half =
            std::sin(angle) * std::sqrt(area / (angle - std::sin(angle) * std::cos(angle)));
        EXPECT_NEAR(run.contact({1, 0}), half, 1e-3);
        EXPECT_NEAR(run.contact({-1, 0}), half, 1e-3);
    }
}

/// Half and quarter discs, whose radius grows by 0.1.
void grow(double from, double h) {
    const GrowthOptions<double> growing{.speeds = {{1, 0, 1.0}}};
    for (const double growth : {0.0, 1.3}) {
        for (const int quarters : {2, 1}) {
            SCOPED_TRACE(testing::Message()
                         << "h " << h << ", growth " << growth << ", quarters " << quarters);
            const Point<double> centre(quarters == 2 ? 0.5 : 0, 0);
            Course<double> run({.centre = centre, .radius = from, .quarters = quarters}, h, growth,
                               nullptr, &growing);
            run.steps(dsc::growth(growing), 0.1, static_cast<int>(std::ceil(0.2 / h)));
            const double radius = from + 0.1;
            EXPECT_NEAR(run.contact({1, 0}), centre.x() - 0.5 + radius, 0.1 * h);
            EXPECT_NEAR(phase_area(run.complex, 1), pi / 4 * quarters * radius * radius, 3 * h * h);
        }
    }
}

TEST(WallContact, GrowsWithADisc) {
    for (const double h : {0.03, 0.02}) {
        grow(0.15, h);
    }
}

} // namespace
} // namespace dsc::wall_contacts_test
