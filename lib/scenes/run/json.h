// SPDX-License-Identifier: MIT
// A run's result as the file that plots, tables and other programs read.
#pragma once

#include <string>

namespace dsc::scenes {

struct RunResult;

/// One object, with a trailing newline. The value of each measure is there as NAME_last and
/// NAME_half, null where there was no such moment or it could not be measured.
[[nodiscard]] std::string to_json(const RunResult& result);

} // namespace dsc::scenes
