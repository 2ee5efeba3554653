// SPDX-License-Identifier: MIT
// The flow of a scene file. A [flow], or each [[flow]] where one follows the other, is
//
//     u, v  = "formula", "formula" in x, y, t, the [flow.parameters] and pi, h, period
//     until = the time at which the next one takes over
#pragma once

#include "flows/velocity.h"
#include "scenes/file/table_reader.h"
#include "scenes/parameters.h"

#include <functional>

namespace dsc::scenes {

/// The flow, for values of h and the period that may have been set since the file was read.
using FlowSource = std::function<Flow(const Parameters& parameters)>;

/// Throws InputError, for a formula with the character at which it breaks off.
[[nodiscard]] FlowSource read_flow(const std::vector<TableReader>& legs);

} // namespace dsc::scenes
