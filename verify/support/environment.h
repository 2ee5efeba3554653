// SPDX-License-Identifier: MIT
// Where the environment asks a test for more or for less than it does by itself.
#pragma once

#include <cstdlib>
#include <string_view>

namespace dsc::test {

/// Whether the words of DSC_TESTS say so: `few`, where each takes long (under sanitizers); `long`;
/// or `record`, of tests that compare with a file.
inline bool are_asked_for(std::string_view word) {
    const char* asked = std::getenv("DSC_TESTS");
    return asked != nullptr && std::string_view(asked).find(word) != std::string_view::npos;
}

} // namespace dsc::test
