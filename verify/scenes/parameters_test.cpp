// SPDX-License-Identifier: MIT
// Parameters of the command line: good values are set; bad ones are refused with the key, the value
// and what is allowed, and change nothing.
#include "scenes/keys.h"

#include "support/enumerators.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"
#include "scenes/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dsc::scenes::parameters_test {
namespace {

static_assert(test::is_complete(real_type_names));
static_assert(test::is_complete(fineness_names));
static_assert(test::is_complete(ramp_names));

const std::vector<std::string>& all_keys() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Key& key : parameter_keys()) {
            all.push_back(key.name);
        }
        return all;
    }();
    return names;
}

Parameters with(const std::string& key, const std::string& value) {
    Parameters parameters;
    set_parameter(parameters, all_keys(), key, value);
    return parameters;
}

struct Bad {
    std::string key;
    std::string value;
};

class BadValue : public testing::TestWithParam<Bad> {};

TEST_P(BadValue, IsRefusedWithKeyValueAndWhatIsAllowed) {
    const auto& [key, value] = GetParam();
    Parameters parameters;
    const Parameters before = parameters;
    try {
        set_parameter(parameters, all_keys(), key, value);
        FAIL() << "accepted: " << key << "=" << value;
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find(key), std::string::npos) << text;
        EXPECT_NE(text.find("'" + value + "'"), std::string::npos) << text;
        EXPECT_NE(text.find("allowed: "), std::string::npos) << text;
        EXPECT_FALSE(error.allowed().empty());
        EXPECT_EQ(text.find('\n'), std::string::npos) << "one sentence";
    }
    for (const Key& one : parameter_keys()) {
        EXPECT_EQ(one.value(parameters), one.value(before)) << one.name;
    }
}

std::vector<Bad> bad_values() {
    std::vector<Bad> list;
    for (const char* key : {"h", "dt", "period"}) {
        for (const char* value : {"",      " ",      "abc", "0.1x",   " 0.1", "0.1 ",     "0",
                                  "-0.1",  "nan",    "NaN", "-nan",   "inf",  "infinity", "1e999",
                                  "1e300", "1e-300", "0,1", "0x1p-4", "+0.1", "--1",      "1e"}) {
            list.push_back({key, value});
        }
    }
    for (const char* value : {"", "ten", "1.5", "1e3", "0", "-1", "nan", "100000001",
                              "99999999999999999999", "0x10", "+5", "5 "}) {
        list.push_back({"steps", value});
    }
    for (const char* key : {"tolerance", "longest", "shortest", "deviation", "turn", "feature",
                            "gap", "grading", "finest", "grade"}) {
        for (const char* value : {"", "abc", "-1", "nan", "inf", "1e9", "0.1x"}) {
            list.push_back({key, value});
        }
    }
    for (const char* value : {"", "-1", "1.5", "x", "18446744073709551616", "nan"}) {
        list.push_back({"seed", value});
    }
    for (const char* key : {"integrator", "insertion", "coarsening", "reading", "real", "inside",
                            "outside", "ramp"}) {
        for (const char* value : {"", "RK4", "rk5", "quad", "0", "cubic ", "long double"}) {
            list.push_back({key, value});
        }
    }
    return list;
}

INSTANTIATE_TEST_SUITE_P(Parameters, BadValue, testing::ValuesIn(bad_values()),
                         [](const auto& one) { return std::to_string(one.index); });

// Parameters are printed in result files in the form that the command line reads.
TEST(Parameters, ArePrintedAsTheyAreRead) {
    const std::map<std::string, std::string> texts{
        {"h", "0.125"},           {"dt", "0.5"},         {"steps", "260"},
        {"period", "8"},          {"angle", "30"},       {"grains", "25"},
        {"inside", "coarse"},     {"outside", "coarse"}, {"ramp", "linear"},
        {"integrator", "euler"},  {"tolerance", "0.25"}, {"insertion", "linear"},
        {"coarsening", "length"}, {"reading", "cubic"},  {"longest", "1.25"},
        {"shortest", "0.125"},    {"deviation", "0.5"},  {"turn", "15"},
        {"feature", "180"},       {"gap", "2"},          {"grading", "2.5"},
        {"finest", "0.0625"},     {"grade", "1.25"},     {"topology", "change"},
        {"contact", "0.0078125"}, {"min_area", "0.25"},  {"seams", "no"},
        {"give_back", "yes"},     {"detail", "keep"},    {"border_tolerance", "0.0625"},
        {"coverage", "first"},    {"real", "float"},     {"seed", "18446744073709551615"},
        {"sites", "7"},           {"nucleation", "2.5"}};
    for (const Key& key : parameter_keys()) {
        ASSERT_TRUE(texts.contains(key.name)) << key.name;
        const std::string text = texts.at(key.name);
        const Setting value = key.value(with(key.name, text));
        EXPECT_EQ(text_of(value), text) << key.name;
        EXPECT_NE(value, key.value({})) << key.name << ": drawn differently from the default";
        EXPECT_FALSE(key.allowed.empty()) << key.name;
    }
}

// Each value of an option that is an enumeration can be set, and the error lists all values.
template <class Enum, std::size_t n>
void expect_all_choices(const std::string& name, const EnumTable<Enum, n>& table) {
    for (const auto& one : table) {
        const std::string text(one.name);
        const auto key = std::ranges::find_if(
            parameter_keys(), [&](const Key& candidate) { return candidate.name == name; });
        EXPECT_EQ(std::get<std::string>(key->value(with(name, text))), text);
        EXPECT_NE(key->allowed.find(text), std::string::npos) << text;
    }
}

TEST(Parameters, TakeEachValueOfAnEnum) {
    expect_all_choices("integrator", integrator_choice_names);
    expect_all_choices("insertion", insertion_names);
    expect_all_choices("coarsening", coarsening_names);
    expect_all_choices("reading", reading_names);
    expect_all_choices("real", real_type_names);
    expect_all_choices("inside", fineness_names);
    expect_all_choices("outside", fineness_names);
    expect_all_choices("ramp", ramp_names);
}

TEST(Parameters, ComeAsKeyAndValue) {
    Parameters parameters;
    apply_setting(parameters, all_keys(), "h=0.25");
    EXPECT_EQ(parameters.h, 0.25);
    for (const char* setting : {"", "h", "=", "=1", "h=", "h=0.1=", " h=0.1", "h 0.1"}) {
        EXPECT_THROW(apply_setting(parameters, all_keys(), setting), InputError) << setting;
    }
    EXPECT_EQ(parameters.h, 0.25);
}

TEST(Parameters, AreKnownByTheirNamesOfTheFirstRelease) {
    Parameters parameters;
    testing::internal::CaptureStderr();
    apply_setting(parameters, all_keys(), "corner=20");
    apply_setting(parameters, all_keys(), "least_area=2");
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_EQ(parameters.interface.feature_degrees, 20);
    EXPECT_EQ(parameters.min_area, 2);
    EXPECT_NE(warnings.find("'corner' is now called 'feature'"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("'least_area' is now called 'min_area'"), std::string::npos);
}

TEST(Parameters, RefuseAnUnknownKeyAndNameThoseThatThereAre) {
    Parameters parameters;
    for (const char* key : {"", "H", "size", "h ", "periode"}) {
        try {
            set_parameter(parameters, all_keys(), key, "1");
            FAIL() << "accepted: " << key;
        } catch (const InputError& error) {
            EXPECT_EQ(error.value(), "'" + std::string(key) + "'");
            for (const auto& known : all_keys()) {
                EXPECT_NE(error.allowed().find(known), std::string::npos) << known;
            }
        }
    }
}

TEST(Parameters, AreOnlyThoseOfTheScene) {
    Parameters parameters;
    EXPECT_THROW(set_parameter(parameters, find_scene("translation").keys, "period", "8"),
                 InputError);
    EXPECT_NO_THROW(set_parameter(parameters, find_scene("single-vortex").keys, "period", "2"));
    EXPECT_EQ(parameters.period, 2.0);
}

TEST(Catalogue, HasScenesWithNamesKeysAndSense) {
    std::set<std::string> names;
    for (const Scene& scene : catalogue()) {
        SCOPED_TRACE(scene.name);
        EXPECT_TRUE(names.insert(scene.name).second) << "twice";
        EXPECT_FALSE(scene.description.empty());
        EXPECT_FALSE(scene.section.empty());
        for (const auto& key : scene.keys) {
            EXPECT_NE(std::find(all_keys().begin(), all_keys().end(), key), all_keys().end())
                << key;
        }
        const auto setup = scene.prepare(scene.defaults);
        EXPECT_NE(setup.outlines.empty(), setup.curves.empty());
        EXPECT_EQ(setup.flow.empty(), setup.sees_interface());
        EXPECT_GT(setup.steps, 0);
        EXPECT_TRUE(std::isfinite(setup.dt) && setup.dt > 0);
        if (setup.exact) {
            EXPECT_GT(setup.exact(0).area, 0);
        }
    }
}

// Scenes use the parameters that --set changes.
TEST(Catalogue, FollowsItsParameters) {
    const Scene& scene = find_scene("scaling");
    Parameters parameters = scene.defaults;
    const int steps = scene.prepare(parameters).steps;
    parameters.h *= 0.5;
    const auto fine = scene.prepare(parameters);
    EXPECT_NEAR(fine.steps, 2 * steps, 2);
    EXPECT_NEAR(static_cast<double>(fine.outlines[0].size()) /
                    static_cast<double>(scene.prepare(scene.defaults).outlines[0].size()),
                2, 0.1);
    parameters.steps = 7;
    EXPECT_EQ(scene.prepare(parameters).steps, 7);
    parameters.dt = 0.001;
    EXPECT_EQ(scene.prepare(parameters).dt, 0.001);
    const Scene& swirl = find_scene("swirl");
    Parameters each_way = swirl.defaults;
    each_way.steps = 30;
    EXPECT_EQ(swirl.prepare(each_way).steps, 60);
    EXPECT_EQ(swirl.prepare(each_way).half_step, 30);
}

} // namespace
} // namespace dsc::scenes::parameters_test
