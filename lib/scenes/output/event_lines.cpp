// SPDX-License-Identifier: MIT
#include "scenes/output/event_lines.h"

#include <nlohmann/json.hpp>

namespace dsc::scenes {

std::string events_to_json_lines(std::span<const Event> events) {
    std::string lines;
    for (const Event& event : events) {
        const nlohmann::ordered_json json{{"kind", to_string(event.kind)},
                                          {"time", event.time},
                                          {"x", event.x},
                                          {"y", event.y},
                                          {"lost", event.lost},
                                          {"taken", event.taken},
                                          {"area", event.area}};
        lines += json.dump() + "\n";
    }
    return lines;
}

} // namespace dsc::scenes
