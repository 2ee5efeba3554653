// SPDX-License-Identifier: MIT
// Where the environment asks a test for more or for less than it does by itself.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace dsc::test {

/// Whether DSC_TESTS says so: `few`, where each takes long (under sanitizers), or `long`.
inline bool are_asked_for(std::string_view extent) {
    const char* asked = std::getenv("DSC_TESTS");
    return asked != nullptr && asked == extent;
}

/// The number in an environment variable, or `otherwise` where it is not set.
inline std::uint64_t from_environment(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

} // namespace dsc::test
