// SPDX-License-Identifier: MIT
// Small text files as a whole: scene files and what they name, and results, which are written
// completely or not at all: to a temporary file, which is then renamed.
#pragma once

#include <filesystem>
#include <string>

namespace dsc::scenes {

inline constexpr std::uintmax_t largest_text_file = 64'000'000; ///< bytes

/// Throws FileError for what is not a readable regular file (a folder, a pipe, a device), or is
/// larger than that.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);
/// Throws InputError, naming the option `where`, if a file cannot be created at this path: called
/// before a run begins.
void check_writable(const std::string& path, const std::string& where);
/// Throws FileError if the disk is full or the folder does not allow writing.
void write_file(const std::string& path, const std::string& content);

} // namespace dsc::scenes
