// SPDX-License-Identifier: MIT
// Limits written into the text of a suite, in which everything else stays as it is.
#pragma once

#include "propose.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dsc::gate {

/// The text of a suite with these limits. Throws InputError if a case shares its [[case]] with
/// another, and if the new text is no suite.
[[nodiscard]] std::string with_limits(const std::string& text, const std::filesystem::path& path,
                                      const std::vector<Band>& bands);

} // namespace dsc::gate
