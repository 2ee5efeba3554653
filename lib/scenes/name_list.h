// SPDX-License-Identifier: MIT
// What is allowed, as errors list it.
#pragma once

#include <functional>
#include <string>

namespace dsc::scenes {

/// The names of all elements of a range with commas between them: "h, dt, steps".
template <class Range, class Name = std::identity>
[[nodiscard]] std::string name_list(const Range& all, Name name_of = {}) {
    std::string names;
    for (const auto& one : all) {
        names += (names.empty() ? "" : ", ") + std::string(std::invoke(name_of, one));
    }
    return names;
}

} // namespace dsc::scenes
