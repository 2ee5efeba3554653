// SPDX-License-Identifier: MIT
// Result files are there whole or not at all: written beside, then renamed.
#pragma once

#include <string>

namespace dsc::scenes {

/// Throws InputError, naming the option `where`, if a file cannot be made at this path: asked
/// before a run begins.
void check_writable(const std::string& path, const std::string& where);
/// Throws FileError where the disk is full or the folder refuses.
void write_file(const std::string& path, const std::string& content);

} // namespace dsc::scenes
