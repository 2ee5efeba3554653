// SPDX-License-Identifier: MIT
// Growth along the normal in submeshes: the same bits for any number of threads, and as accurate
// as in one piece. Fans and notches lie across cuts in some of these.
#include "support/random/scene.h"
#include "support/topology/growth_testing.h"

#include "dsc/queries/validate.h"
#include "thesis/copy_executor.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::growth_threads_test {
namespace {

using test::complex_of;
using test::difference;
using test::GrowingShape;
using test::offset_polygon;
using test::Outline;

const Outline star = scenes::star({0.5, 0.5}, 0.3, 0.15, 5, 1);

struct Course {
    std::vector<std::uint64_t> hashes;
    double error = 0;
    std::uint64_t unreached = 0;
};

template <class Real>
Course course_of(const Parallel& parallel, double h) {
    Course course;
    auto complex = complex_of<Real>(star, h);
    const int steps = test::steps_or_fewer(13);
    for (const double speed : {1.0, -1.0}) {
        GrowingShape<Real> growing(complex, h, {.speeds = {{1, 0, speed}}}, &parallel);
        for (int i = 0; i < steps; ++i) {
            course.unreached += growing.run(0, 0.4 * h);
            course.hashes.push_back(mesh_hash(complex));
        }
        test::expect_sound(complex, growing.simulation());
        if (speed > 0) {
            course.error = difference(complex, {offset_polygon(star, 0.4 * steps * h)});
        }
    }
    return course;
}

class GrowthThreads : public testing::TestWithParam<Division> {};

TEST_P(GrowthThreads, GiveTheSameBits) {
    constexpr double h = 0.01;
    Parallel parallel{.threads = 1,
                      .division = GetParam(),
                      .submeshes = GetParam() == Division::fixed ? 6U : 0U,
                      .always_all_threads = true};
    const Course one = course_of<double>(parallel, h);
    EXPECT_LT(one.error, 4e-4);
    EXPECT_EQ(one.unreached, 0U);
    for (const std::uint32_t threads : {2U, 3U}) {
        parallel.threads = threads;
        EXPECT_EQ(course_of<double>(parallel, h).hashes, one.hashes) << threads;
    }
}

TEST_P(GrowthThreads, GiveTheSameBitsInSinglePrecision) {
    constexpr double h = 0.02;
    Parallel parallel{.threads = 1, .division = GetParam(), .always_all_threads = true};
    const Course one = course_of<float>(parallel, h);
    EXPECT_LT(one.error, 2e-3);
    parallel.threads = 2;
    EXPECT_EQ(course_of<float>(parallel, h).hashes, one.hashes);
}

INSTANTIATE_TEST_SUITE_P(Divisions, GrowthThreads,
                         testing::Values(Division::cells, Division::fixed, Division::counting,
                                         copy_division),
                         [](const auto& one) { return std::string(one.param->name); });

} // namespace
} // namespace dsc::growth_threads_test
