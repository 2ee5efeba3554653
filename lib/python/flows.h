// SPDX-License-Identifier: MIT
// Flows: functions of Python, and the library's own.
#pragma once

#include "python/arrays.h"

#include "geometric_flows/geometric_flows.h"

#include <functional>
#include <optional>

namespace dsc::python {

/// What moves the interface of a simulation; dsc/flows.py makes it. Steps are made without the GIL.
struct AnyFlow {
    std::function<StepReport(Simulation<double>& simulation, double time, double dt)> step;
    std::optional<GrowthOptions<double>> growth = {}; ///< a simulation is made for it
};

} // namespace dsc::python
