// SPDX-License-Identifier: MIT
// What curvature flow refuses.
#include "geometric_flows/curvature_flow.h"

#include "dsc/base/error.h"

#include "support/refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dsc::curvature_options_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

void expect_refused(const CurvatureFlowOptions& options, const std::string& words) {
    const std::string sentence = test::refusal([&] { (void)curvature_flow<double>(options); });
    EXPECT_NE(sentence.find(words), std::string::npos) << words << ": " << sentence;
}

TEST(CurvatureFlowOptions, ForcesAreFiniteAndOfOneSign) {
    for (const double bad : {-1.0, infinity, not_a_number}) {
        expect_refused({.tension = bad}, "tension of all pairs");
        expect_refused({.mobility = bad}, "mobility of all pairs");
        expect_refused({.pairs = {{.one = 1, .other = 2, .tension = bad}}}, "tension of phases");
    }
    expect_refused({.mobility = 0}, "mobility of all pairs");
    EXPECT_NO_THROW((void)curvature_flow<double>({.tension = 0}));
}

TEST(CurvatureFlowOptions, PairsAndPhasesAreOfTheDomainAndNamedOnce) {
    expect_refused({.pairs = {{.one = 1, .other = 1}}}, "no interface between");
    expect_refused({.pairs = {{.one = border_phase, .other = 1}}}, "no interface between");
    expect_refused({.pairs = {{.one = 1, .other = border_phase}}}, "no interface between");
    expect_refused({.pairs = {{.one = 1, .other = 2}, {.one = 2, .other = 1}}}, "given twice");
    expect_refused({.boundary_energies = {{.phase = border_phase, .energy = 1}}},
                   "energy of the domain boundary");
    expect_refused({.boundary_energies = {{.phase = 1, .energy = infinity}}},
                   "energy of the domain boundary");
    expect_refused({.boundary_energies = {{.phase = 1}, {.phase = 1}}}, "two energies");
    EXPECT_NO_THROW(
        (void)curvature_flow<double>({.boundary_energies = {{.phase = 1, .energy = -1}}}));
}

TEST(CurvatureFlowOptions, KeptAreasArePositive) {
    for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
        expect_refused({.kept_areas = {{.phase = 1, .area = bad}}},
                       "the area to be kept is out of range");
    }
    expect_refused({.kept_areas = {{.phase = exterior_phase, .area = 1}}}, "cannot be kept");
    expect_refused({.kept_areas = {{.phase = 1, .area = 1}, {.phase = 1, .area = 2}}},
                   "kept twice");
    EXPECT_NO_THROW((void)curvature_flow<double>({.kept_areas = {{.phase = 1, .area = 1}}}));
}

} // namespace
} // namespace dsc::curvature_options_test
