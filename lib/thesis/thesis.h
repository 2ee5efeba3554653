// SPDX-License-Identifier: MIT
// The thesis's own method on this data structure, in reading order.
#pragma once

#include "thesis/simplex_set.h"

#include "thesis/algebra.h"
#include "thesis/insertion_removal.h"
#include "thesis/mesh_functions.h"

#include "thesis/local_retriangulation.h"
#include "thesis/loop_subdivision.h"
#include "thesis/replay.h"
#include "thesis/smoothing.h"
#include "thesis/triangle_collapse.h"

#include "thesis/centred_difference.h"
#include "thesis/selection.h"
#include "thesis/thesis_algorithm.h"

#include "thesis/blocks.h"
#include "thesis/copied_submeshes.h"
#include "thesis/copy_executor.h"
#include "thesis/divisions.h"
#include "thesis/places.h"
#include "thesis/slabs.h"
#include "thesis/voronoi.h"
