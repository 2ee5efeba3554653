// SPDX-License-Identifier: MIT
#include "scenes/keys.h"

#include "dsc/base/error.h"
#include "scenes/digits.h"
#include "scenes/name_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace dsc::scenes {

namespace {

template <class Number>
bool read_number(const std::string& text, Number low, Number high, Number& number) {
    Number read = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, read);
    // Written so that NaN is refused too.
    if (error != std::errc{} || stop != end || !(read >= low && read <= high)) {
        return false;
    }
    number = read;
    return true;
}

// In these rows `field` gives a reference to the field of the key, for const and non-const
// Parameters.

template <class Number, class Field>
Key number(std::string name, Number low, Number high, std::string allowed, Field field) {
    return {std::move(name), std::move(allowed),
            [=](Parameters& p, const std::string& text) {
                return read_number(text, low, high, field(p));
            },
            [=](const Parameters& p) { return Setting(field(p)); }};
}

template <class Enum, std::size_t n, class Field>
Key choice(std::string name, const EnumTable<Enum, n>& table, Field field) {
    return {std::move(name), names_in(table),
            [=](Parameters& p, const std::string& text) {
                const auto value = value_in(table, text);
                if (value) {
                    field(p) = *value;
                }
                return value.has_value();
            },
            [=](const Parameters& p) { return Setting(std::string(name_in(table, field(p)))); }};
}

Key for_some_scenes(Key key) {
    key.is_common = false;
    return key;
}

std::vector<Key> make_keys() {
    return {
        number(
            "h", 1e-5, 1.0, "a length from 1e-5 to 1, in units of the domain",
            [](auto& p) -> auto& { return p.h; }),
        number(
            "dt", 1e-12, 1e3, "a time from 1e-12 to 1000", [](auto& p) -> auto& { return p.dt; }),
        number(
            "steps", 1, 100'000'000, "a whole number from 1 to 100000000",
            [](auto& p) -> auto& { return p.steps; }),
        for_some_scenes(number(
            "period", 1e-6, 1e6, "a time from 1e-6 to 1e6",
            [](auto& p) -> auto& { return p.period; })),
        for_some_scenes(number(
            "angle", 5.0, 45.0, "5 to 45 degrees", [](auto& p) -> auto& { return p.angle; })),
        for_some_scenes(number(
            "grains", 4, 1'000'000, "a whole number from 4 to 1000000",
            [](auto& p) -> auto& { return p.grains; })),
        for_some_scenes(choice(
            "inside", fineness_names, [](auto& p) -> auto& { return p.inside; })),
        for_some_scenes(choice(
            "outside", fineness_names, [](auto& p) -> auto& { return p.outside; })),
        for_some_scenes(choice(
            "ramp", ramp_names, [](auto& p) -> auto& { return p.ramp; })),
        choice(
            "integrator", integrator_choice_names, [](auto& p) -> auto& { return p.integrator; }),
        number(
            "tolerance", 1e-12, 1.0, "1e-12 to 1, an error in edge lengths",
            [](auto& p) -> auto& { return p.tolerance; }),
        choice(
            "insertion", insertion_names, [](auto& p) -> auto& { return p.insertion; }),
        choice(
            "coarsening", coarsening_names,
            [](auto& p) -> auto& { return p.interface.coarsening; }),
        choice(
            "reading", reading_names, [](auto& p) -> auto& { return p.interface.reading; }),
        number(
            "longest", 0.1, 10.0, "0.1 to 10, in edge lengths",
            [](auto& p) -> auto& { return p.interface.longest; }),
        number(
            "shortest", 0.0, 5.0, "0 to 5, in edge lengths",
            [](auto& p) -> auto& { return p.interface.shortest; }),
        number(
            "deviation", 0.0, 1.0, "0 to 1, in edge lengths",
            [](auto& p) -> auto& { return p.interface.deviation; }),
        number(
            "turn", 0.0, 180.0, "0 (off), 1 to 180 degrees",
            [](auto& p) -> auto& { return p.interface.turn_degrees; }),
        number(
            "corner", 0.0, 180.0, "0 to 180 degrees: sharper turns at the start are corners",
            [](auto& p) -> auto& { return p.interface.corner_degrees; }),
        number(
            "gap", 0.0, 100.0, "0 (off), 0.1 to 100",
            [](auto& p) -> auto& { return p.interface.gap; }),
        number(
            "grading", 0.0, 100.0, "0 (off), 2 to 100",
            [](auto& p) -> auto& { return p.interface.grading; }),
        number(
            "finest", 1e-3, 1.0, "0.001 to 1, in edge lengths",
            [](auto& p) -> auto& { return p.interface.finest; }),
        number(
            "grade", 0.0, 2.0, "0 (all edges of one length), above 1, up to 2",
            [](auto& p) -> auto& { return p.grade; }),
        choice(
            "topology", topology_names, [](auto& p) -> auto& { return p.topology; }),
        number(
            "contact", 0.0, 1.0, "0 (0.4 edge lengths), or a length, no wider than a phase",
            [](auto& p) -> auto& { return p.contact; }),
        number(
            "least_area", 1e-3, 1e3, "0.001 to 1000, in squared edge lengths",
            [](auto& p) -> auto& { return p.least_area; }),
        choice(
            "seams", no_or_yes, [](auto& p) -> auto& { return p.follows_seams; }),
        choice(
            "give_back", no_or_yes, [](auto& p) -> auto& { return p.gives_back; }),
        choice(
            "real", real_type_names, [](auto& p) -> auto& { return p.real; }),
        number(
            "seed", std::uint64_t{0}, UINT64_MAX, "a whole number from 0 to 2^64 - 1",
            [](auto& p) -> auto& { return p.seed; }),
    };
}

} // namespace

std::string text_of(const Setting& setting) {
    struct Writer {
        std::string operator()(double value) const { return shortest_digits(value); }
        std::string operator()(int value) const { return std::to_string(value); }
        std::string operator()(std::uint64_t value) const { return std::to_string(value); }
        std::string operator()(const std::string& value) const { return value; }
    };
    return std::visit(Writer{}, setting);
}

const std::vector<Key>& parameter_keys() {
    static const std::vector<Key> keys = make_keys();
    return keys;
}

std::vector<std::string> common_keys(std::initializer_list<const char*> more) {
    std::vector<std::string> names;
    for (const Key& key : parameter_keys()) {
        if (key.is_common) {
            names.push_back(key.name);
        }
    }
    names.insert(names.end(), more.begin(), more.end());
    return names;
}

std::string text_of(const Parameters& parameters) {
    std::string text;
    for (const Key& key : parameter_keys()) {
        text += '/' + text_of(key.value(parameters));
    }
    return text;
}

void set_parameter(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& key, const std::string& value) {
    const auto found =
        std::ranges::find_if(parameter_keys(), [&](const Key& one) { return one.name == key; });
    if (found == parameter_keys().end() || std::ranges::find(keys, key) == keys.end()) {
        throw InputError({.what = "unknown key",
                          .where = "--set",
                          .value = "'" + key + "'",
                          .allowed = "for this scene: " + name_list(keys)});
    }
    if (!found->parse(parameters, value)) {
        throw InputError({.what = "bad value",
                          .where = "--set " + key,
                          .value = "'" + value + "'",
                          .allowed = found->allowed});
    }
}

void apply_setting(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& setting) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) {
        throw InputError({.what = "not a setting",
                          .where = "--set",
                          .value = "'" + setting + "'",
                          .allowed = "key=value"});
    }
    set_parameter(parameters, keys, setting.substr(0, equals), setting.substr(equals + 1));
}

} // namespace dsc::scenes
