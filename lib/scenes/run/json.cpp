// SPDX-License-Identifier: MIT
#include "scenes/run/json.h"

#include "scenes/output/machine.h"
#include "scenes/run/run.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace dsc::scenes {

namespace {

using Json = nlohmann::ordered_json;

Json histogram_json(const Histogram& histogram) {
    return {{"edges", histogram.edges}, {"counts", histogram.counts}};
}

Json to_json(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return *number;
    }
    Json json = Json::object();
    for (const Figure& part : std::get<Figures>(value)) {
        json[part.name] = to_json(part.value);
    }
    return json;
}

// The measures at the end and half-way; null if there is no half-way time.
void add_figures(const RunResult& r, Json& json) {
    for (const Figure& figure : r.last) {
        json[figure.name + "_last"] = to_json(figure.value);
    }
    for (std::size_t i = 0; i < r.last.size(); ++i) {
        json[r.last[i].name + "_half"] = r.half ? to_json((*r.half)[i].value) : Json(nullptr);
    }
}

Json phases_json(const PhaseReport& report) {
    Json list = Json::array();
    for (const PhaseFigures& one : report.phases) {
        list.push_back({{"phase", one.phase},
                        {"area", one.area},
                        {"perimeter", one.perimeter},
                        {"boundary", one.boundary},
                        {"components", one.components},
                        {"holes", one.holes}});
    }
    return list;
}

Json input_json(const InputReport& input) {
    return {{"points", input.points},       {"thinned", input.thinned},
            {"deviation", input.deviation}, {"area_changed", input.area_changed},
            {"dropped", input.dropped},     {"area_dropped", input.area_dropped},
            {"clipped", input.clipped}};
}

Json parameters_json(const Parameters& parameters) {
    Json json;
    for (const Key& key : parameter_keys()) {
        json[key.name] =
            std::visit([](const auto& value) { return Json(value); }, key.value(parameters));
    }
    return json;
}

// Number and area of the events of each kind.
Json events_json(const std::vector<Event>& events) {
    Json json = Json::object();
    for (const auto& [kind, name] : event_names) {
        std::uint64_t count = 0;
        double area = 0;
        for (const Event& event : events) {
            if (event.kind == kind) {
                ++count;
                area += event.area;
            }
        }
        if (count > 0) {
            json[std::string(name)] = {{"count", count}, {"area", area}};
        }
    }
    return json;
}

} // namespace

std::string to_json(const RunResult& r) {
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(r.mesh_hash));
    Json json{
        {"scene", r.scene},
        {"parameters", parameters_json(r.parameters)},
        {"steps", r.steps},
        {"partial", r.is_partial()},
        {"gave_up", r.gave_up.empty() ? Json(nullptr) : Json(r.gave_up)},
        {"input", input_json(r.input)},
        {"triangles_first", r.triangles_first},
        {"triangles_last", r.triangles_last},
        {"interface_vertices_last", r.interface_vertices_last},
        {"area_first", r.area_first},
        {"area_ratio", r.area_ratio},
    };
    add_figures(r, json);
    for (const Figure& figure : r.fluid) {
        json[figure.name] = to_json(figure.value);
    }
    for (const Figure& figure : r.diagram) {
        json[figure.name] = to_json(figure.value);
    }
    json["attribute_error_last"] = r.attribute_error;
    json.update({
        {"phases", phases_json(r.phases)},
        {"junctions_last", r.junctions.count},
        {"min_quality_ever", r.min_quality_ever},
        {"inverted", r.inverted},
        {"unreached", r.unreached},
        {"held", r.held},
        {"sub_steps", r.sub_steps},
        {"operations", r.operations},
        {"events", events_json(r.events)},
        {"area_given_back", r.area.given_back},
        {"area_owed", r.area.owed},
        {"cpu_s", r.cpu_s},
        {"wall_s", r.wall_s},
        {"run_s", r.wall_s}, // all steps, the first included
        {"first_step_us", r.first_step_us},
        {"step_us_median", r.step_us_median},
        {"peak_memory_mb", r.peak_memory_mb},
        {"threads", r.threads},
        {"threads_used", r.threads_used},
        {"submeshes", r.submeshes},
        {"strategy", to_string(r.strategy)},
        {"mesh_hash", hash},
        {"commit", commit()},
        {"machine", machine()},
        {"histograms",
         {{"area", histogram_json(r.area_histogram)},
          {"quality", histogram_json(r.quality_histogram)},
          {"angle", histogram_json(r.angle_histogram)}}},
    });
    return json.dump(2) + "\n"; // NaN and infinity become null
}

std::string events_to_json_lines(std::span<const Event> events) {
    std::string lines;
    for (const Event& event : events) {
        const Json json{{"kind", to_string(event.kind)},
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
