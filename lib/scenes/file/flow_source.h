// SPDX-License-Identifier: MIT
// The flow of a scene file. A [flow], or each [[flow]] of a sequence, has
//
//     u, v  = "formula", "formula" in x, y, t, the [flow.parameters] and pi, h, period
//     until = the time at which the next one takes over
#pragma once

#include "flows/velocity.h"
#include "scenes/file/table_reader.h"
#include "scenes/parameters.h"

#include <functional>

namespace dsc::scenes {

/// Makes the flow for the final values of h and the period, which --set may have changed.
using FlowSource = std::function<Flow(const Parameters& parameters)>;

/// Throws InputError; for a formula, with the position of the error.
[[nodiscard]] FlowSource read_flow(const std::vector<TableReader>& legs);

} // namespace dsc::scenes
