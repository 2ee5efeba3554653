// SPDX-License-Identifier: MIT
#include "combinations/row.h"

#include "support/enumerators.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <bit>
#include <sstream>

namespace dsc::combinations {

using test::identifiers;

const std::vector<Feature>& features() {
    static const std::vector<Feature> list{
        {"place", identifiers<Place>()},
        {"phases", identifiers<Phases>()},
        {"motion", identifiers<Motion>()},
        {"told", identifiers<Told>()},
        {"sizes", identifiers<Sizes>()},
        {"topology", identifiers<Rule>()},
        {"integrator", identifiers<scenes::IntegratorChoice>()},
        {"insertion", identifiers<Insertion>()},
        {"coarsening", identifiers<Coarsening>()},
        {"outline", identifiers<Outline>()},
        {"way", identifiers<Way>()},
        {"submeshes", identifiers<Submeshes>()},
        {"precision", identifiers<Precision>()},
        {"interruption", identifiers<Interruption>()},
        {"turned", identifiers<Turned>()},
        {"inside", identifiers<Inside>()},
    };
    return list;
}

Row row_of(const Values& values) { return std::bit_cast<Row>(values); }

std::string words_of(const Values& values) {
    std::string words;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != 0) {
            words += words.empty() ? "" : " ";
            words.append(features()[i].name).append("=").append(features()[i].values[values[i]]);
        }
    }
    return words;
}

Values values_of(const std::string& words) {
    Values values{};
    std::istringstream stream(words);
    for (std::string word; stream >> word;) {
        const std::size_t equals = std::min(word.find('='), word.size() - 1);
        const auto feature = std::ranges::find(features(), word.substr(0, equals), &Feature::name);
        const bool is_known = feature != features().end();
        const auto& names = is_known ? feature->values : std::vector<std::string_view>{};
        const auto value = std::ranges::find(names, word.substr(equals + 1));
        if (value == names.end()) {
            throw InputError({.what = is_known ? "unknown value of a feature" : "unknown feature",
                              .where = "row",
                              .value = word,
                              .allowed = "feature=value, as the enums of row.h call them"});
        }
        values[static_cast<std::size_t>(feature - features().begin())] =
            static_cast<std::uint8_t>(value - names.begin());
    }
    return values;
}

} // namespace dsc::combinations
