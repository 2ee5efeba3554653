// SPDX-License-Identifier: MIT
// The hard cases, and whether those who watch them would notice: see hard/result.h.
#include "hard/expect_case.h"
#include "hard/scene.h"
#include "hard/watch.h"

#include "flows/velocity.h"
#include "shapes/shapes.h"

#include <gtest/gtest.h>

namespace dsc::hard_test {
namespace {

class Hard : public testing::TestWithParam<hard::HardCase> {};

TEST_P(Hard, Holds) { hard::expect_case(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Cases, Hard, testing::ValuesIn(hard::cases_that_are(false)),
                         hard::test_name);

// --- the watch itself ---------------------------------------------------------------------------

hard::HardResult watched_with(void (*fault)(Work<double>&)) {
    constexpr double h = 0.05;
    const std::vector<scenes::Outline> outlines{scenes::circle({0.4, 0.5}, 0.2, h)};
    auto scene = hard::scene_of<double>(hard::unit_square, outlines, h);
    Algorithm<double> algorithm = default_algorithm<double>();
    algorithm.motion.push_back({"fault", fault});
    hard::HardResult result;
    hard::Watch<double> watch(
        scene.complex, scene.options, {.domain = hard::unit_square}, result,
        std::make_unique<Executor<double>>(scene.complex, scene.options, algorithm));
    watch.run(scenes::Translation{{1, 0}}, 0, 0.3 * h, 3);
    hard::expect_sound(result, hard::Targets::reachable);
    return result;
}

TEST(Watch, SeesNothingWhereNothingIsWrong) {
    const hard::HardResult result = watched_with([](Work<double>&) {});
    EXPECT_TRUE(result.holds()) << result.failures.front();
    EXPECT_EQ(result.steps, 3U);
    EXPECT_EQ(result.missed, 0U);
}

TEST(Watch, SeesAVertexThatIsLostWithoutBeingCounted) {
    const hard::HardResult result = watched_with([](Work<double>& work) {
        auto& vertex = work.complex.vertices[work.interface.front()];
        vertex.x -= 1e-9;
    });
    EXPECT_EQ(result.missed, 3U);
    EXPECT_EQ(result.uncounted, 3U);
    EXPECT_FALSE(result.holds());
}

TEST(Watch, SeesAVertexThatIsCountedAndHasArrived) {
    const hard::HardResult result = watched_with([](Work<double>& work) {
        const std::uint32_t v = work.interface.front();
        const Point<double> p = work.complex.position(Vertex{v});
        work.movers.push_back({v, p.x(), p.y()});
        work.progressed = 0;
    });
    EXPECT_EQ(result.missed, 0U);
    EXPECT_GT(result.overcounted, 0U);
    EXPECT_FALSE(result.holds());
}

TEST(Watch, SeesAnInvertedTriangle) {
    const hard::HardResult result = watched_with([](Work<double>& work) {
        auto& triangle = work.complex.triangles[1].v;
        work.complex.vertices[triangle[0]].x += 0.2;
        work.complex.vertices[triangle[0]].y += 0.2;
    });
    EXPECT_GT(result.inverted, 0U);
    EXPECT_FALSE(result.holds());
}

TEST(Watch, SeesAVertexThatIsNotListed) {
    const hard::HardResult result =
        watched_with([](Work<double>& work) { work.interface.pop_back(); });
    EXPECT_FALSE(result.holds());
}

} // namespace
} // namespace dsc::hard_test
