// SPDX-License-Identifier: MIT
// Writes limits into the text of a suite and keeps everything else.
#pragma once

#include "propose.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dsc::gate {

/// The text of a suite with these limits. Throws InputError if a case shares its [[case]] with
/// another, and if the new text is not a suite.
[[nodiscard]] std::string with_limits(const std::string& text, const std::filesystem::path& path,
                                      const std::vector<Band>& bands);

} // namespace dsc::gate
