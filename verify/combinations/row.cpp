// SPDX-License-Identifier: MIT
#include "combinations/row.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace dsc::combinations {

namespace {

template <class Enum, std::size_t n>
std::span<const std::string_view> names_of(const EnumTable<Enum, n>& table) {
    static const std::array<std::string_view, n> names = [&] {
        std::array<std::string_view, n> list;
        std::ranges::transform(table, list.begin(), [](const auto& one) { return one.name; });
        return list;
    }();
    return names;
}

std::string all_names(std::span<const std::string_view> names) {
    std::string all;
    for (const std::string_view name : names) {
        all += (all.empty() ? "" : ", ") + std::string(name);
    }
    return all;
}

[[noreturn]] void refuse(const std::string& what, std::string_view value,
                         const std::string& allowed) {
    throw InputError(
        {.what = what, .where = "row", .value = std::string(value), .allowed = allowed});
}

} // namespace

std::span<const Feature> features() {
    static const std::array<Feature, feature_count> list{{
        {"place", names_of(place_names)},
        {"phases", names_of(phases_names)},
        {"motion", names_of(motion_names)},
        {"told", names_of(told_names)},
        {"sizes", names_of(sizes_names)},
        {"topology", names_of(rule_names)},
        {"integrator", names_of(scenes::integrator_choice_names)},
        {"insertion", names_of(insertion_names)},
        {"coarsening", names_of(coarsening_names)},
        {"outline", names_of(outline_names)},
        {"way", names_of(way_names)},
        {"submeshes", names_of(submeshes_names)},
        {"precision", names_of(precision_names)},
        {"interruption", names_of(interruption_names)},
        {"turned", names_of(turned_names)},
        {"inside", names_of(inside_names)},
        {"data", names_of(data_names)},
    }};
    return list;
}

Row row_of(const Values& v) {
    return {.place = place_names[v[0]].value,
            .phases = phases_names[v[1]].value,
            .motion = motion_names[v[2]].value,
            .told = told_names[v[3]].value,
            .sizes = sizes_names[v[4]].value,
            .topology = rule_names[v[5]].value,
            .integrator = scenes::integrator_choice_names[v[6]].value,
            .insertion = insertion_names[v[7]].value,
            .coarsening = coarsening_names[v[8]].value,
            .outline = outline_names[v[9]].value,
            .way = way_names[v[10]].value,
            .submeshes = submeshes_names[v[11]].value,
            .precision = precision_names[v[12]].value,
            .interruption = interruption_names[v[13]].value,
            .turned = turned_names[v[14]].value,
            .inside = inside_names[v[15]].value,
            .data = data_names[v[16]].value};
}

std::string words_of(const Values& values) {
    std::string words;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (values[i] != 0) {
            const Feature& feature = features()[i];
            words.append(words.empty() ? "" : " ").append(feature.name).append("=");
            words.append(feature.values[values[i]]);
        }
    }
    return words;
}

Values values_of(std::string_view words) {
    Values values{};
    std::istringstream stream{std::string(words)};
    for (std::string word; stream >> word;) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const auto feature = std::ranges::find(features(), name, &Feature::name);
        if (equals == std::string::npos || feature == features().end()) {
            std::vector<std::string_view> names;
            std::ranges::transform(features(), std::back_inserter(names), &Feature::name);
            refuse("no feature", word, "feature=value, with one of " + all_names(names));
        }
        const std::string value = word.substr(equals + 1);
        const auto at = std::ranges::find(feature->values, value);
        if (at == feature->values.end()) {
            refuse("no value of " + name, value, all_names(feature->values));
        }
        values[static_cast<std::size_t>(feature - features().begin())] =
            static_cast<std::uint8_t>(at - feature->values.begin());
    }
    return values;
}

} // namespace dsc::combinations
