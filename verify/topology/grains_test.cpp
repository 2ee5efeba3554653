// SPDX-License-Identifier: MIT
// A network of grains coarsens to a tenth by curvature flow: no vertex is stuck, and none keeps
// more sectors than are stable.
#include "support/random/scene.h"
#include "support/topology/changing.h"
#include "support/topology/topology_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/parallel.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace dsc::grains_test {
namespace {

std::size_t count_phases(const Complex<double>& complex) {
    std::set<Phase> phases;
    for (const Triangle t : triangles(complex)) {
        phases.insert(complex.phase(t));
    }
    return phases.size();
}

double worst_quality(const Complex<double>& complex) {
    double worst = 1;
    for (const Triangle t : triangles(complex)) {
        worst = std::min(worst, quality(complex, t));
    }
    return worst;
}

struct Course {
    int steps = 0;
    std::vector<Event> events;
};

// Until `least` phases are left, or for `most` steps.
Course coarsen(Complex<double>& complex, double h, std::uint32_t threads, std::size_t least,
               int most) {
    test::ChangingOptions<double> options;
    options.edge_length = h;
    options.topology.rule = Topology::change;
    options.interface.corner_degrees = 180; // curvature flow knows no corners
    test::ChangingSimulation<double> simulation(
        complex, options, Parallel{.threads = threads, .always_all_threads = true});
    const InterfaceMotion<double> motion = curvature_flow<double>();
    const double dt = 0.4 * h * h;
    Course course;
    for (int& step = course.steps; count_phases(complex) > least && step < most; ++step) {
        const test::ChangingReport report = simulation.step(motion, step * dt, dt);
        course.events.insert(course.events.end(), report.events.begin(), report.events.end());
        EXPECT_EQ(report.unreached, 0U) << step;
        EXPECT_EQ(test::ends_of(complex).crowded, 0U) << step;
        EXPECT_EQ(validate(complex).problem, "") << step;
        EXPECT_GT(worst_quality(complex), 0.01) << step;
    }
    return course;
}

TEST(Grains, CoarsenToATenthAndNothingIsStuck) {
    constexpr double h = 0.018;
    auto complex = test::random_grains(30, h, 2);
    EXPECT_LT(coarsen(complex, h, 1, 3, 5000).steps, 5000);
}

} // namespace
} // namespace dsc::grains_test
