// SPDX-License-Identifier: MIT
// A run's result as the file that is read by plots, tables and other programs.
#pragma once

#include <string>

namespace dsc::scenes {

struct RunResult;

/// One object, with a trailing newline. The value of each measure is stored as NAME_last and
/// NAME_half, null if there was no such moment or it could not be measured. What is said of phases
/// (`phases`, `pairs`: of phases that meet) and of junctions is that of the last moment; angles are
/// null where there is no junction.
[[nodiscard]] std::string to_json(const RunResult& result);

} // namespace dsc::scenes
