// SPDX-License-Identifier: MIT
// Where a limit is broken: the element that is to blame, a picture of it, and how to see it again.
#pragma once

#include "judge.h"

#include <filesystem>

namespace dsc::gate {

/// Makes the run of a row once more, which ends with the same bits, and looks for its culprit.
/// Writes a picture of the place into the folder, and the log of edits where triangles are inverted
/// or the run gave up. A figure of the mesh as a whole has no place, and of runs in float and of
/// the reference only the command is known. Throws what the run throws; FileError.
[[nodiscard]] Place find_place(const Row& row, const Runs& runs,
                               const std::filesystem::path& folder);

} // namespace dsc::gate
