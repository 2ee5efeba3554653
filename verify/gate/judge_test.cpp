// SPDX-License-Identifier: MIT
// The gate's judgement on measurements that are known: what must fail fails.
#include "checks.h"
#include "limits.h"
#include "report.h"
#include "runs.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <vector>

namespace dsc::gate::judge_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A check that measures this, against a limit of 1.
Row judged(double measured, bool at_least) {
    const std::string path = testing::TempDir() + "one_limit.json";
    std::ofstream(path) << R"({"limits": {"one": {"scene": {"value": 1, "note": "by hand"}}}})";
    Check check;
    check.name = "one";
    check.at_least = at_least;
    using Result = decltype(check.measure)::result_type;
    check.measure = [measured](Runs&, const std::string&) { return Result{measured}; };
    Runs runs;
    return judge(check, "scene", Limits::read(path), runs);
}

TEST(Judge, HoldsMeasurementsToTheirLimit) {
    for (const double good : {-1.0, 0.0, 0.999, 1.0}) {
        EXPECT_TRUE(judged(good, false).pass) << good;
    }
    for (const double good : {1.0, 1.001, 10.0}) {
        EXPECT_TRUE(judged(good, true).pass) << good;
    }
    EXPECT_FALSE(judged(1.001, false).pass);
    EXPECT_FALSE(judged(0.999, true).pass);
}

TEST(Judge, FailsWhatIsNotANumber) {
    EXPECT_FALSE(judged(none, false).pass);
    EXPECT_FALSE(judged(none, true).pass);
}

TEST(Judge, FailsWhatCouldNotBeMeasured) {
    Check check;
    check.name = "one";
    using Result = decltype(check.measure)::result_type;
    check.measure = [](Runs&, const std::string&) -> Result {
        throw InvariantError("it broke off");
    };
    const std::string path = testing::TempDir() + "one_limit.json";
    std::ofstream(path) << R"({"limits": {"one": {"scene": {"value": 1, "note": "by hand"}}}})";
    Runs runs;
    const Row row = judge(check, "scene", Limits::read(path), runs);
    EXPECT_FALSE(row.pass);
    EXPECT_EQ(row.failure, "it broke off");
}

// Parallel runs of this scene differ from the sequential one, by any measure.
TEST(Checks, TakeTheWorstOfTheParallelRuns) {
    Runs runs;
    std::vector<const Check*> checks;
    for (const Check& check : all_checks()) {
        checks.push_back(&check);
    }
    for (const char* name : {"parallel_area_histogram", "parallel_quality_histogram"}) {
        const Check& check = *select_checks(checks, {name}).front();
        EXPECT_GT(check.measure(runs, "scaling").value, 0.001) << name;
    }
}

// Without this, `mesh_hash` would compare one thread with one thread.
TEST(Checks, CompareRunsOfWhichThreadsHaveShares) {
    Runs runs;
    for (const scenes::Strategy strategy : scenes::all_strategies()) {
        if (scenes::is_parallel(strategy)) {
            const auto& run = runs.get({.scene = "swirl",
                                        .size = Size::shared,
                                        .strategy = strategy,
                                        .threads = 2,
                                        .measure_shape = false});
            EXPECT_EQ(run.threads_used, 2U) << scenes::to_string(strategy);
        }
    }
}

TEST(Checks, AreNotMadeOfARunThatGaveUp) {
    Runs runs;
    const Configuration hasty{.scene = "scaling", .settings = {"steps=1", "dt=1000"}};
    EXPECT_THROW((void)finished(runs, hasty), GaveUp);
}

} // namespace
} // namespace dsc::gate::judge_test
