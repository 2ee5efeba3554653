// SPDX-License-Identifier: MIT
#include "scenes/run/usage.h"

#include "dsc/base/error.h"

namespace dsc::scenes {

namespace {

void check_reference(const Scene& scene, const Setup& setup, const Parameters& parameters,
                     const RunOptions& options) {
    if (!options.checkpoint.path.empty() || options.resume != nullptr) {
        throw InputError({.what = "the reference keeps no checkpoints",
                          .where = "--strategy",
                          .value = "'reference'",
                          .allowed = "another strategy"});
    }
    if (parameters.real != RealType::double_precision) {
        throw InputError({.what = "the reference is written for double",
                          .where = "--set real",
                          .value = "'float'",
                          .allowed = "double"});
    }
    if (setup.sees_interface() || !setup.carried.empty()) {
        throw InputError({.what = "the reference moves the interface alone, by velocities",
                          .where = "--strategy",
                          .value = "'reference'",
                          .allowed = "another strategy for the scene " + scene.name});
    }
}

void check_fluid_run(const Scene& scene, const Parameters& parameters) {
    if (parameters.real != RealType::double_precision) {
        throw InputError({.what = "a fluid is solved for in double",
                          .where = "--set real",
                          .value = "'float'",
                          .allowed = "double for the scene " + scene.name});
    }
}

} // namespace

void check_usage(const Scene& scene, const Setup& setup, const Parameters& parameters,
                 const RunOptions& options) {
    const Submeshing& submeshing = options.submeshing;
    if (!is_parallel(options.strategy) && submeshing.threads > 1) {
        throw InputError({.what = "this strategy runs on one thread",
                          .where = "--threads",
                          .value = std::to_string(submeshing.threads),
                          .allowed = "1, or one of the strategies " + parallel_strategies()});
    }
    if (setup.fluid) {
        check_fluid_run(scene, parameters);
    }
    if (options.strategy == Strategy::reference) {
        check_reference(scene, setup, parameters, options);
    }
}

} // namespace dsc::scenes
