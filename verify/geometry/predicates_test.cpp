// SPDX-License-Identifier: MIT
// The predicates against 128-bit integers. Coordinates that are integers times one power of two
// give determinants that fit exactly, for every exponent that a double has; so the expected sign
// comes from arithmetic that shares nothing with the predicates, neither filter nor rationals.
#include "dsc/geometry/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace dsc::predicates_test {
namespace {

__extension__ using Wide = __int128;

struct Site {
    std::int64_t x;
    std::int64_t y;
};

int sign(Wide value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

// Coordinates up to 2^61.
int wide_orientation(Site a, Site b, Site c) {
    const auto difference = [](std::int64_t p, std::int64_t q) { return static_cast<Wide>(p) - q; };
    return sign(difference(b.x, a.x) * difference(c.y, a.y) -
                difference(b.y, a.y) * difference(c.x, a.x));
}

// Differences up to 2^29.
int wide_in_circle(Site a, Site b, Site c, Site d) {
    const auto row = [&](Site p) {
        const Wide x = static_cast<Wide>(p.x) - d.x;
        const Wide y = static_cast<Wide>(p.y) - d.y;
        return std::array<Wide, 3>{x, y, x * x + y * y};
    };
    const auto [ax, ay, al] = row(a);
    const auto [bx, by, bl] = row(b);
    const auto [cx, cy, cl] = row(c);
    return sign(al * (bx * cy - by * cx) + bl * (cx * ay - cy * ax) + cl * (ax * by - ay * bx));
}

double scaled(std::int64_t value, int exponent) {
    return std::ldexp(static_cast<double>(value), exponent);
}

int orientation_of(Site a, Site b, Site c, int exponent) {
    return orientation(scaled(a.x, exponent), scaled(a.y, exponent), scaled(b.x, exponent),
                       scaled(b.y, exponent), scaled(c.x, exponent), scaled(c.y, exponent));
}

int in_circle_of(Site a, Site b, Site c, Site d, int exponent) {
    return in_circle(scaled(a.x, exponent), scaled(a.y, exponent), scaled(b.x, exponent),
                     scaled(b.y, exponent), scaled(c.x, exponent), scaled(c.y, exponent),
                     scaled(d.x, exponent), scaled(d.y, exponent));
}

class Sites {
public:
    explicit Sites(std::uint64_t seed) : random_(seed) {}
    std::int64_t in(std::int64_t low, std::int64_t high) {
        return low +
               static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    Site site(std::int64_t low, std::int64_t high) { return {in(low, high), in(low, high)}; }

private:
    std::mt19937_64 random_;
};

// The sign of the determinant in plain doubles.
int naive_orientation(Site a, Site b, Site c) {
    const auto d = [](std::int64_t value) { return static_cast<double>(value); };
    const double det =
        (d(b.x) - d(a.x)) * (d(c.y) - d(a.y)) - (d(b.y) - d(a.y)) * (d(c.x) - d(a.x));
    return det > 0 ? 1 : (det < 0 ? -1 : 0);
}

// A point next to the line through a and b, up to one unit off in each coordinate.
Site near_line(Sites& sites, Site a, Site b, std::int64_t bound) {
    const auto t = static_cast<long double>(sites.in(-1000, 2000)) / 1000;
    const auto at = [&](std::int64_t p, std::int64_t q) {
        const auto value =
            std::llround(static_cast<long double>(p) + t * static_cast<long double>(q - p));
        return std::clamp<std::int64_t>(value + sites.in(-1, 1), -bound, bound);
    };
    return {at(a.x, b.x), at(a.y, b.y)};
}

TEST(Orientation, AgreesOnNearlyCollinearPointsOfAnySize) {
    Sites sites(1);
    constexpr std::int64_t bound = std::int64_t{1} << 53;
    std::array<int, 3> seen{};
    int naive_wrong = 0;
    for (int i = 0; i < 400'000; ++i) {
        const std::int64_t size = std::int64_t{1} << sites.in(2, 53);
        const Site a = sites.site(-size, size);
        const Site b = sites.site(-size, size);
        const Site c = near_line(sites, a, b, bound);
        const int expected = wide_orientation(a, b, c);
        ++seen[static_cast<std::size_t>(expected + 1)];
        naive_wrong += naive_orientation(a, b, c) != expected ? 1 : 0;
        ASSERT_EQ(orientation_of(a, b, c, 0), expected)
            << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y << ' ' << c.x << ' ' << c.y;
        ASSERT_EQ(orientation_of(b, c, a, 0), expected);
        ASSERT_EQ(orientation_of(b, a, c, 0), -expected);
    }
    for (const int count : seen) {
        EXPECT_GT(count, 1000) << "a sign was hardly met";
    }
    EXPECT_GT(naive_wrong, 1000) << "the points are too easy to tell anything";
}

TEST(Orientation, AgreesAtEveryExponent) {
    Sites sites(2);
    constexpr std::int64_t bound = std::int64_t{1} << 40;
    for (int exponent = -1074; exponent <= 960; exponent += 3) {
        for (int i = 0; i < 20; ++i) {
            const Site a = sites.site(-bound, bound);
            const Site b = sites.site(-bound, bound);
            const Site c = near_line(sites, a, b, 4 * bound);
            ASSERT_EQ(orientation_of(a, b, c, exponent), wide_orientation(a, b, c))
                << "exponent " << exponent;
        }
    }
}

// If the factors of one product vanish, the sign is that of the other product, however small.
TEST(Orientation, KnowsUprightLinesAndEqualPoints) {
    for (const double x : {0.0, 0.1, -1e300, 5e-324}) {
        for (const auto [a, b, c] : {std::array{0.3, 0.7, 0.1}, std::array{0.3, 0.3, 0.1},
                                     std::array{0.3, 0.7, 0.3}, std::array{0.3, 0.7, 0.7}}) {
            EXPECT_EQ(orientation(x, a, x, b, x, c), 0);
            EXPECT_EQ(orientation(a, x, b, x, c, x), 0);
        }
    }
    for (const double small : {1.0, 1e-170, 5e-324}) {
        EXPECT_EQ(orientation(0.5, 0.5, 0.5, 0.5 + small, 0.5 - small, 0.5), small == 1 ? 1 : 0);
        EXPECT_EQ(orientation(0, 0, small, 0, 0, small), 1);
        EXPECT_EQ(orientation(0, 0, 0, small, small, 0), -1);
        EXPECT_EQ(orientation(0, 0, small, small, 0, small), 1);
        EXPECT_EQ(orientation(0, 0, 0, small, small, small), -1);
    }
}

TEST(Orientation, IsZeroForWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_EQ(orientation(bad, 0, 1, 0, 0, 1), 0);
        EXPECT_EQ(orientation(0, 0, 1, bad, 0, 1), 0);
        EXPECT_EQ(orientation(0, 0, 1, 0, bad, 1), 0);
        EXPECT_EQ(in_circle(0, 0, 1, 0, 0, 1, bad, 0.5), 0);
        EXPECT_EQ(in_circle(bad, 0, 1, 0, 0, 1, 0.5, 0.5), 0);
    }
    // Points are finite even if their differences overflow.
    const double huge = std::numeric_limits<double>::max();
    EXPECT_EQ(orientation(-huge, -huge, huge, -huge, huge, huge), 1);
    EXPECT_EQ(in_circle(-huge, -huge, huge, -huge, huge, huge, 0, 0), 1);
}

// All points with integer coordinates on a circle about the origin.
std::vector<Site> circle_sites(std::int64_t squared_radius) {
    std::vector<Site> list;
    const auto radius = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squared_radius)));
    for (std::int64_t x = -radius; x <= radius; ++x) {
        const auto rest = static_cast<double>(squared_radius - x * x);
        const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(rest)));
        if (x * x + y * y == squared_radius) {
            list.push_back({x, y});
            list.push_back({x, -y});
        }
    }
    return list;
}

TEST(InCircle, AgreesOnCocircularAndNearlyCocircularPoints) {
    // 5^2 13^2 17^2 29: many points on one circle, of radius about 5951.
    const std::vector<Site> circle = circle_sites(25LL * 169 * 289 * 29);
    ASSERT_GT(circle.size(), 50U);
    Sites sites(4);
    const auto any = [&] {
        return circle[static_cast<std::size_t>(
            sites.in(0, static_cast<std::int64_t>(circle.size()) - 1))];
    };
    std::array<int, 3> seen{};
    for (int i = 0; i < 60'000; ++i) {
        Site a = any();
        Site b = any();
        Site c = any();
        Site d = any();
        if (i % 2 == 0) {
            d.x += sites.in(-1, 1);
            d.y += sites.in(-1, 1);
        }
        // With the offset, coordinates are exact in doubles, but their squares need not be.
        const std::int64_t offset = i % 3 == 0 ? 0 : std::int64_t{1} << sites.in(20, 48);
        for (Site* p : {&a, &b, &c, &d}) {
            p->x += offset;
            p->y -= offset;
        }
        const int expected = wide_in_circle(a, b, c, d);
        ++seen[static_cast<std::size_t>(expected + 1)];
        ASSERT_EQ(in_circle_of(a, b, c, d, 0), expected);
        ASSERT_EQ(in_circle_of(b, c, a, d, 0), expected);
        ASSERT_EQ(in_circle_of(b, a, c, d, 0), -expected);
    }
    for (const int count : seen) {
        EXPECT_GT(count, 1000) << "a sign was hardly met";
    }
}

TEST(InCircle, AgreesAtEveryExponent) {
    Sites sites(5);
    constexpr std::int64_t bound = std::int64_t{1} << 27;
    for (int exponent = -1074; exponent <= 990; exponent += 3) {
        for (int i = 0; i < 10; ++i) {
            const Site a = sites.site(-bound, bound);
            const Site b = sites.site(-bound, bound);
            const Site c = sites.site(-bound, bound);
            const Site d = i % 2 == 0 ? Site{a.x + sites.in(-1, 1), a.y + sites.in(-1, 1)}
                                      : sites.site(-bound, bound);
            ASSERT_EQ(in_circle_of(a, b, c, d, exponent), wide_in_circle(a, b, c, d))
                << "exponent " << exponent;
        }
    }
}

} // namespace
} // namespace dsc::predicates_test
