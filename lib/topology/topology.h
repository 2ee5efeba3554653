// SPDX-License-Identifier: MIT
// Phases that meet, merge and split: a stage of a simulation, in reading order.
#pragma once

#include "topology/options.h"

#include "topology/events.h"
#include "topology/stage.h"
