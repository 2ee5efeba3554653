// SPDX-License-Identifier: MIT
// Flows that follow from the shape of the interface, in reading order.
#pragma once

#include "geometric_flows/curvature_flow.h"

#include "geometric_flows/growth.h"
#include "geometric_flows/growth_features.h"
