// SPDX-License-Identifier: MIT
#include "scenes/output/outlines_file.h"

#include "dsc/queries/phases.h"
#include "shapes/outline.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace dsc::scenes {

namespace {

nlohmann::ordered_json positions_of(const Outline& ring) {
    auto list = nlohmann::ordered_json::array();
    for (const Point<double>& p : ring) {
        list.push_back({p.x(), p.y()});
    }
    list.push_back(list.front());
    return list;
}

} // namespace

template <class Real>
std::string outlines_to_geojson(const Complex<Real>& complex) {
    using Json = nlohmann::ordered_json;
    const Components parts = components(complex);
    std::vector<std::vector<Outline>> rings(parts.list.size());
    for_each_outline(complex, [&](std::span<const Corner> corners) {
        Outline ring;
        for (const Corner c : corners) {
            ring.push_back(
                complex.position(Vertex{complex.vertex(next(c))}).template cast<double>());
        }
        rings[parts.of[triangle_of(corners.front())]].push_back(std::move(ring));
    });
    Json features = Json::array();
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (parts.list[i].phase == exterior_phase) {
            continue;
        }
        // The one around the component, which encloses it; holes are negative.
        const auto outer = std::ranges::max_element(
            rings[i], {}, [](const Outline& ring) { return signed_area(ring); });
        std::iter_swap(rings[i].begin(), outer);
        Json lines = Json::array();
        for (const Outline& ring : rings[i]) {
            lines.push_back(positions_of(ring));
        }
        features.push_back(
            {{"type", "Feature"},
             {"properties", {{"phase", parts.list[i].phase}, {"area", parts.list[i].area}}},
             {"geometry", {{"type", "Polygon"}, {"coordinates", std::move(lines)}}}});
    }
    return Json{{"type", "FeatureCollection"}, {"features", std::move(features)}}.dump() + "\n";
}

template std::string outlines_to_geojson(const Complex<double>&);
template std::string outlines_to_geojson(const Complex<float>&);

} // namespace dsc::scenes
