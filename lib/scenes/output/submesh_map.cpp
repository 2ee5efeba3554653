// SPDX-License-Identifier: MIT
#include "scenes/output/submesh_map.h"

#include "dsc/parallel/submesh_view.h"
#include "scenes/file/text_file.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace dsc::scenes {

void write_submesh_map(const SubmeshView& submeshes, const std::string& path) {
    using Json = nlohmann::ordered_json;
    std::vector<double> work;
    for (const SubStepProfile& profile : submeshes.profile) {
        work.resize(std::max(work.size(), profile.move.size()), 0.0);
        for (std::size_t i = 0; i < profile.move.size(); ++i) {
            work[i] += profile.move[i] + (i < profile.targets.size() ? profile.targets[i] : 0.0);
        }
    }
    Json colours = Json::array();
    std::size_t number_of = 0;
    for (const Colour& colour : submeshes.partition.colours) {
        Json regions = Json::array();
        for (const Region& region : colour.regions) {
            const double seconds = number_of < work.size() ? work[number_of] : 0.0;
            ++number_of;
            regions.push_back({{"kind", region.kind == Region::Kind::whole ? "whole" : "box"},
                               {"normal", {region.normal_x, region.normal_y}},
                               {"low", region.low},
                               {"high", region.high},
                               {"side_low", region.side_low},
                               {"side_high", region.side_high},
                               {"work_us", seconds * 1e6}});
        }
        colours.push_back({{"regions", std::move(regions)}});
    }
    write_file(path, Json{{"colours", std::move(colours)}}.dump(1) + "\n"); // null: infinite
}

} // namespace dsc::scenes
