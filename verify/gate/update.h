// SPDX-License-Identifier: MIT
// Writes limits into the text of a suite and keeps everything else.
#pragma once

#include "propose.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dsc::gate {

/// Throws InputError if one of the cases shares its [[case]] with another.
void check_writable(const std::vector<Wanted>& limits, const std::filesystem::path& path);

/// The text of a suite with these limits, of cases that have their own [[case]]. Throws InputError
/// if the new text is not a suite.
[[nodiscard]] std::string with_limits(const std::string& text, const std::filesystem::path& path,
                                      const std::vector<Band>& bands);

} // namespace dsc::gate
