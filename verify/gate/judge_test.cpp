// SPDX-License-Identifier: MIT
// The gate's judgement of known measurements, some of which must fail; and its suites: their
// limits, and the errors of bad ones.
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

/// A measured figure, and whether it must pass.
struct Known {
    double measured = 0;
    Limit limit{.value = 1};
    bool at_least = false;
    std::optional<double> drift{};
};

bool passes(const Known& known) {
    const Case of = case_of_scene("scaling");
    const Held held{std::make_shared<const Check>(
                        Check{.name = "one",
                              .figure = [&](const Check::Result&) { return known.measured; },
                              .at_least = known.at_least}),
                    known.limit};
    const Outcome outcome{.configuration = {.of = &of}, .is_done = true};
    const std::vector<const Outcome*> outcomes{&outcome};
    return judge({&of, &held}, outcomes, known.drift).pass;
}

TEST(Judge, HoldsMeasurementsToTheirLimit) {
    const Limit one{.value = 1};
    const Limit around{.value = 1, .around = 5}; // the distance from a published figure
    const Limit upper{.value = 1, .measured = 0.6};
    const Limit lower{.value = 1, .measured = 1.5};
    const std::vector<Known> good{
        {-1},
        {0.999},
        {1},
        {1, one, true},
        {10, one, true},
        {4, around},
        {6, around},
        {0.7, upper},
        {0.65, upper, false, 0.1},
        {0.1, upper, false, 0.1},
        {3, lower, true, 0.1},
        {0, one},
    };
    const std::vector<Known> bad{
        {1.001},        {none},         {0.999, one, true},       {none, one, true},
        {3.99, around}, {none, around}, {0.7, upper, false, 0.1}, {1.3, lower, true, 0.1},
    };
    for (const Known& known : good) {
        EXPECT_TRUE(passes(known)) << known.measured;
    }
    for (const Known& known : bad) {
        EXPECT_FALSE(passes(known)) << known.measured;
    }
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

// The first run is the sequential one.
TEST(Checks, TakeTheWorstOfTheParallelRuns) {
    std::vector<Outcome> outcomes;
    std::vector<const Outcome*> all;
    for (const double ratio : {1.0, 0.9, 1.3, 1.2}) {
        outcomes.push_back({.is_done = true});
        outcomes.back().result.area_ratio = ratio;
        outcomes.back().result.last = {{"min_quality", ratio}};
    }
    std::ranges::transform(outcomes, std::back_inserter(all), [](const auto& one) { return &one; });
    EXPECT_NEAR(measure(*find_check("parallel_area"), {}, all).value, 0.3, 1e-12);
    EXPECT_EQ(measure(*find_check("parallel_min_quality"), {}, all).value, 0.9);
}

// In runs that compare threads, every thread gets a share of the work; otherwise `mesh_hash` would
// compare one thread with one thread.
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

// --- stored histograms ---------------------------------------------------------------------------

// The histogram of values that are 5 % smaller, each spread evenly over its bin.
scenes::Histogram five_percent_lower(const scenes::Histogram& of) {
    scenes::Histogram lower{of.edges, std::vector<std::uint64_t>(of.counts.size(), 0)};
    for (std::size_t bin = 0; bin < of.counts.size(); ++bin) {
        for (std::uint64_t i = 0; i < of.counts[bin]; ++i) {
            const double share =
                (static_cast<double>(i) + 0.5) / static_cast<double>(of.counts[bin]);
            const double value = 0.95 * std::lerp(of.edges[bin], of.edges[bin + 1], share);
            const auto above = std::ranges::upper_bound(of.edges, value) - of.edges.begin();
            ++lower.counts[static_cast<std::size_t>(above - 1)];
        }
    }
    return lower;
}

// Limits measured in 51 orders hold in 51 others, and for no run whose qualities are 5 % lower.
TEST(StoredHistograms, CatchARegressionWithoutFalseAlarms) {
    constexpr int orders = 51;
    const std::string head = "every_case_has = [\"quality_histogram\", \"median_quality\"]\n"
                             "[[case]]\nscene = \"swirl\"\nh = 0.05\n[case.limits]\n"
                             "area_ratio = { at_most = 1, measured = 0.6, rule = \"half as much "
                             "again\" }\n";
    const Cases cases = read_suite_text(head, "mine.toml", false);
    std::vector<Wanted> wanted = limits_to_measure(cases, orders);
    std::erase_if(wanted, [](const Wanted& one) { return one.held.check->name == "area_ratio"; });
    ASSERT_EQ(wanted.size(), 2U);
    const std::vector<Band> bands = propose(wanted, 2);
    std::vector<Configuration> others;
    for (int order = 0; order < orders; ++order) {
        others.push_back({.of = cases[0].get(), .parameters = cases[0]->parameters});
        others.back().parameters.seed = static_cast<std::uint64_t>(orders + order);
    }
    Runs runs(others, 2);
    for (const Configuration& one : others) {
        Outcome outcome = runs.wait(one);
        const std::vector<const Outcome*> outcomes{&outcome};
        for (const bool is_worse : {false, true}) {
            for (const Band& band : bands) {
                const Held held{band.check, band.limit};
                EXPECT_NE(judge({band.of, &held}, outcomes).pass, is_worse)
                    << band.check->name << " of order " << one.parameters.seed;
            }
            outcome.result.quality_histogram = five_percent_lower(outcome.result.quality_histogram);
        }
    }
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

// The number of limits of each check is fixed here, so that none gets lost.
TEST(Suites, HoldEveryScene) {
    const std::string expected =
        "accuracy 17; accuracy_angle 10; accuracy_area 2; accuracy_half 16; accuracy_jagged 5; "
        "accuracy_lost 21; accuracy_median_angle 10; angle_histogram 2; area_histogram 2; "
        "area_ratio 6; "
        "fluid_amplitude 3; fluid_area 10; fluid_centre 1; fluid_circularity 1; fluid_frequency 2; "
        "fluid_neck 2; fluid_rise 2; fluid_velocity 1; inverted 37; median_angle 2; median_area 2; "
        "median_quality 2; merges 2; mesh_hash 6; "
        "min_quality 27; parallel_area 27; parallel_area_histogram 27; parallel_effort 3; "
        "parallel_events 4; parallel_min_angle 27; parallel_min_quality 27; "
        "parallel_quality_histogram 27; parallel_symmetric_difference 25; parallel_unreached 27; "
        "quality_histogram 2; "
        "reference_area 6; reference_area_histogram 6; reference_min_quality 6; "
        "reference_quality_histogram 6; seam_error 1; space_angle 4; space_angle_ever 4; "
        "space_difference 4; "
        "space_difference_half 1; space_farthest 3; space_vertices 4; splits 1; "
        "symmetric_difference 6; "
        "symmetric_difference_half 2; unreached 37; widenings 1; wrong_area 1; ";
    std::map<std::string, int> found;
    std::vector<std::string> names;
    for (const auto& c : ours()) {
        for (const Held& held : c->held) {
            ++found[held.check->name];
            // A limit other than a count must state the measurement and the rule from which it
            // follows, unless it belongs to an exact solution or a published figure.
            EXPECT_TRUE(held.limit.measured || held.limit.value == 0 || held.limit.value == 1 ||
                        held.check->group == "fluid")
                << held.limit.where;
            if (held.check->name == "inverted") {
                names.push_back(c->name);
            }
        }
    }
    std::string words;
    for (const auto& [name, count] : found) {
        words += name + ' ' + std::to_string(count) + "; ";
    }
    EXPECT_EQ(words, expected);
    for (const scenes::Scene& scene : scenes::catalogue()) {
        EXPECT_TRUE(std::ranges::find(names, scene.name) != names.end() ||
                    scene.prepare(scene.defaults).fluid)
            << scene.name;
    }
}

const std::string head = "[[case]]\nscene = \"swirl\"\n";

// The error message for this text of a suite.
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
          "limits.area_ratio = { at_most = 1e-12, measured = 2e-16, rule = \"a tenth above\" }",
          "limits.median_area = { at_most = 0.01, around = 0.9 }"}) {
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
        {head + "limits.area_ratio = { at_least = 1 }", {"wrong bound", "at_most"}},
        {head + "limits.min_quality = { at_most = 1 }", {"wrong bound", "at_least"}},
        {head + "limits.area_ratio = { at_most = 1, rule = \"by guess\" }",
         {"by guess", "required"}},
        {head + "limits.median_area = 0.1", {"stored figure is missing", "around"}},
        {head + "limits.area_histogram = 0.1", {"stored histogram is missing", "60 counts"}},
        {head + "limits.area_histogram = { at_most = 1, histogram = [1, 2] }", {"other bins"}},
        {head + "limits.fluid_rise = 1", {"fluid_rise", "no fluid"}},
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
                             "[case.limits] # his\n"
                             "area_ratio = { at_most = 3, measured = 2, rule = \"half as much "
                             "again\", note = \"\u00e9\" } # kept\n\n"
                             "[[case]]\n"
                             "scene = \"scaling\"\n"
                             "limits = { inverted = 0 }\n\n"
                             "[[case]]\n"
                             "scene = \"zalesak\" # the disc\n"
                             "limits.inverted = 0\n";
    const Cases cases = read_suite_text(text, "mine.toml", false);
    const Limit area{
        .value = 0.003, .measured = 0.002, .rule = "half as much again", .note = "\u00e9"};
    const Limit quality{.value = 0.27, .measured = 0.3, .rule = "a tenth below", .orders = 51};
    std::vector<Band> bands{
        {.of = cases[0].get(), .check = find_check("area_ratio"), .limit = area}};
    for (const auto& c : cases) {
        bands.push_back({.of = c.get(), .check = find_check("min_quality"), .limit = quality});
    }
    std::string expected = text;
    const std::string entry = "min_quality = { at_least = 0.27, measured = 0.3 }";
    for (const auto& [before, more] : {std::pair<std::string, std::string>{"# his\n", entry + '\n'},
                                       {"limits = {", ' ' + entry + ','},
                                       {"# the disc\n", "limits." + entry + '\n'}}) {
        expected.insert(expected.find(before) + before.size(), more);
    }
    const std::string old = "at_most = 3, measured = 2,";
    expected.replace(expected.find(old), old.size(), "at_most = 0.003, measured = 0.002,");
    EXPECT_EQ(with_limits(text, "mine.toml", bands), expected);
}

// A second update replaces what the first one wrote.
TEST(Update, WritesWhatALimitStores) {
    std::string text = head + "limits.inverted = 0 # none\n";
    const Cases cases = read_suite_text(text, "mine.toml");
    for (const std::uint64_t count : {7U, 8U}) {
        const Limit histogram{.value = 0.03,
                              .histogram = std::vector<std::uint64_t>(50, count),
                              .measured = 0.02,
                              .rule = "half as much again",
                              .orders = 51};
        const Limit median{
            .value = 0.03, .around = 0.1 * static_cast<double>(count), .measured = 0.02};
        text = with_limits(
            text, "mine.toml",
            {{.of = cases[0].get(), .check = find_check("quality_histogram"), .limit = histogram},
             {.of = cases[0].get(), .check = find_check("median_quality"), .limit = median}});
        const Cases written = read_suite_text(text, "mine.toml");
        ASSERT_EQ(written[0]->held.size(), 3U) << text;
        for (const Held& held : written[0]->held) {
            if (held.check->stores != Stores::nothing) {
                const bool is_histogram = held.check->stores == Stores::histogram;
                EXPECT_EQ(held.limit.histogram,
                          is_histogram ? histogram.histogram : std::vector<std::uint64_t>{});
                EXPECT_EQ(held.limit.around, is_histogram ? std::nullopt : median.around);
            }
        }
    }
    EXPECT_NE(text.find("limits.inverted = 0 # none\n"), std::string::npos) << text;
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
