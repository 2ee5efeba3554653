// SPDX-License-Identifier: MIT
#include "scenes/run/run.h"

#include "dsc/base/error.h"
#include "scenes/name_list.h"

namespace dsc::scenes {

void check_usage(const Scene& scene, const Setup& setup, const Parameters& parameters,
                 const RunOptions& options) {
    const auto refuse = [](const char* what, const char* where, const std::string& value,
                           const std::string& allowed) {
        throw InputError({.what = what, .where = where, .value = value, .allowed = allowed});
    };
    const bool is_reference = options.strategy == Strategy::reference;
    const bool is_float = parameters.real != RealType::double_precision;
    if (!is_parallel(options.strategy) && options.submeshing.threads > 1) {
        const auto name = [](Strategy one) { return to_string(one); };
        refuse("this strategy runs on one thread", "--threads", to_text(options.submeshing.threads),
               "1, or one of the strategies " + name_list(parallel_strategies(), name));
    }
    if (setup.fluid && is_float) {
        refuse("a fluid is solved for in double", "--set real", "'float'",
               "double for the scene " + scene.name);
    }
    if (is_reference && is_float) {
        refuse("the reference is written for double", "--set real", "'float'", "double");
    }
    if (is_reference && (!options.checkpoint.path.empty() || options.resume != nullptr)) {
        refuse("the reference keeps no checkpoints", "--strategy", "'reference'",
               "another strategy");
    }
    if (is_reference && (setup.sees_interface() || !setup.carried.empty())) {
        refuse("the reference moves the interface alone, by velocities", "--strategy",
               "'reference'", "another strategy for the scene " + scene.name);
    }
}

} // namespace dsc::scenes
