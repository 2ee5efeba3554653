// SPDX-License-Identifier: MIT
// Advects a polygon of markers in the flow of a scene and measures it like a mesh.
#pragma once

#include "methods.h"
#include "scenes/scene.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace dsc::bench {

struct MarkerResult {
    std::size_t markers_first = 0;
    std::size_t markers_last = 0;
    std::size_t inserted = 0;
    std::size_t removed = 0;
    double area_ratio = 0;             ///< last over first area of the polygon or the curve
    double sd_rel_last = 0;            ///< relative to the exact first area, as in RunResult
    std::optional<double> sd_rel_half; ///< if the flow turns back
    double cpu_s = 0;                  ///< of all steps, without measuring
};

/// Starts from the only outline of a scene and makes the scene's steps; h is the longest edge.
[[nodiscard]] MarkerResult run_markers(const scenes::Setup& setup, double h,
                                       const BareMarkers& options);

/// The result with the names of dsc_scene's JSON, as far as they apply.
[[nodiscard]] nlohmann::ordered_json to_json(const MarkerResult& result);

} // namespace dsc::bench
