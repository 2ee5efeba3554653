// SPDX-License-Identifier: MIT
#include "measures/figures.h"

#include "dsc/base/error.h"

#include <algorithm>

namespace dsc::scenes {

double number(const Figures& figures, std::string_view name) {
    const std::string_view first = name.substr(0, name.find('.'));
    const auto found =
        std::ranges::find_if(figures, [&](const Figure& one) { return one.name == first; });
    if (found != figures.end()) {
        if (first.size() < name.size()) {
            if (const auto* parts = std::get_if<Figures>(&found->value)) {
                return number(*parts, name.substr(first.size() + 1));
            }
        } else if (const auto* real = std::get_if<double>(&found->value)) {
            return *real;
        }
    }
    std::string names;
    for (const Figure& figure : figures) {
        names += (names.empty() ? "" : ", ") + figure.name;
    }
    throw InputError({.what = "unknown figure",
                      .where = "figure",
                      .value = "'" + std::string(name) + "'",
                      .allowed = names});
}

} // namespace dsc::scenes
