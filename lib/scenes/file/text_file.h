// SPDX-License-Identifier: MIT
// Small text files as a whole: scene files and what they name.
#pragma once

#include <filesystem>
#include <string>

namespace dsc::scenes {

inline constexpr std::uintmax_t largest_text_file = 64'000'000; ///< bytes

/// Throws FileError for what is not a readable regular file (a folder, a pipe, a device), or is
/// larger than that.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

} // namespace dsc::scenes
