// SPDX-License-Identifier: MIT
// Numbers in files and sentences.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace dsc::scenes {

/// The shortest digits that read back as the same number; "nan" and "inf" otherwise.
[[nodiscard]] inline std::string shortest_digits(double value) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), end};
}

} // namespace dsc::scenes
