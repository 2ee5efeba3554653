// SPDX-License-Identifier: MIT
#include "scenes/machine.h"
#include "scenes/run.h"

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

Json jaggedness_json(const Jaggedness& j) {
    return {{"vertices", j.vertices},
            {"beyond", j.beyond},
            {"largest_turn_deg", finite(j.largest_turn_deg)},
            {"exact_turn_deg", finite(j.exact_turn_deg)},
            {"largest_excess_deg", finite(j.largest_excess_deg)},
            {"worst", {finite(j.worst.x()), finite(j.worst.y())}},
            {"rms_deg", finite(j.rms_deg)}};
}

// The measures of one moment, `when`: last or half. Null where there was no such moment.
void add_shape(const std::string& when, const std::optional<ShapeErrors>& errors,
               const RunResult& r, Json& json) {
    const auto add = [&](const char* name, auto value) {
        json[name + when] = errors ? Json(value(*errors)) : Json(nullptr);
    };
    add("area_", [](const ShapeErrors& e) { return finite(e.area); });
    add("area_exact_", [](const ShapeErrors& e) { return finite(e.area_exact); });
    add("area_drift_exact_",
        [](const ShapeErrors& e) { return finite(area_drift(e.area, e.area_exact)); });
    add("area_drift_first_",
        [&](const ShapeErrors& e) { return finite(area_drift(e.area, r.area_first)); });
    add("sd_", [](const ShapeErrors& e) { return finite(e.symmetric_difference); });
    add("sd_rel_",
        [&](const ShapeErrors& e) { return finite(e.symmetric_difference / r.area_exact_first); });
    add("hausdorff_", [](const ShapeErrors& e) { return finite(e.hausdorff); });
    add("perimeter_", [](const ShapeErrors& e) { return finite(e.perimeter); });
    add("jaggedness_", [](const ShapeErrors& e) { return jaggedness_json(e.jaggedness); });
    add("exact_shape_", [](const ShapeErrors& e) { return Json(e.exact_shape); });
    add("exact_error_", [](const ShapeErrors& e) { return finite(e.exact_error); });
}

} // namespace

std::string to_json(const RunResult& r) {
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(r.mesh_hash));
    Json parameters{{"h", r.parameters.h},
                    {"dt", r.parameters.dt},
                    {"steps", r.parameters.steps},
                    {"period", r.parameters.period},
                    {"integrator", std::string(to_string(r.parameters.integrator))},
                    {"tolerance", r.parameters.tolerance},
                    {"insertion", std::string(to_string(r.parameters.insertion))},
                    {"coarsening", std::string(to_string(r.parameters.interface.coarsening))},
                    {"reading", std::string(to_string(r.parameters.interface.reading))},
                    {"longest", r.parameters.interface.longest},
                    {"shortest", r.parameters.interface.shortest},
                    {"deviation", r.parameters.interface.deviation},
                    {"turn", r.parameters.interface.turn_degrees},
                    {"gap", r.parameters.interface.gap},
                    {"grading", r.parameters.interface.grading},
                    {"finest", r.parameters.interface.finest},
                    {"real", r.parameters.real == RealType::double_precision ? "double" : "float"},
                    {"seed", r.parameters.seed}};
    Json json{
        {"scene", r.scene},
        {"parameters", parameters},
        {"steps", r.steps},
        {"interrupted", r.interrupted},
        {"gave_up", r.gave_up.empty() ? Json(nullptr) : Json(r.gave_up)},
        {"triangles_first", r.triangles_first},
        {"triangles_last", r.triangles_last},
        {"interface_vertices_first", r.interface_vertices_first},
        {"interface_vertices_last", r.interface_vertices_last},
        {"area_first", finite(r.area_first)},
        {"area_exact_first", finite(r.area_exact_first)},
        {"area_ratio", finite(r.area_ratio)},
    };
    add_shape("last", r.last, r, json);
    add_shape("half", r.half, r, json);
    json.update({
        {"min_quality_last", finite(r.min_quality_last)},
        {"min_angle_deg_last", finite(r.min_angle_deg_last)},
        {"median_angle_deg_last", finite(r.median_angle_deg_last)},
        {"min_quality_ever", finite(r.min_quality_ever)},
        {"quality_sampled_every", r.quality_sampled_every},
        {"inverted", r.inverted},
        {"unreached", r.unreached},
        {"held", r.held},
        {"sub_steps", r.sub_steps},
        {"operations", r.operations},
        {"cpu_s", r.cpu_s},
        {"wall_s", r.wall_s},
        {"step_us_median", r.step_us_median},
        {"us_per_vertex_step", r.us_per_vertex_step},
        {"peak_memory_mb", r.peak_memory_mb},
        {"threads", r.threads},
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
