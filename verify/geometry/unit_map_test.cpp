// SPDX-License-Identifier: MIT
// The map between world and unit coordinates: exact both ways for whatever lies in its box.
#include "dsc/geometry/unit_map.h"

#include "support/random/scene.h"

#include "dsc/base/error.h"
#include "dsc/initial/unit_box.h"
#include "dsc/motion/unit_velocity.h"
#include "dsc/queries/hash.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsc::unit_map_test {
namespace {

TEST(UnitMap, BringsTheLargerSideToOneToTwo) {
    test::Dice dice(3);
    for (int i = 0; i < 1000; ++i) {
        const double size = std::pow(10.0, dice.in(-280.0, 280.0));
        const Point<double> low = size * dice.in(-3.0, 3.0) * Point<double>(1, dice.in(-1.0, 1.0));
        const Point<double> high = low + size * Point<double>(1, dice.in(0.1, 1.0));
        const UnitMap map = fit_unit_map(low, high);
        const double unit = length_to_unit(map, (high - low).maxCoeff());
        EXPECT_GE(unit, 1) << size;
        EXPECT_LT(unit, 2) << size;
    }
}

TEST(UnitMap, IsExactBothWaysForPointsOfTheBox) {
    test::Dice dice(5);
    int shifted = 0;
    for (int i = 0; i < 2000; ++i) {
        // At and far from the origin, and astride of it.
        const double size = std::pow(10.0, dice.in(-140.0, 140.0));
        const double away = dice.chance(0.5) ? dice.in(-3.0, 3.0) : dice.in(-1e9, 1e9);
        const Point<double> low = size * away * Point<double>(1, dice.in(-1.0, 1.0));
        const Point<double> high = low + Point<double>(size, size);
        const UnitMap map = fit_unit_map(low, high);
        shifted += map.origin.x() != 0 ? 1 : 0;
        for (int k = 0; k < 10; ++k) {
            const Point<double> p(
                std::clamp(low.x() + size * dice.in(0.0, 1.0), low.x(), high.x()),
                std::clamp(low.y() + size * dice.in(0.0, 1.0), low.y(), high.y()));
            const Point<double> unit = to_unit(map, p);
            EXPECT_EQ(to_world(map, unit), p);
            // The difference is exact: taken in more digits it is the same.
            for (int axis = 0; axis < 2; ++axis) {
                const long double exact = static_cast<long double>(p[axis]) - map.origin[axis];
                EXPECT_EQ(static_cast<long double>(length_to_world(map, unit[axis])), exact);
            }
        }
    }
    EXPECT_GT(shifted, 500);
    EXPECT_LT(shifted, 2000);
}

TEST(UnitMap, RefusesWhatIsNoBox) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW((void)fit_unit_map({0, 0}, {0, 1}), InputError);
    EXPECT_THROW((void)fit_unit_map({0, 1}, {1, 0}), InputError);
    EXPECT_THROW((void)fit_unit_map({nan, 0}, {1, 1}), InputError);
    EXPECT_THROW((void)fit_unit_map({0, 0}, {infinity, 1}), InputError);
    EXPECT_THROW((void)fit_unit_map({0, 0}, {nan, 1}), InputError);
    EXPECT_THROW((void)fit_unit_map({0, 0}, {1e-291, 1e-291}), InputError);
    EXPECT_THROW((void)fit_unit_map({-1e308, 0}, {1e308, 1}), InputError);
}

TEST(UnitMap, ComplexIsTheSameBitsAtAnyPowerOfTwo) {
    const std::vector<Shape> shapes{{test::circle_points({0.4, 0.5}, 0.2, 40), 1}};
    const auto plain = initial_complex<double>({}, shapes, {.edge_length = 0.03});
    for (const int power : {-900, -498, 0, 3, 498, 900}) {
        const UnitMap world{{0, 0}, power};
        std::vector<Shape> scaled = shapes;
        for (auto& p : scaled.front().outline) {
            p = to_world(world, p);
        }
        const Rectangle domain{{0, 0}, to_world(world, {1, 1})};
        const UnitMap map = fit_unit_map(domain.low, domain.high);
        EXPECT_EQ(map.exponent, power);
        const auto complex = initial_complex<double>(map, domain, scaled,
                                                     {.edge_length = length_to_world(world, 0.03)});
        EXPECT_EQ(mesh_hash(complex), mesh_hash(plain)) << power;
        const auto back = to_world(map, complex);
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            EXPECT_EQ(back.position(Vertex{v}), to_world(map, complex.position(Vertex{v})));
        }
    }
}

TEST(UnitMap, SizesAreThoseOfTheWorld) {
    const std::vector<Shape> shapes{{test::circle_points({0.4, 0.5}, 0.2, 40), 1}};
    const auto sizes = [](double unit) { // in units of the world
        SizeOptions<double> result{.growth = 1.3, .longest = 0.15 * unit};
        result.by_place = [unit](const Point<double>& p, double, Phase phase) {
            return phase == 1 ? unit : 0.1 * unit + 0.1 * p.x();
        };
        result.on_interface = [unit](const Point<double>& p, double) {
            return 0.03 * unit + 0.02 * p.y();
        };
        result.by_distance = [unit](double distance) { return 0.06 * unit + 0.5 * distance; };
        return result;
    };
    const auto plain =
        initial_complex<double>({}, shapes, {.edge_length = 0.03, .sizes = sizes(1)});
    const UnitMap world{{0, 0}, 20};
    std::vector<Shape> scaled = shapes;
    for (auto& p : scaled.front().outline) {
        p = to_world(world, p);
    }
    const double unit = length_to_world(world, 1);
    const Rectangle domain{{0, 0}, {unit, unit}};
    const auto complex =
        initial_complex<double>(fit_unit_map(domain.low, domain.high), domain, scaled,
                                {.edge_length = 0.03 * unit, .sizes = sizes(unit)});
    EXPECT_EQ(mesh_hash(complex), mesh_hash(plain));
    EXPECT_NE(mesh_hash(complex),
              mesh_hash(initial_complex<double>({}, shapes, {.edge_length = 0.03})));
}

// Ends of curves stay exactly on the sides and at each other, also far from the origin.
TEST(UnitMap, NetworksAreMappedAsWell) {
    const auto network = [](const Point<double>& low, double size) {
        const auto at = [&](double x, double y) -> Point<double> {
            return low + size * Point<double>(x, y);
        };
        return std::vector<Curve>{{{at(0, 0.4), at(0.5, 0.4)}, 1, 0},
                                  {{at(0.5, 0.4), at(1, 0.5)}, 1, 2},
                                  {{at(0.5, 0.4), at(0.4, 0)}, 2, 0}};
    };
    const auto plain = initial_complex<double>({}, network({0, 0}, 1), {.edge_length = 0.05});
    for (const Point<double>& low : {Point<double>(0, 0), Point<double>(1e9, -3e9)}) {
        const double size = 0x1p20;
        const Rectangle domain{low, low + size * Point<double>(1, 1)};
        const UnitMap map = fit_unit_map(domain.low, domain.high);
        const auto complex =
            initial_complex<double>(map, domain, network(low, size), {.edge_length = 0.05 * size});
        if (low.x() == 0) {
            EXPECT_EQ(mesh_hash(complex), mesh_hash(plain));
        }
        // Far away the input is rounded, which may decide a tie otherwise.
        EXPECT_EQ(validate(complex).problem, "");
        for (const Phase phase : {0U, 1U, 2U}) {
            EXPECT_NEAR(phase_area(complex, phase), phase_area(plain, phase), 1e-9);
        }
    }
}

TEST(UnitMap, VelocityIsAskedInTheWorldAndGivenInUnits) {
    const UnitMap map{{1e6, -2e6}, 10};
    std::size_t calls = 0;
    std::size_t asked = 0;
    const Velocity<double> world = [&](std::span<const Point<double>> positions, double time,
                                       std::span<Point<double>> velocities) {
        ++calls;
        asked += positions.size();
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = positions[i] * time;
        }
    };
    // More than a block, and not a whole number of them.
    std::vector<Point<float>> positions;
    for (int i = 0; i < 300; ++i) {
        positions.emplace_back(static_cast<float>(i) / 512, 1.0F);
    }
    std::vector<Point<float>> velocities(positions.size());
    velocity_to_unit<float>(map, world)(positions, 0.5F, velocities);
    EXPECT_EQ(asked, 300U);
    EXPECT_EQ(calls, 3U);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double x = 0.5 * (1e6 + 1024.0 * static_cast<double>(i) / 512) / 1024;
        const double y = 0.5 * (-2e6 + 1024.0) / 1024;
        EXPECT_EQ(velocities[i], Point<float>(static_cast<float>(x), static_cast<float>(y))) << i;
    }
}

} // namespace
} // namespace dsc::unit_map_test
