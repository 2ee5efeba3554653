// SPDX-License-Identifier: MIT
// Flows: Python functions, and the library's own flows.
#pragma once

#include "python/arrays.h"

#include "geometric_flows/geometric_flows.h"

#include <functional>
#include <optional>

namespace dsc::python {

/// The motion of a simulation's interface; made by dsc/flows.py. Steps run without the GIL.
struct AnyFlow {
    std::function<StepReport(Simulation<double>& simulation, double time, double dt)> step;
    std::optional<GrowthOptions<double>> growth = {}; ///< needs a simulation made for it
};

} // namespace dsc::python
