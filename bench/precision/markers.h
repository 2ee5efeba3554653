// SPDX-License-Identifier: MIT
// Carries a polygon of markers through a scene and measures it like a mesh.
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
    double area_ratio = 0;             ///< of the polygon's or the curve's last to its first area
    double sd_rel_last = 0;            ///< over the exact first area, as in RunResult
    std::optional<double> sd_rel_half; ///< of a reversing flow
    double cpu_s = 0;                  ///< of all steps, without measuring
};

/// From a scene's single first outline, by its steps; h is the longest edge.
[[nodiscard]] MarkerResult run_markers(const scenes::Setup& setup, double h,
                                       const BareMarkers& options);

/// Under the names of dsc_scene's JSON, as far as they apply.
[[nodiscard]] nlohmann::ordered_json to_json(const MarkerResult& result);

} // namespace dsc::bench
