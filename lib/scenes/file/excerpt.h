// SPDX-License-Identifier: MIT
// Quotations of input in error messages, and lists of allowed values.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>

namespace dsc::scenes {

inline constexpr std::size_t longest_excerpt = 60; ///< characters

/// The beginning of the text on one line without control characters, which could affect a terminal:
/// an error is one sentence on one line.
[[nodiscard]] inline std::string excerpt(std::string_view text) {
    std::string line(text.substr(0, longest_excerpt));
    std::ranges::replace_if(
        line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return text.size() > longest_excerpt ? line + "..." : line;
}

/// In single quotes. GCC 12 warns of "'" + a temporary string (its bug 105651).
[[nodiscard]] inline std::string in_single_quotes(std::string_view text) {
    std::string quoted(1, '\'');
    quoted += text;
    quoted += '\'';
    return quoted;
}

/// The beginning of the text on one line, in quotes.
[[nodiscard]] inline std::string quoted_excerpt(std::string_view text) {
    return in_single_quotes(excerpt(text));
}

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
