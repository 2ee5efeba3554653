// SPDX-License-Identifier: MIT
// A run's result as files that are read by plots, tables and other programs.
#pragma once

#include "topology/events.h"

#include <span>
#include <string>

namespace dsc::scenes {

struct RunResult;

/// One object, with a trailing newline. The value of each measure is stored as NAME_last and
/// NAME_half, null if there was no such moment or it could not be measured. What is said of phases
/// and of junctions is that of the last moment.
[[nodiscard]] std::string to_json(const RunResult& result);

/// The changes of topology, one JSON object a line: kind, time, place, phases, area.
[[nodiscard]] std::string events_to_json_lines(std::span<const Event> events);

} // namespace dsc::scenes
