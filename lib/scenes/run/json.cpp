// SPDX-License-Identifier: MIT
#include "scenes/run/json.h"

#include "scenes/output/machine.h"
#include "scenes/run/run.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace dsc::scenes {

namespace {

using Json = nlohmann::ordered_json;

Json histogram_json(const Histogram& histogram) {
    return {{"edges", histogram.edges}, {"counts", histogram.counts}};
}

// JSON has no NaN: what could not be measured is null.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Value& value);

struct ValueToJson {
    Json operator()(double number) const { return finite(number); }
    Json operator()(const Point<double>& p) const { return {finite(p.x()), finite(p.y())}; }
    Json operator()(const Figures& parts) const {
        Json json = Json::object();
        for (const Figure& part : parts) {
            json[part.name] = to_json(part.value);
        }
        return json;
    }
    template <class Other>
    Json operator()(const Other& other) const {
        return other;
    }
};

Json to_json(const Value& value) { return std::visit(ValueToJson{}, value); }

// The measures of both moments. Null if there was no such moment.
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
                        {"area", finite(one.area)},
                        {"perimeter", finite(one.perimeter)},
                        {"wall", finite(one.wall)},
                        {"components", one.components},
                        {"holes", one.holes}});
    }
    return list;
}

Json pairs_json(const PhaseReport& report) {
    Json list = Json::array();
    for (const PairFigures& pair : report.pairs) {
        list.push_back(
            {{"phases", Json::array({pair.one, pair.other})}, {"length", finite(pair.length)}});
    }
    return list;
}

Json parameters_json(const Parameters& parameters) {
    Json json;
    for (const Key& key : parameter_keys()) {
        json[key.name] =
            std::visit([](const auto& value) { return Json(value); }, key.value(parameters));
    }
    return json;
}

// Count and area of each kind that happened.
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
        {"interrupted", r.interrupted},
        {"partial", r.is_partial()},
        {"gave_up", r.gave_up.empty() ? Json(nullptr) : Json(r.gave_up)},
        {"triangles_first", r.triangles_first},
        {"triangles_last", r.triangles_last},
        {"interface_vertices_first", r.interface_vertices_first},
        {"interface_vertices_last", r.interface_vertices_last},
        {"area_first", finite(r.area_first)},
        {"area_exact_first", finite(r.area_exact_first)},
        {"area_ratio", finite(r.area_ratio)},
    };
    add_figures(r, json);
    for (const Figure& figure : r.fluid) {
        json[figure.name] = to_json(figure.value);
    }
    json["attribute_error_last"] = finite(r.attribute_error);
    json.update({
        {"phases", phases_json(r.phases)},
        {"pairs", pairs_json(r.phases)},
        {"junctions_last", r.junctions.count},
        {"junction_crossings", r.junctions.crossings},
        {"junction_angle_min_deg", finite(r.junctions.min_deg)},
        {"junction_angle_max_deg", finite(r.junctions.max_deg)},
        {"junction_deviation_median_deg", finite(r.junctions.median_deviation_deg)},
        {"junction_deviation_worst_deg", finite(r.junctions.worst_deviation_deg)},
        {"min_quality_ever", finite(r.min_quality_ever)},
        {"quality_sampled_every", r.quality_sampled_every},
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
        {"us_per_vertex_step", r.us_per_vertex_step},
        {"peak_memory_mb", r.peak_memory_mb},
        {"threads", r.threads},
        {"threads_used", r.threads_used},
        {"utilisation", finite(r.utilisation())},
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
    return json.dump(2) + "\n";
}

} // namespace dsc::scenes
