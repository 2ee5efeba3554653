// SPDX-License-Identifier: MIT
#include "runs.h"

#include "scenes/catalogue/catalogue.h"

#include <algorithm>

namespace dsc::gate {

namespace {

/// Small enough for a method that sweeps over sets in each step, and large enough for some hundred
/// triangles inside and outside the shape.
constexpr double edges_of_side = 20;

scenes::Parameters coarse(const scenes::Scene& scene) {
    scenes::Parameters parameters = scene.defaults;
    const Rectangle domain = scene.prepare(scene.defaults).domain;
    parameters.h = (domain.high - domain.low).maxCoeff() / edges_of_side;
    parameters.interface = scenes::coarse_interface(); // as long as the reference's
    if (scene.name == "single-vortex") {
        // The filament of a longer period is thinner than the mesh.
        parameters.period = 2;
    }
    return parameters;
}

/// Fine enough that every strategy has submeshes for several threads, and as many steps as show
/// that.
constexpr double edges_of_shared_side = 80;
constexpr int shared_steps = 40;

// With the time step of a whole run.
scenes::Parameters shared(const scenes::Scene& scene) {
    scenes::Parameters parameters = scene.defaults;
    const Rectangle domain = scene.prepare(scene.defaults).domain;
    parameters.h = (domain.high - domain.low).maxCoeff() / edges_of_shared_side;
    const scenes::Setup whole = scene.prepare(parameters);
    const int steps = std::min(whole.steps, shared_steps);
    parameters.dt = whole.dt;
    parameters.steps = scene.counts_steps_each_way ? std::max(steps / 2, 1) : steps;
    return parameters;
}

scenes::Parameters of_size(const scenes::Scene& scene, Size size) {
    return size == Size::full     ? scene.defaults
           : size == Size::coarse ? coarse(scene)
                                  : shared(scene);
}

} // namespace

scenes::SceneFile Runs::find(const std::string& scene) const {
    const auto file = std::ranges::find_if(
        files_, [&](const scenes::SceneFile& one) { return one.scene.name == scene; });
    return file != files_.end() ? *file : scenes::SceneFile{.scene = scenes::find_scene(scene)};
}

Prepared Runs::prepare(const Configuration& configuration) const {
    const scenes::SceneFile file = find(configuration.scene);
    Prepared run{
        .scene = file.scene, .parameters = of_size(file.scene, configuration.size), .options = {}};
    run.options.strategy = configuration.strategy;
    run.options.submeshing.threads = configuration.threads;
    run.options.submeshing.always_all_threads = configuration.size == Size::shared;
    run.options.measures = file.measures;
    run.options.measure_shape = configuration.measure_shape && file.measures_shape;
    for (const std::string& setting : configuration.settings) {
        scenes::apply_setting(run.parameters, run.scene.keys, setting);
    }
    return run;
}

const scenes::RunResult& Runs::get(const Configuration& configuration) {
    const auto found = runs_.find(configuration);
    if (found != runs_.end()) {
        return found->second;
    }
    const Prepared run = prepare(configuration);
    return runs_[configuration] = scenes::run_scene(run.scene, run.parameters, run.options);
}

} // namespace dsc::gate
