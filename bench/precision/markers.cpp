// SPDX-License-Identifier: MIT
#include "markers.h"

#include "measures/symmetric_difference.h"
#include "reference/algorithm/bare_markers.h"
#include "scenes/run/clock.h"

namespace dsc::bench {

MarkerResult run_markers(const scenes::Setup& setup, double h, const BareMarkers& options) {
    const reference::MarkerOptions spacing{.longest = h,
                                           .shortest = options.shortest_over_h * h,
                                           .insertion = options.cubic ? &reference::lagrange_point
                                                                      : &reference::linear_point};
    reference::Markers markers = setup.outlines.front();
    const auto shape = [&] { return reference::read_as_cubic(markers, options.parts); };
    const double first_area = scenes::signed_area(shape());
    const double exact_first_area = setup.exact(0.0).area;
    const auto error_at = [&](double time) {
        const scenes::Outline outline = shape();
        return scenes::symmetric_difference({&outline, 1}, setup.exact(time).outlines) /
               exact_first_area;
    };

    MarkerResult result;
    result.markers_first = markers.size();
    for (int step = 1; step <= setup.steps; ++step) {
        const double begin = (step - 1) * setup.dt;
        const double end = step * setup.dt;
        const scenes::Stopwatch watch;
        reference::move_markers(markers, scenes::velocity_of_step(setup.flow, begin, end), begin,
                                setup.dt);
        const reference::MarkerCounts counts = reference::space_markers(markers, spacing);
        result.cpu_s += watch.cpu();
        result.inserted += counts.inserted;
        result.removed += counts.removed;
        if (setup.half_step == step) {
            result.sd_rel_half = error_at(end);
        }
    }
    result.markers_last = markers.size();
    result.area_ratio = scenes::signed_area(shape()) / first_area;
    result.sd_rel_last = error_at(setup.steps * setup.dt);
    return result;
}

nlohmann::ordered_json to_json(const MarkerResult& result) {
    nlohmann::ordered_json json{{"interface_vertices_first", result.markers_first},
                                {"interface_vertices_last", result.markers_last},
                                {"triangles_last", 0},
                                {"inserted_markers", result.inserted},
                                {"removed_markers", result.removed},
                                {"area_ratio", result.area_ratio},
                                {"sd_rel_last", result.sd_rel_last},
                                {"sd_rel_half", nullptr},
                                {"cpu_s", result.cpu_s}};
    if (result.sd_rel_half) {
        json["sd_rel_half"] = *result.sd_rel_half;
    }
    return json;
}

} // namespace dsc::bench
