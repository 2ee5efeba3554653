// SPDX-License-Identifier: MIT
// What an integrator of the application's own is given and told, in all ways to run.
#include "dsc/motion/integrator.h"

#include "support/courses.h"

#include "dsc/algorithm/simulation.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

namespace dsc::custom_integrator_test {
namespace {

using test::Course;
using test::disc;
using test::disc_h;

// Euler's method, which counts what it is asked and told.
class Counting : public CustomIntegrator<double> {
public:
    struct Counts {
        std::atomic<std::size_t> begun = 0;
        std::atomic<std::size_t> accepted = 0; ///< vertices
        std::vector<std::uint32_t> forgotten;
    };
    explicit Counting(Counts& counts, double error = 0) : counts_(counts), error_(error) {}

    void begin(Complex<double>&) const override { ++counts_.begun; }
    double integrate(const IntegratorStep<double>& step, const Velocity<double>&, double,
                     IntegratorScratch<double>& scratch) const override {
        for (std::size_t i = 0; i < step.vertices.size(); ++i) {
            step.targets[i] = step.positions[i] + step.dt * scratch.first[i];
        }
        return error_ * std::pow(step.dt, 4);
    }
    void accept(const IntegratorStep<double>& step) const override {
        for (std::size_t i = 0; i < step.vertices.size(); ++i) {
            EXPECT_EQ(step.positions[i], step.complex.position(Vertex{step.vertices[i]}));
        }
        counts_.accepted += step.vertices.size();
    }
    void forget(Complex<double>&, std::span<const std::uint32_t> vertices) const override {
        counts_.forgotten.insert(counts_.forgotten.end(), vertices.begin(), vertices.end());
    }

private:
    Counts& counts_;
    double error_; ///< of a step of duration 1
};

class CustomIntegratorOf : public testing::TestWithParam<Course> {};

TEST_P(CustomIntegratorOf, MovesTheSameBitsAsOneOfTheCore) {
    Complex<double> complex = disc();
    Complex<double> other = disc();
    Counting::Counts counts;
    const auto simulation = test::make_simulation(
        complex,
        {.edge_length = disc_h, .custom_integrator = std::make_shared<const Counting>(counts)},
        GetParam());
    const auto by_euler = test::make_simulation(
        other, {.edge_length = disc_h, .integrator = Integrator::euler}, GetParam());
    EXPECT_EQ(counts.begun, 1U);
    for (int step = 0; step < 10; ++step) {
        counts.accepted = 0;
        const StepReport report = simulation->step(test::swirl, 0.01 * step, 0.01);
        (void)by_euler->step(test::swirl, 0.01 * step, 0.01);
        ASSERT_EQ(mesh_hash(complex), mesh_hash(other));
        ASSERT_EQ(report.sub_steps, 1U);
        // Nothing that comes or goes after the targets are found is on the interface.
        EXPECT_EQ(counts.accepted, report.interface_vertices);
    }
    test::expect_sound(complex, *simulation);
}

TEST_P(CustomIntegratorOf, IsToldWhichVerticesStartAfresh) {
    Complex<double> complex = disc();
    Counting::Counts counts;
    Options<double> options{.edge_length = disc_h};
    const auto simulation = test::make_simulation(complex, options, GetParam());
    (void)simulation->step(test::swirl, 0, 0.02);
    options.custom_integrator = std::make_shared<const Counting>(counts);
    simulation->set_options(options); // another one was used before
    EXPECT_EQ(counts.begun, 1U);
    EXPECT_EQ(counts.forgotten, simulation->interface());

    counts.forgotten.clear();
    simulation->set_options(options);
    EXPECT_EQ(counts.begun, 2U);
    (void)simulation->step(test::swirl, 0.02, 0.02);
    EXPECT_TRUE(counts.forgotten.empty());

    const Vertex moved{simulation->interface()[3]};
    complex.set_position(moved, complex.position(moved) + Point<double>(1e-4, 0));
    (void)simulation->step(test::swirl, 0.04, 0.02);
    EXPECT_EQ(counts.forgotten, std::vector<std::uint32_t>{moved.id});

    counts.forgotten.clear();
    simulation->forget();
    EXPECT_EQ(counts.forgotten, simulation->interface());
}

TEST_P(CustomIntegratorOf, ChoosesTheSubStepsByItsEstimate) {
    Complex<double> complex = disc();
    Counting::Counts counts;
    Options<double> options{.edge_length = disc_h, .tolerance = 1e-4};
    // A step of 0.02 would be off by 100 times what is tolerated: a quarter of it is not.
    const double tolerated = options.tolerance * options.edge_length;
    options.custom_integrator =
        std::make_shared<const Counting>(counts, 100 * tolerated / std::pow(0.02, 4));
    const auto simulation = test::make_simulation(complex, options, GetParam());
    const StepReport report = simulation->step(test::swirl, 0, 0.02);
    EXPECT_GE(report.sub_steps, 4U);
    EXPECT_LE(report.sub_steps, 6U);
    EXPECT_GT(report.error, 0);
    EXPECT_LE(report.error, tolerated);
}

INSTANTIATE_TEST_SUITE_P(All, CustomIntegratorOf, testing::ValuesIn(test::all_courses),
                         test::course_name);

} // namespace
} // namespace dsc::custom_integrator_test
