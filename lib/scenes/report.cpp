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
        {"area_last", finite(r.area_last)},
        {"area_exact_first", finite(r.area_exact_first)},
        {"area_exact_last", finite(r.area_exact_last)},
        {"area_ratio", finite(r.area_ratio)},
        {"sd_rel_last", finite(r.sd_rel_last)},
        {"sd_rel_half", r.sd_rel_half ? finite(*r.sd_rel_half) : Json(nullptr)},
        {"hausdorff_last", finite(r.hausdorff_last)},
        {"exact_shape", r.exact_shape},
        {"exact_error_rel", finite(r.exact_error_rel)},
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
    };
    return json.dump(2) + "\n";
}

} // namespace dsc::scenes
