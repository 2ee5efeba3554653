// SPDX-License-Identifier: MIT
#include "scenes/catalogue/catalogue.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/families.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <cmath>

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

Setup scheduled(const Parameters& p, double duration, double default_dt) {
    Setup setup;
    setup.dt = p.dt > 0 ? p.dt : (p.steps > 0 ? duration / p.steps : default_dt);
    setup.steps = p.steps;
    if (setup.steps == 0) {
        const double count = std::max(1.0, std::round(duration / setup.dt));
        require(count <= 1e8, "--set dt", setup.dt,
                "at most 100000000 steps for a duration of " + to_text(duration));
        setup.steps = static_cast<int>(count);
        if (p.dt <= 0) {
            setup.dt =
                duration / setup.steps; // so that a whole number of steps ends with the scene
        }
    }
    return setup;
}

} // namespace dsc::scenes
