// SPDX-License-Identifier: MIT
// Checks of options, for the functions that receive them, and numbers in messages.
#pragma once

#include "dsc/base/error.h"
#include "dsc/base/types.h"

#include <array>
#include <charconv>
#include <string_view>

namespace dsc {

/// The shortest digits that read back as the same number.
template <class Number>
[[nodiscard]] std::string to_text(Number value) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

/// The coordinates in brackets.
template <class Real>
[[nodiscard]] std::string to_text(const Point<Real>& point) {
    std::string words(1, '('); // GCC 12 warns of "(" + a temporary string (its bug 105651)
    words += to_text(point.x());
    words += ", ";
    words += to_text(point.y());
    words += ')';
    return words;
}

/// Throws InputError if `good` is false for this value of the option `name`.
inline void require(bool good, std::string_view name, double value, std::string_view allowed) {
    if (!good) {
        throw InputError({.what = "value out of range",
                          .where = std::string(name),
                          .value = to_text(value),
                          .allowed = std::string(allowed)});
    }
}

} // namespace dsc
