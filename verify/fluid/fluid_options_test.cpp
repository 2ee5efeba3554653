// SPDX-License-Identifier: MIT
// What a fluid refuses.
#include "fluid/scenes.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dsc::fluid_options_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Complex<double> square_with_disc() {
    const std::vector<Shape> shapes{{fluid_scenes::disc({0.5, 0.5}, 0.25, 0.2), 1}};
    return initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.2});
}

FluidOptions two_fluids() {
    FluidOptions options;
    options.phases = {{.phase = 0}, {.phase = 1}};
    options.tensions = {{.tension = 1}};
    return options;
}

void expect_refused(const FluidOptions& options, const std::string& words) {
    const Complex<double> complex = square_with_disc();
    const std::string sentence = test::refusal([&] { const Fluid fluid(complex, options); });
    EXPECT_NE(sentence.find(words), std::string::npos) << words << ": " << sentence;
}

TEST(FluidOptions, PropertiesAreFiniteAndOfOneSign) {
    FluidOptions options = two_fluids();
    for (const double bad : {-1.0, infinity, not_a_number}) {
        options.phases[1] = {.phase = 1, .density = bad};
        expect_refused(options, "density of phase 1");
        options.phases[1] = {.phase = 1, .viscosity = bad};
        expect_refused(options, "viscosity of phase 1");
        options.phases[1] = {.phase = 1};
        options.tensions[0].tension = bad;
        expect_refused(options, "tension of phases 0 and 1");
        options.tensions[0].tension = 1;
    }
    options.phases[1].viscosity = 0;
    expect_refused(options, "viscosity of phase 1");
    options = two_fluids();
    options.gravity = {0, infinity};
    expect_refused(options, "gravity, y");
    options = two_fluids();
    options.implicitness = 0.4;
    expect_refused(options, "implicitness");
    options = two_fluids();
    options.tolerance = -1;
    expect_refused(options, "tolerance");
    options = two_fluids();
    options.threads = 0;
    expect_refused(options, "threads");
    options = two_fluids();
    for (const double bad : {0.0, 180.0, not_a_number}) {
        options.tensions[0].contact_angle = bad;
        expect_refused(options, "contact angle of phases 0 and 1");
    }
    options = two_fluids();
    options.phases[0].is_void = options.phases[1].is_void = true;
    expect_refused(options, "nothing flows");
}

TEST(FluidOptions, EachPhaseAndEachPairThatMeetsIsGivenOnce) {
    FluidOptions options = two_fluids();
    options.phases.pop_back();
    options.tensions.clear();
    expect_refused(options, "phase 1");
    options = two_fluids();
    options.phases.push_back({.phase = 1});
    expect_refused(options, "given twice");
    options = two_fluids();
    options.tensions.clear();
    expect_refused(options, "has no tension");
    options.tensions = {{.one = 0, .other = 1}, {.one = 1, .other = 0}};
    expect_refused(options, "given twice");
    options.tensions = {{.one = 1, .other = 1}};
    expect_refused(options, "no interface between");
    options.tensions = {{.one = 0, .other = 7}};
    expect_refused(options, "phase 7");
}

TEST(FluidOptions, AStepTakesTime) {
    fluid_scenes::Tank tank = fluid_scenes::static_drop(0.2, 1);
    for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
        EXPECT_THROW((void)tank.fluid.step(tank.simulation, bad), InputError);
    }
    EXPECT_EQ(tank.fluid.time(), 0);
}

} // namespace
} // namespace dsc::fluid_options_test
