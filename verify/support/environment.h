// SPDX-License-Identifier: MIT
// Where the environment asks a test for more or for less than it does by itself.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace dsc::test {

/// The number in an environment variable, or `otherwise` where it is not set.
inline std::uint64_t from_environment(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

} // namespace dsc::test
