// SPDX-License-Identifier: MIT
// Incompressible flow of two or more phases, in reading order.
#pragma once

#include "fluid/options.h"

#include "fluid/field/snapshot_field.h"

#include "fluid/flow.h"
#include "fluid/measures.h"
