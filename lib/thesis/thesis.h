// SPDX-License-Identifier: MIT
// The thesis's own method on this data structure, in reading order.
#pragma once

#include "thesis/sets/simplex_set.h"

#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"
#include "thesis/sets/mesh_functions.h"

#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/replay.h"
#include "thesis/operations/smoothing.h"
#include "thesis/operations/triangle_collapse.h"

#include "thesis/algorithm/centred_difference.h"
#include "thesis/algorithm/selection.h"
#include "thesis/algorithm/thesis_algorithm.h"

#include "thesis/divisions/blocks.h"
#include "thesis/divisions/places.h"
#include "thesis/divisions/slabs.h"
#include "thesis/divisions/voronoi.h"

#include "thesis/copies/copied_submeshes.h"
#include "thesis/copies/copy_executor.h"

#include "thesis/divisions.h"
