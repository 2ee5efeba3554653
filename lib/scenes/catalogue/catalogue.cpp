// SPDX-License-Identifier: MIT
#include "scenes/catalogue/catalogue.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/families.h"
#include "scenes/name_list.h"

#include <algorithm>

namespace dsc::scenes {

const std::vector<Scene>& catalogue() {
    static const std::vector<Scene> scenes = [] {
        std::vector<Scene> all;
        for (const auto family : {
                 translation_scenes,
                 scaling_scenes,
                 rotation_scenes,
                 vortex_scenes,
                 interpolation_scenes,
                 zalesak_scenes,
                 swirl_scenes,
                 speedup_scenes,
                 quality_scenes,
                 curvature_scenes,
                 growth_scenes,
                 network_scenes,
                 pool_scenes,
                 fluid_scenes,
             }) {
            for (Scene& scene : family()) {
                all.push_back(std::move(scene));
            }
        }
        return all;
    }();
    return scenes;
}

const Scene& find_scene(const std::string& name, const std::vector<Scene>& scenes) {
    const auto found = std::ranges::find(scenes, name, &Scene::name);
    if (found == scenes.end()) {
        throw InputError({.what = "unknown scene",
                          .where = "run",
                          .value = "'" + name + "'",
                          .allowed = name_list(scenes, &Scene::name)});
    }
    return *found;
}

InterfaceThresholds coarse_interface() {
    return {.longest = 1.4, .shortest = 0.45, .deviation = 0.02};
}

} // namespace dsc::scenes
