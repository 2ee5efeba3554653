// SPDX-License-Identifier: MIT
#include "scenes/output/submesh_map.h"

#include "scenes/output/write_file.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace dsc::scenes {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string kind_of(const Region& region) {
    switch (region.kind) {
    case Region::Kind::whole: return "whole";
    case Region::Kind::box:
    case Region::Kind::upright: return "box";
    case Region::Kind::places: return "places";
    case Region::Kind::labels: return "labels";
    }
    return "unknown";
}

} // namespace

void write_submesh_map(const SubmeshView& submeshes, const std::string& path) {
    std::vector<double> work;
    for (const SubStepProfile& profile : submeshes.profile) {
        work.resize(std::max(work.size(), profile.move.size()), 0.0);
        for (std::size_t i = 0; i < profile.move.size(); ++i) {
            work[i] += profile.move[i] + (i < profile.aim.size() ? profile.aim[i] : 0.0);
        }
    }
    Json colours = Json::array();
    std::size_t number_of = 0;
    for (const Colour& colour : submeshes.partition.colours) {
        Json regions = Json::array();
        for (const Region& region : colour.regions) {
            const double seconds = number_of < work.size() ? work[number_of] : 0.0;
            ++number_of;
            regions.push_back({{"kind", kind_of(region)},
                               {"normal", {region.normal_x, region.normal_y}},
                               {"low", number(region.low)},
                               {"high", number(region.high)},
                               {"side_low", number(region.side_low)},
                               {"side_high", number(region.side_high)},
                               {"work_us", seconds * 1e6}});
        }
        colours.push_back({{"regions", std::move(regions)}});
    }
    write_file(path, Json{{"colours", std::move(colours)}}.dump(1) + "\n");
}

} // namespace dsc::scenes
