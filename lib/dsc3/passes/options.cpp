// SPDX-License-Identifier: MIT
#include "dsc3/passes/options.h"

#include <cmath>

namespace dsc3 {

void check_options(const Options& options) {
    using dsc::require;
    const auto& [longest, shortest, deviation, always] = options.interface;
    require(options.edge_length >= 1e-50 && options.edge_length <= 1e50, "edge_length",
            options.edge_length, "1e-50 to 1e50");
    require(longest >= 0.5 && longest <= 10, "interface.longest", longest, "0.5 to 10");
    require(shortest >= 0 && shortest <= longest / 2, "interface.shortest", shortest,
            "0 to half of interface.longest");
    require(deviation >= 0 && deviation <= 1e9, "interface.deviation", deviation, "0 to 1e9");
    require(always >= 0 && always <= shortest, "interface.always", always,
            "0 to interface.shortest");
    require(options.quality > 0 && options.quality <= 0.5, "quality", options.quality,
            "above 0, at most 0.5");
    require(options.move_quality >= 1e-5 && options.move_quality <= options.quality, "move_quality",
            options.move_quality, "1e-5 to quality");
    require(options.layers >= 0 && options.layers <= 10, "layers", options.layers, "0 to 10");
    require(options.tolerance > 0 && std::isfinite(options.tolerance), "tolerance",
            options.tolerance, "positive");
    require(options.sub_step >= 1e-3 && options.sub_step <= 1, "sub_step", options.sub_step,
            "0.001 to 1");
    require(options.max_sub_steps >= 1, "max_sub_steps", options.max_sub_steps, "1 or more");
    require(options.max_passes >= 1 && options.max_passes <= 1000, "max_passes", options.max_passes,
            "1 to 1000");
    if (!options.insertion) {
        throw InputError({.what = "no insertion function",
                          .where = "insertion",
                          .value = "an empty function",
                          .allowed = "dsc3::curved_middle, or a function of your own"});
    }
}

} // namespace dsc3
