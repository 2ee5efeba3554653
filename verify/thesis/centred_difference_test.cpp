// SPDX-License-Identifier: MIT
// The centred difference: its order, and its memory of the last step.
#include "thesis/algorithm/centred_difference.h"

#include "support/courses.h"
#include "support/simulation_testing.h"
#include "support/small_meshes.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dsc::centred_difference_test {
namespace {

using test::options_for;

// A rotation about the origin with changing speed: by the angle sin(t) from time 0 to t.
const Velocity<double> changing_turn = test::pointwise([](const Point<double>& p, double time) {
    return Point<double>(std::cos(time) * Point<double>(-p.y(), p.x()));
});

// Integrates one point, as if it were the first vertex of a complex.
class OnePoint {
public:
    explicit OnePoint(const Point<double>& start) : at_{start} {
        scratch_.first.resize(1);
        integrator_->begin(complex_);
    }
    void go(double time, double dt) {
        changing_turn(at_, time, scratch_.first);
        const IntegratorStep<double> step{complex_, vertices_, at_, to_, held_, dt};
        EXPECT_EQ(integrator_->integrate(step, changing_turn, time, scratch_), 0);
        integrator_->accept(step);
        at_ = to_;
    }
    [[nodiscard]] const Point<double>& at() const { return at_[0]; }
    Past<double>& past() { return past_of(complex_)[Vertex{0}]; }

private:
    std::shared_ptr<const CustomIntegrator<double>> integrator_ = centred_difference<double>();
    Complex<double> complex_ = test::hexagon<double>();
    std::vector<std::uint32_t> vertices_{0};
    std::vector<std::uint8_t> held_{0};
    std::vector<Point<double>> at_;
    std::vector<Point<double>> to_{{0, 0}};
    IntegratorScratch<double> scratch_;
};

// The error with steps of alternating lengths, if `ratio` is not 1.
double error_after(int steps, double ratio) {
    OnePoint point({1, 0});
    double time = 0;
    const double mean = 2.0 / steps;
    for (int i = 0; i < steps; ++i) {
        const double dt = 2 * mean * (i % 2 == 0 ? ratio : 1) / (1 + ratio);
        point.go(time, dt);
        time += dt;
    }
    const double angle = std::sin(time);
    return (point.at() - Point<double>(std::cos(angle), std::sin(angle))).norm();
}

TEST(CentredDifference, HasSecondOrderForEqualAndForUnequalSteps) {
    for (const double ratio : {1.0, 1.5}) {
        EXPECT_NEAR(std::log2(error_after(80, ratio) / error_after(160, ratio)), 2, 0.2) << ratio;
        EXPECT_LT(error_after(160, ratio), 3e-4);
    }
}

// A velocity at right angles to the last step has jumped, as at the tip where two growing discs
// meet; the last step is then not used.
TEST(CentredDifference, LeavesAPastBehindThatLeadsElsewhere) {
    OnePoint without({0.5, 0.25});
    OnePoint with({0.5, 0.25});
    with.past() = {Point<double>(0.125, 0.0625), 0.25};
    without.go(0, 0.25);
    with.go(0, 0.25);
    EXPECT_EQ(with.at().x(), without.at().x());
    EXPECT_EQ(with.at().y(), without.at().y());
}

// A flow that reverses comes to rest in between; a last step that is short relative to the edges is
// used, whatever its direction.
TEST(CentredDifference, KeepsAPastThatIsShortBesideTheEdges) {
    OnePoint point({0.5, 0.25});
    point.past() = {Point<double>(1.0 / 512, -1.0 / 1024), 0.25};
    point.go(0, 0.25);
    EXPECT_EQ(point.at().x(), 0.375 - 1.0 / 512);
    EXPECT_EQ(point.at().y(), 0.5 + 1.0 / 1024);
}

// An error of the last step, even its rounding error, enters the next step times the square of the
// ratio of their lengths, so a much shorter last step is not used.
TEST(CentredDifference, LeavesAPastBehindThatIsMuchShorter) {
    const std::vector<double> abrupt{0.01, 1e-12, 0.01, 1e-4, 0.01, 1e-9, 1e-6, 1e-3, 0.01};
    std::vector<double> gradual; // no step is much longer than the one before
    for (double dt = 1e-12; dt < 0.02; dt *= 1.5) {
        gradual.push_back(dt);
    }
    for (const std::vector<double>& steps : {abrupt, gradual}) {
        Complex<double> complex = test::disc();
        Options<double> options = options_for<double>(test::disc_h);
        options.custom_integrator = centred_difference<double>();
        options.max_sub_steps = 50; // so that the test ends if it fails
        Simulation<double> simulation(complex, options);
        const Vertex seen{simulation.interface().front()};
        const Point<double> start = complex.position(seen);
        const Velocity<double> wind = test::constant<double>(0.5, 0.25);
        double time = 0;
        for (const double dt : steps) {
            const StepReport report = simulation.step(wind, time, dt);
            time += dt;
            ASSERT_EQ(report.unreached, 0U) << dt;
            ASSERT_EQ(report.sub_steps, 1U) << dt;
        }
        const Point<double> way = complex.position(seen) - start;
        EXPECT_NEAR(way.x(), 0.5 * time, 1e-13);
        EXPECT_NEAR(way.y(), 0.25 * time, 1e-13);
    }
}

// Counter-clockwise about the middle of the domain.
Velocity<double> turn(double speed) {
    return test::pointwise<double>([=](const Point<double>& p, double) {
        return Point<double>(-speed * (p.y() - 0.5), speed * (p.x() - 0.5));
    });
}

// If the flow becomes faster unannounced, the memory is that of the slower flow, and the step is
// wrong by half its length; `forget` makes it start anew. Setting options with the same integrator
// does not clear the memory; another integrator in between does.
TEST(CentredDifference, ForgetsWhenItIsTold) {
    enum class Told { nothing, the_same, to_forget, another };
    std::array<double, 4> error{};
    for (const Told told : {Told::nothing, Told::the_same, Told::to_forget, Told::another}) {
        auto complex = test::disc_complex<double>(0.05, {0.5, 0.5}, 0.2);
        auto options = options_for<double>(0.05);
        options.custom_integrator = centred_difference<double>();
        options.interface.coarsening = Coarsening::never;
        Simulation<double> simulation(complex, options);
        for (int i = 0; i < 4; ++i) {
            EXPECT_EQ(simulation.step(turn(1), 0.05 * i, 0.05).unreached, 0U);
        }
        if (told == Told::to_forget) {
            simulation.forget();
        } else if (told == Told::another) {
            options.custom_integrator = nullptr;
            simulation.set_options(options);
        }
        if (told == Told::the_same || told == Told::another) {
            options.custom_integrator = centred_difference<double>();
            simulation.set_options(options);
        }
        for (int i = 4; i < 8; ++i) {
            EXPECT_EQ(simulation.step(turn(2), 0.05 * i, 0.05).unreached, 0U);
        }
        EXPECT_EQ(validate(complex).problem, "");
        for (const std::uint32_t v : simulation.interface()) {
            const Point<double> d = complex.position(Vertex{v}) - Point<double>(0.5, 0.5);
            double& worst = error[static_cast<std::size_t>(told)];
            worst = std::max(worst, std::abs(d.norm() - 0.2));
        }
    }
    EXPECT_GT(error[0], 1e-3);
    EXPECT_EQ(error[1], error[0]);
    EXPECT_LT(error[2], 2e-5);
    EXPECT_EQ(error[3], error[2]);
}

} // namespace
} // namespace dsc::centred_difference_test
