// SPDX-License-Identifier: MIT
// Targets for the edges of the interface itself, by place and time.
#include "support/courses.h"
#include "support/simulation_testing.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc::interface_lengths_test {
namespace {

using test::Course;

constexpr double finest = 0.012;
const Point<double> middle(0.5, 0.5);

// From four times the edge length on the left to the edge length on the right.
double length_at(const Point<double>& p) {
    return finest * (1 + 3 * std::clamp((0.8 - p.x()) / 0.6, 0.0, 1.0));
}

Options<double> by_place() {
    Options<double> options = test::options_for<double>(finest);
    options.sizes.growth = 1.5;
    options.sizes.by_place = [](const Point<double>& p, double, Phase) { return length_at(p); };
    options.sizes.on_interface = [](const Point<double>& p, double) { return length_at(p); };
    return options;
}

const Velocity<double> outwards = test::pointwise<double>(
    [](const Point<double>& p, double) { return Point<double>((p - middle).normalized()); });

struct Lengths {
    double longest = 0; ///< over its target
    double left = 0;    ///< mean of the left third
    double right = 0;   ///< and of the right one
};

Lengths lengths_of(const Complex<double>& complex) {
    Lengths lengths;
    std::array<double, 2> sum{};
    std::array<int, 2> count{};
    for (const Edge e : edges(complex)) {
        if (!is_interface(complex, e)) {
            continue;
        }
        const auto [a, b] = complex.vertices_of(e);
        const double length = (complex.position(a) - complex.position(b)).norm();
        const Point<double> place = (complex.position(a) + complex.position(b)) / 2;
        lengths.longest = std::max(lengths.longest, length / length_at(place));
        for (const std::size_t side : {0U, 1U}) {
            if (side == 0 ? place.x() < 0.4 : place.x() > 0.6) {
                sum[side] += length;
                ++count[side];
            }
        }
    }
    lengths.left = sum[0] / count[0];
    lengths.right = sum[1] / count[1];
    return lengths;
}

class InterfaceLengths : public testing::TestWithParam<Course> {};

TEST_P(InterfaceLengths, FollowThePlace) {
    Complex<double> complex = test::disc_complex<double>(finest, middle, 0.08);
    auto simulation = make_simulation(complex, by_place(), GetParam());
    for (int step = 0; step < 60; ++step) {
        EXPECT_EQ(simulation->step(outwards, 0.0, 0.3 * finest).unreached, 0U);
        EXPECT_EQ(validate(complex).problem, "");
    }
    const Lengths lengths = lengths_of(complex);
    EXPECT_LT(lengths.longest, 1.2); // a step may lengthen edges after remeshing
    EXPECT_GT(lengths.left, 2 * lengths.right);
    EXPECT_LT(lengths.right, 1.5 * finest);
    EXPECT_NEAR(phase_area(complex, 1), 3.1416 * std::pow(0.08 + 18 * finest, 2), 0.004);
}

// Where the target falls, edges are split; where it rises, they are collapsed as far as the curve
// allows.
TEST_P(InterfaceLengths, FollowTheTime) {
    Complex<double> complex = test::disc_complex<double>(finest, middle, 0.3);
    Options<double> options = by_place();
    options.interface.deviation = 0.1;
    const auto length = [](double time) { return time < 1 ? 4 * finest : finest; };
    options.sizes.by_place = [=](const Point<double>&, double time, Phase) { return length(time); };
    options.sizes.on_interface = [=](const Point<double>&, double time) { return length(time); };
    options.sizes.changes_in_time = true;
    auto simulation = make_simulation(complex, options, GetParam());
    const auto edges_at = [&](double time) {
        for (int step = 0; step < 12; ++step) {
            simulation->step(test::constant<double>(1e-9, 0), time, 1e-3);
        }
        test::expect_sound(complex, *simulation);
        return static_cast<double>(simulation->interface_size());
    };
    const double fine = static_cast<double>(simulation->interface_size());
    const double coarse = edges_at(0);
    EXPECT_LT(coarse, 0.7 * fine);
    EXPECT_GT(edges_at(2), 0.9 * fine);
}

INSTANTIATE_TEST_SUITE_P(Sizes, InterfaceLengths, testing::ValuesIn(test::all_courses),
                         test::course_name);

TEST(InterfaceLength, IsNoShorterThanTheEdgeLengthAndNotWithoutGrowth) {
    Options<double> options = by_place();
    options.sizes.growth = 0;
    EXPECT_THROW(check_options(options), InputError);
    options.sizes.by_place = {};
    EXPECT_THROW(check_options(options), InputError);
    options.sizes.growth = 1.5;
    EXPECT_NO_THROW(check_options(options));
    options.sizes.changes_in_time = true;
    EXPECT_NO_THROW(check_options(options));
    options.sizes.on_interface = [](const Point<double>&, double) { return 1e-9; };
    Complex<double> complex = test::disc_complex<double>(finest, middle, 0.1);
    Simulation<double> simulation(complex, options);
    const auto before = simulation.interface_size();
    simulation.step(test::constant<double>(1e-9, 0), 0, 1e-3);
    EXPECT_EQ(simulation.interface_size(), before);
}

// A size function that returns no length is refused with the position: when a simulation is made,
// and in a step, after which the complex is valid and further steps work.
TEST_P(InterfaceLengths, ThatAreNoneAreRefused) {
    for (const double bad : {0.0, -1.0, std::nan("")}) {
        std::atomic<bool> is_bad = true;
        const auto length = [&] { return is_bad ? bad : 4 * finest; };
        for (const std::string name : {"by_place", "on_interface", "by_distance"}) {
            Options<double> options{.edge_length = finest, .sizes = {.growth = 1.3}};
            if (name == "by_place") {
                options.sizes.by_place = [&](const Point<double>&, double, Phase) {
                    return length();
                };
            } else if (name == "on_interface") {
                options.sizes.on_interface = [&](const Point<double>&, double) { return length(); };
            } else {
                options.sizes.by_distance = [&](double) { return length(); };
            }
            Complex<double> complex = test::disc_complex<double>(finest, middle, 0.1);
            is_bad = true;
            const auto make = [&] { return test::make_simulation(complex, options, GetParam()); };
            test::expect_refusal([&] { (void)make(); }, "sizes." + name, to_text(bad) + " at (");
            is_bad = false;
            const auto simulation = make();
            for (int step = 0; step < 6; ++step) {
                is_bad = step % 2 == 1;
                const auto act = [&] {
                    (void)simulation->step(test::constant<double>(finest, 0), step, 1);
                };
                if (is_bad) {
                    test::expect_refusal(act, "sizes." + name);
                } else {
                    act();
                }
                test::expect_sound(complex, *simulation);
            }
        }
    }
}

} // namespace
} // namespace dsc::interface_lengths_test
