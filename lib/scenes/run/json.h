// SPDX-License-Identifier: MIT
// The result of a run as JSON, for plots, tables and other programs.
#pragma once

#include "topology/events.h"

#include <span>
#include <string>

namespace dsc::scenes {

struct RunResult;

/// One object, with a trailing newline. The value of each measure is stored as NAME_last and
/// NAME_half, null if there is no half-way time or it could not be measured. Reports on phases and
/// junctions are those at the end.
[[nodiscard]] std::string to_json(const RunResult& result);

/// The changes of topology, one JSON object per line: kind, time, place, phases, area.
[[nodiscard]] std::string events_to_json_lines(std::span<const Event> events);

} // namespace dsc::scenes
