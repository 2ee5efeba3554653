// SPDX-License-Identifier: MIT
// The gate's judgement on measurements that are known: what must fail fails. And its suites: what
// they hold, and what is refused in one.
#include "judge.h"
#include "update.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <vector>

namespace dsc::gate::judge_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A check that measures this, against a limit of 1.
Row judged(double measured, bool at_least, Limit limit = {.value = 1}, Strictness strictness = {}) {
    const Case of = case_of_scene("scaling");
    const Held held{std::make_shared<const Check>(
                        Check{.name = "one",
                              .figure = [measured](const Check::Result&) { return measured; },
                              .at_least = at_least}),
                    std::move(limit)};
    const Outcome outcome{.configuration = {.of = &of}, .is_done = true};
    const std::vector<const Outcome*> outcomes{&outcome};
    return judge({&of, &held}, outcomes, strictness);
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

TEST(Judge, FailsWhatHasBecomeWorseOnlyIfAsked) {
    const Limit limit{.value = 1, .measured = 0.6};
    EXPECT_TRUE(judged(0.7, false, limit).pass);
    EXPECT_FALSE(judged(0.7, false, limit, {.drift = 0.1}).pass);
    EXPECT_TRUE(judged(0.65, false, limit, {.drift = 0.1}).pass);
    EXPECT_TRUE(judged(0.1, false, limit, {.drift = 0.1}).pass); // better
    const Limit lower{.value = 1, .measured = 1.5};
    EXPECT_FALSE(judged(1.3, true, lower, {.drift = 0.1}).pass);
    EXPECT_TRUE(judged(3, true, lower, {.drift = 0.1}).pass);
}

TEST(Judge, FailsWhatCouldNotBeMeasured) {
    const Case of = case_of_scene("scaling");
    const Held held{find_check("inverted"), {.value = 1e9}};
    Outcome outcome{.configuration = {.of = &of}, .is_done = true};
    const std::vector<const Outcome*> outcomes{&outcome};
    outcome.error = std::make_exception_ptr(InvariantError("it broke off"));
    const Row row = judge({&of, &held}, outcomes);
    EXPECT_FALSE(row.pass);
    EXPECT_EQ(row.failure, "it broke off");
    outcome.error = nullptr;
    outcome.result.gave_up = "too long a step";
    EXPECT_FALSE(judge({&of, &held}, outcomes).pass);
}

TEST(Judge, TakesTheDistanceFromAPublishedFigure) {
    for (const double good : {4.0, 5.0, 6.0}) {
        EXPECT_TRUE(judged(good, false, {.value = 1, .around = 5}).pass) << good;
    }
    EXPECT_FALSE(judged(3.99, false, {.value = 1, .around = 5}).pass);
    EXPECT_FALSE(judged(none, false, {.value = 1, .around = 5}).pass);
}

// Parallel runs of this scene differ from the sequential one, by any measure; and any number of
// runs at a time gives the same.
TEST(Checks, TakeTheWorstOfTheParallelRuns) {
    auto c = std::make_shared<Case>(case_of_scene("scaling"));
    for (const char* name : {"parallel_area_histogram", "parallel_quality_histogram"}) {
        c->held.push_back({find_check(name), {.value = 1}});
    }
    std::vector<std::vector<Row>> all;
    for (const int jobs : {1, 3}) {
        const std::vector<Task> tasks = tasks_of({c}, {});
        Runs runs(configurations_of(tasks), jobs);
        std::vector<std::string> told;
        all.push_back(
            judge_all(tasks, runs, {}, [&](const Row& row) { told.push_back(row.check->name); }));
        EXPECT_EQ(told, (std::vector<std::string>{"parallel_area_histogram",
                                                  "parallel_quality_histogram"}));
        const auto task = std::ranges::find(tasks, c->held.front().check.get(),
                                            [](const Task& one) { return one.held->check.get(); });
        double worst = 0;
        for (const Configuration& one : configurations_of(*task->held->check, *c)) {
            const Configuration base{.of = c.get(), .parameters = c->parameters};
            worst = std::max(worst, task->held->check->difference(runs.wait(one).result,
                                                                  runs.wait(base).result));
        }
        EXPECT_EQ(all.back().front().measured, worst);
    }
    for (std::size_t i = 0; i < all.front().size(); ++i) {
        EXPECT_GT(all.front()[i].measured.value(), 0.001);
        EXPECT_EQ(all.front()[i].measured, all.back()[i].measured);
    }
}

// Without this, `mesh_hash` would compare one thread with one thread.
TEST(Checks, CompareRunsOfWhichThreadsHaveShares) {
    Case c = case_of_scene("swirl");
    c.parameters.h = 0.0125;
    c.threads = {2};
    const std::vector<Configuration> all = configurations_of(*find_check("mesh_hash"), c);
    EXPECT_EQ(all.size(), c.strategies.size());
    Runs runs(all, 2);
    for (const Configuration& one : all) {
        EXPECT_EQ(finished(runs.wait(one)).threads_used, 2U) << scenes::to_string(one.strategy);
    }
}

// The error of three sizes, 2 h^2.5.
TEST(Checks, FitAnOrderToASeries) {
    const auto order_with = [](double factor_of_last) {
        std::vector<Outcome> outcomes;
        for (const double h : {0.02, 0.005, 0.01}) {
            outcomes.push_back({.is_done = true});
            outcomes.back().result.parameters.h = h;
            outcomes.back().result.last = {{"sd_rel", 2 * std::pow(h, 2.5)}};
        }
        outcomes.back().result.last = {
            {"sd_rel", factor_of_last * number(outcomes.back().result.last, "sd_rel")}};
        const std::vector<const Outcome*> all{&outcomes[0], &outcomes[1], &outcomes[2]};
        return measure(*find_check("accuracy_order"), all).value;
    };
    EXPECT_NEAR(order_with(1), 2.5, 1e-12);
    EXPECT_NEAR(order_with(7), 2.5, 1e-12); // the middle one turns no line
    EXPECT_TRUE(std::isnan(order_with(0)));
    EXPECT_TRUE(std::isnan(order_with(none)));
}

// --- suites --------------------------------------------------------------------------------------

Cases ours() {
    Cases all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DSC_SUITES)) {
        if (entry.is_regular_file()) {
            std::ranges::copy(read_suite(entry.path()), std::back_inserter(all));
        }
    }
    check_names(all);
    return all;
}

// So that no limit gets lost: how many scenes each check has a limit for.
TEST(Suites, HoldEveryScene) {
    const std::map<std::string, int> expected{
        {"area_ratio", 6},
        {"symmetric_difference", 6},
        {"symmetric_difference_half", 2},
        {"inverted", 35},
        {"unreached", 35},
        {"min_quality", 26},
        {"reference_area", 6},
        {"reference_min_quality", 6},
        {"reference_area_histogram", 6},
        {"reference_quality_histogram", 6},
        {"parallel_area", 26},
        {"parallel_symmetric_difference", 24},
        {"parallel_events", 4},
        {"parallel_area_histogram", 26},
        {"parallel_quality_histogram", 26},
        {"parallel_effort", 3},
        {"parallel_min_quality", 26},
        {"parallel_min_angle", 26},
        {"parallel_unreached", 26},
        {"mesh_hash", 6},
        {"accuracy", 16},
        {"accuracy_half", 15},
        {"accuracy_area", 2},
        {"accuracy_jagged", 5},
        {"accuracy_angle", 10},
        {"accuracy_median_angle", 10},
        {"accuracy_lost", 16},
        {"accuracy_order", 1},
        {"fluid_velocity", 1},
        {"fluid_amplitude", 3},
        {"fluid_frequency", 2},
        {"fluid_circularity", 1},
        {"fluid_rise", 2},
        {"fluid_centre", 1},
        {"fluid_area", 9},
        {"fluid_neck", 2},
        {"merges", 1},
        {"splits", 1},
        {"widenings", 1},
    };
    std::map<std::string, int> found;
    std::vector<std::string> names;
    for (const auto& c : ours()) {
        for (const Held& held : c->held) {
            ++found[held.check->name];
            // A limit that is no count says what was measured and how it follows from that; or it
            // is of an exact solution, or beside a published figure.
            EXPECT_TRUE(held.limit.measured || held.limit.value == 0 || held.limit.value == 1 ||
                        held.check->group == "fluid")
                << held.limit.where;
            if (held.check->name == "inverted") {
                names.push_back(c->name);
            }
        }
    }
    EXPECT_EQ(found, expected);
    for (const scenes::Scene& scene : scenes::catalogue()) {
        EXPECT_TRUE(std::ranges::find(names, scene.name) != names.end() ||
                    scene.prepare(scene.defaults).fluid)
            << scene.name;
    }
}

const std::string head = "[[case]]\nscene = \"swirl\"\n";

// What is wrong with this text of a suite.
std::string problem(const std::string& text) {
    try {
        (void)read_suite_text(text, "mine.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Suites, TakeALimitInEveryForm) {
    for (const char* limits :
         {"limits = { area_ratio = 0.1 }", "[case.limits]\narea_ratio = 1e-3",
          "limits.area_ratio = { at_most = 6e-3, measured = 4e-3, rule = \"half as much again\" }",
          "limits.min_quality = { at_least = 0.2, measured = 0.23, rule = \"a tenth below\" }",
          "limits.area_ratio = { at_most = 1e-12, measured = 2e-16, rule = \"a tenth above\" }"}) {
        EXPECT_EQ(problem(head + limits), "") << limits;
    }
}

TEST(Suites, RefuseALimitThatDoesNotFollowItsRule) {
    const std::string half = "measured = 4e-3, rule = \"half as much again\"";
    for (const std::string& limit :
         {"at_most = 0.06, " + half, "at_most = 4.01e-3, " + half, "at_most = 3e-3, " + half,
          std::string("at_most = 1e-6, measured = 8e-15"),
          std::string("at_most = 0.501, measured = 0.5"),
          std::string("at_most = 6e-3, rule = \"half as much again\"")}) {
        const std::string text = problem(head + "limits.area_ratio = { " + limit + " }");
        EXPECT_NE(text.find("mine.toml:3: [case.limits] area_ratio"), std::string::npos) << text;
    }
}

TEST(Suites, SayWhatIsWrong) {
    const std::map<std::string, std::vector<std::string>> wrong{
        {"", {"mine.toml", "no [[case]]"}},
        {head, {"mine.toml:2", "no limit"}},
        {head + "limits.aera_ratio = 1", {"aera_ratio", "area_ratio"}},
        {head + "limits.area_ratio = nan", {"mine.toml:3", "area_ratio", "nan"}},
        {head + "limits.area_ratio = { measured = 1 }", {"a limit is missing", "at_most"}},
        {head + "limits.area_ratio = { at_least = 1 }", {"wrong side", "at_most"}},
        {head + "limits.min_quality = { at_most = 1 }", {"wrong side", "at_least"}},
        {head + "limits.area_ratio = { at_most = 1, rule = \"by guess\" }",
         {"by guess", "required"}},
        {head + "limits.fluid_rise = 1", {"fluid_rise", "no fluid"}},
        {head + "limits.area_ratio = { at_most = 1, at = \"here\" }", {"[measured_at]", "here"}},
        {head + "limits.accuracy_order = 2", {"accuracy_order", "no series"}},
        {"[[case]]\nscene = \"grains\"\nlimits.symmetric_difference = 1",
         {"mine.toml:3", "symmetric_difference", "exact shape"}},
        {head + "limit.area_ratio = 1", {"unknown key", "limits"}},
        {head + "h = -1\nlimits.area_ratio = 1", {"mine.toml:3", "h"}},
        {head + "set = { stpes = 3 }\nlimits.area_ratio = 1", {"stpes", "steps"}},
        {head + "strategies = \"cell\"\nlimits.area_ratio = 1", {"cell", "cells"}},
        {"[[case]]\nscene = \"swril\"", {"mine.toml:2", "swril", "swirl-zalesak"}},
        {"[[case]]\nscene = \"none.toml\"", {"none.toml"}},
        {"every_case_has = [\"min_quality\"]\n" + head + "limits.area_ratio = 1",
         {"a limit is missing", "min_quality", "every_case_has"}},
        {"[defaults]\naera_ratio = { rule = \"kept\" }\n" + head, {"aera_ratio"}},
        {head + "limits.area_ratio = 1\n" + head + "limits.area_ratio = 2",
         {"two limits", "swirl"}},
        {"[[case", {"mine.toml:1"}},
    };
    for (const auto& [text, words] : wrong) {
        const std::string sentence = problem(text);
        for (const std::string& word : words) {
            EXPECT_NE(sentence.find(word), std::string::npos) << text << '\n' << sentence;
        }
    }
}

// --- limits written into a suite -----------------------------------------------------------------

TEST(Update, LeavesEverythingElseAsItIs) {
    const std::string text = "# the \u00e9tude of a swirl\n"
                             "[defaults]\n"
                             "min_quality = { rule = \"a tenth below\", orders = 51 }\n\n"
                             "[[case]] # first\n"
                             "scene = \"swirl\"\n"
                             "[case.limits]\n"
                             "inverted = 0 # none\n"
                             "area_ratio = { at_most = 3, measured = 2, rule = \"half as much "
                             "again\", note = \"\u00e9 \\\"x\\\"\" } # kept\n\n"
                             "[[case]]\n"
                             "name = \"other\"\n"
                             "scene = \"scaling\"\n"
                             "limits = { inverted = 0 }\n\n"
                             "[[case]]\n"
                             "scene = \"zalesak\"\n";
    const Cases cases = read_suite_text(text, "mine.toml", false);
    const auto band = [&](std::size_t i, const char* check, Limit limit) {
        return Band{.of = cases[i].get(), .check = find_check(check), .limit = std::move(limit)};
    };
    const Limit area{
        .value = 0.003, .measured = 0.002, .rule = "half as much again", .note = "\u00e9 \"x\""};
    const Limit quality{.value = 0.27, .measured = 0.3, .rule = "a tenth below", .orders = 51};
    const std::string result =
        with_limits(text, "mine.toml",
                    {band(0, "area_ratio", area), band(0, "min_quality", quality),
                     band(1, "min_quality", quality), band(2, "min_quality", quality)});
    const Cases read = read_suite_text(result, "mine.toml");
    ASSERT_EQ(read.size(), 3U);
    for (const auto& c : read) {
        const auto held = std::ranges::find(c->held, std::string("min_quality"),
                                            [](const Held& one) { return one.check->name; });
        ASSERT_NE(held, c->held.end()) << result;
        EXPECT_EQ(held->limit.value, 0.27);
        EXPECT_EQ(held->limit.orders, 51);
        EXPECT_FALSE(held->limit.at.empty());
    }
    EXPECT_EQ(read[0]->held.size(), 3U);
    EXPECT_EQ(read[0]->held[0].limit.note, "\u00e9 \"x\"");
    for (const char* kept : {"# the \u00e9tude of a swirl\n", "[[case]] # first\n",
                             "inverted = 0 # none\n", " } # kept\n", "machine = "}) {
        EXPECT_NE(result.find(kept), std::string::npos) << kept << '\n' << result;
    }
    // The second time the machine and the compiler are there already.
    EXPECT_EQ(with_limits(result, "mine.toml", {}), result);
}

TEST(Update, RefusesWhatIsNoSuiteAfterwards) {
    const std::string text = head + "limits.area_ratio = 1\n";
    const Cases cases = read_suite_text(text, "mine.toml");
    const Band loose{.of = cases[0].get(),
                     .check = find_check("area_ratio"),
                     .limit = {.value = 9, .measured = 2, .rule = "a tenth above"}};
    EXPECT_THROW((void)with_limits(text, "mine.toml", {loose}), InputError);
}

} // namespace
} // namespace dsc::gate::judge_test
