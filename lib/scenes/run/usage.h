// SPDX-License-Identifier: MIT
// What a run may be asked for: what each strategy can do.
#pragma once

#include "scenes/run/run.h"

namespace dsc::scenes {

/// Throws InputError for a strategy that cannot do what is asked of it.
void check_usage(const Scene& scene, const Setup& setup, const Parameters& parameters,
                 const RunOptions& options);

} // namespace dsc::scenes
