// SPDX-License-Identifier: MIT
// Changes of the topology as a file: one JSON object a line.
#pragma once

#include "topology/events.h"

#include <span>
#include <string>

namespace dsc::scenes {

/// The changes of topology, one JSON object a line: kind, time, place, phases, area.
[[nodiscard]] std::string events_to_json_lines(std::span<const Event> events);

} // namespace dsc::scenes
