// SPDX-License-Identifier: MIT
// The place where a limit is broken: the worst element, its picture, and the command that
// reproduces it.
#pragma once

#include "judge.h"

#include <filesystem>

namespace dsc::gate {

/// Repeats the run of a row, which is bitwise identical, and finds its culprit. Writes a picture of
/// the place to the folder, and the log of edits if triangles are inverted or the run gave up. A
/// figure of the whole mesh has no place, and for runs in float and of the reference only the
/// command is known. Throws the exceptions of the run, and FileError.
[[nodiscard]] Place find_place(const Row& row, const Runs& runs,
                               const std::filesystem::path& folder);

} // namespace dsc::gate
