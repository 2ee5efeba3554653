// SPDX-License-Identifier: MIT
// Result files are written completely or not at all: to a temporary file, which is then renamed.
#pragma once

#include <string>

namespace dsc::scenes {

/// Throws InputError, naming the option `where`, if a file cannot be created at this path: called
/// before a run begins.
void check_writable(const std::string& path, const std::string& where);
/// Throws FileError if the disk is full or the folder does not allow writing.
void write_file(const std::string& path, const std::string& content);

} // namespace dsc::scenes
