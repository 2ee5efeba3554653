// SPDX-License-Identifier: MIT
#include "scenes/keys.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"
#include "dsc/base/renamed.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <charconv>
#include <iostream>
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

// In these rows `field` gives access to the key's field: a member pointer, or a function of the
// parameters.
template <class Number, class Field>
Key number(std::string name, Field field, Number low, Number high, std::string allowed) {
    return {std::move(name), std::move(allowed),
            [=](Parameters& p, const std::string& text) {
                return read_number(text, low, high, std::invoke(field, p));
            },
            [=](const Parameters& p) { return Setting(std::invoke(field, p)); }};
}

template <class Enum, std::size_t n, class Field>
Key choice(std::string name, Field field, const EnumTable<Enum, n>& table) {
    return {std::move(name), names_in(table),
            [=](Parameters& p, const std::string& text) {
                const auto value = value_in(table, text);
                if (value) {
                    std::invoke(field, p) = *value;
                }
                return value.has_value();
            },
            [=](const Parameters& p) {
                return Setting(std::string(name_in(table, std::invoke(field, p))));
            }};
}

// A member of the thresholds of the interface.
template <class Value>
auto of_interface(Value InterfaceThresholds::*member) {
    return [member](auto& p) -> auto& { return p.interface.*member; };
}

Key for_some_scenes(Key key) {
    key.is_common = false;
    return key;
}

std::vector<Key> make_keys() {
    using P = Parameters;
    using I = InterfaceThresholds;
    return {
        number("h", &P::h, 1e-40, 1e40, "a length from 1e-40 to 1e40, in units of the domain"),
        number("dt", &P::dt, 1e-40, 1e40, "a time from 1e-40 to 1e40"),
        number("steps", &P::steps, 1, 100'000'000, "a whole number from 1 to 100000000"),
        for_some_scenes(number("period", &P::period, 1e-40, 1e40, "a time from 1e-40 to 1e40")),
        for_some_scenes(number("angle", &P::angle, 5.0, 45.0, "5 to 45 degrees")),
        for_some_scenes(
            number("grains", &P::grains, 4, 1'000'000, "a whole number from 4 to 1000000")),
        for_some_scenes(number("sites", &P::sites, std::uint64_t{0}, std::uint64_t{UINT32_MAX},
                               "a whole number from 0 to 2^32 - 1, which draws the places")),
        for_some_scenes(number("nucleation", &P::nucleation, 0.0, 1e4,
                               "0 to 10000 discs per unit of area and time")),
        for_some_scenes(choice("inside", &P::inside, fineness_names)),
        for_some_scenes(choice("outside", &P::outside, fineness_names)),
        for_some_scenes(choice("ramp", &P::ramp, ramp_names)),
        choice("integrator", &P::integrator, integrator_choice_names),
        number("tolerance", &P::tolerance, 1e-12, 1.0, "1e-12 to 1, an error in edge lengths"),
        choice("insertion", &P::insertion, insertion_names),
        choice("coarsening", of_interface(&I::coarsening), coarsening_names),
        choice("reading", of_interface(&I::reading), reading_names),
        number("longest", of_interface(&I::longest), 0.1, 10.0, "0.1 to 10, in edge lengths"),
        number("shortest", of_interface(&I::shortest), 0.0, 5.0, "0 to 5, in edge lengths"),
        number("deviation", of_interface(&I::deviation), 0.0, 1.0, "0 to 1, in edge lengths"),
        number("turn", of_interface(&I::turn_degrees), 0.0, 180.0, "0 (off), 1 to 180 degrees"),
        number("feature", of_interface(&I::feature_degrees), 0.0, 180.0,
               "0 to 180 degrees: sharper turns at the start are features"),
        number("gap", of_interface(&I::gap), 0.0, 100.0, "0 (off), 0.1 to 100"),
        number("grading", of_interface(&I::grading), 0.0, 100.0, "0 (off), 2 to 100"),
        number("finest", of_interface(&I::finest), 1e-3, 1.0, "0.001 to 1, in edge lengths"),
        number("grade", &P::grade, 0.0, 2.0, "0 (all edges of one length), above 1, up to 2"),
        choice("topology", &P::topology, topology_names),
        number("contact", &P::contact, 0.0, 1.0,
               "0 (0.4 edge lengths), or a length, no wider than a phase"),
        number("min_area", &P::min_area, 1e-3, 1e3, "0.001 to 1000, in squared edge lengths"),
        choice("seams", &P::follows_seams, no_or_yes),
        choice("give_back", &P::gives_back, no_or_yes),
        choice("detail", &P::detail, detail_names),
        number("border_tolerance", &P::border_tolerance, 1e-3, 0.1,
               "0.001 to 0.1, in edge lengths"),
        choice("coverage", &P::coverage, coverage_names),
        choice("real", &P::real, real_type_names),
        number("seed", &P::seed, std::uint64_t{0}, UINT64_MAX, "a whole number from 0 to 2^64 - 1"),
    };
}

} // namespace

std::string text_of(const Setting& setting) {
    struct Writer {
        std::string operator()(double value) const { return to_text(value); }
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
        text += ' ' + key.name + '=' + text_of(key.value(parameters));
    }
    return text;
}

void set_parameter(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& given, const std::string& value) {
    const RenamedOption* renamed = renamed_option(given);
    const std::string key(renamed != nullptr ? renamed->now : given);
    if (renamed != nullptr) {
        std::cerr << "--set " << given << ": " << renamed->warning() << '\n';
    }
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
        throw InputError({.what = "a setting without =",
                          .where = "--set",
                          .value = "'" + setting + "'",
                          .allowed = "key=value"});
    }
    set_parameter(parameters, keys, setting.substr(0, equals), setting.substr(equals + 1));
}

} // namespace dsc::scenes
