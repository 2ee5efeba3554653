// SPDX-License-Identifier: MIT
#include "runs.h"

#include "scenes/catalogue/catalogue.h"

namespace dsc::gate {

namespace {

// Small enough for a method that sweeps over sets in each step, and large enough for some hundred
// triangles inside and outside the shape.
scenes::Parameters coarse(const scenes::Scene& scene) {
    scenes::Parameters parameters = scene.defaults;
    parameters.h = 0.05;
    parameters.interface = scenes::coarse_interface(); // as long as the reference's
    if (scene.name == "single-vortex") {
        // The filament of a longer period is thinner than the mesh.
        parameters.period = 2;
    }
    return parameters;
}

} // namespace

const scenes::RunResult& Runs::get(const Configuration& configuration) {
    const auto found = runs_.find(configuration);
    if (found != runs_.end()) {
        return found->second;
    }
    const scenes::Scene& scene = scenes::find_scene(configuration.scene);
    scenes::RunOptions options;
    options.strategy = configuration.strategy;
    options.submeshing.threads = configuration.threads;
    options.measure_shape = configuration.measure_shape;
    scenes::Parameters parameters =
        configuration.size == Size::full ? scene.defaults : coarse(scene);
    for (const std::string& setting : configuration.settings) {
        scenes::apply_setting(parameters, scene.keys, setting);
    }
    return runs_[configuration] = scenes::run_scene(scene, parameters, options);
}

} // namespace dsc::gate
