// SPDX-License-Identifier: MIT
// Reads and writes small text files (scene files, files that they name, and results), and checks
// all files that a program will write before it begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dsc::scenes {

inline constexpr std::uintmax_t largest_text_file = 64'000'000; ///< bytes

/// Throws FileError if the path is not a readable regular file (but a folder, a pipe, a device), or
/// the file is larger than `largest_text_file`.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

/// A file that a program reads or writes, and the option that names it.
struct NamedFile {
    std::string option;
    std::string path;
};

/// Called before a run begins. Throws InputError for an output that cannot be written, or that is
/// the same file as another output, one of the `others`, or the target of a standard stream.
/// Devices and pipes may be named more than once.
void check_outputs(const std::vector<NamedFile>& outputs, std::vector<NamedFile> others = {});

/// Throws FileError if the disk is full or the folder does not allow writing.
void write_file(const std::string& path, const std::string& content);

} // namespace dsc::scenes
