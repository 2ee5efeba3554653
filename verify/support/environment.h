// SPDX-License-Identifier: MIT
// Environment variables that ask for longer or shorter tests.
#pragma once

#include <cstdlib>
#include <string_view>

namespace dsc::test {

/// Whether DSC_TESTS contains the word: `few` for fewer steps (under sanitizers); `long`; or
/// `record`, for tests that compare with a file.
inline bool are_asked_for(std::string_view word) {
    const char* asked = std::getenv("DSC_TESTS");
    return asked != nullptr && std::string_view(asked).find(word) != std::string_view::npos;
}

} // namespace dsc::test
