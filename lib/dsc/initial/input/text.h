// SPDX-License-Identifier: MIT
// Numbers in messages: the shortest digits that read back as the same number.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <charconv>
#include <string>

namespace dsc::initial {

inline std::string text(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

inline std::string text(const Point<double>& point) {
    std::string words(1, '('); // GCC 12 warns of "(" + a temporary string (its bug 105651)
    words += text(point.x());
    words += ", ";
    words += text(point.y());
    words += ')';
    return words;
}

} // namespace dsc::initial
