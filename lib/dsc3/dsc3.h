// SPDX-License-Identifier: MIT
// Deformable simplicial complexes in three dimensions, in reading order.
#pragma once

#include "dsc3/base/types.h"
#include "dsc3/geometry/predicates.h"
#include "dsc3/geometry/tet.h"

#include "dsc3/complex/complex.h"
#include "dsc3/complex/star.h"

#include "dsc3/queries/interface_star.h"
#include "dsc3/queries/phases.h"
#include "dsc3/queries/validate.h"

#include "dsc3/operations/edge_collapse.h"
#include "dsc3/operations/edge_removal.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/operations/interface_flip.h"
#include "dsc3/operations/smoothing.h"

#include "dsc3/motion/insertion.h"
#include "dsc3/motion/integrator.h"

#include "dsc3/passes/options.h"

#include "dsc3/initial/initial_complex.h"
#include "dsc3/initial/shapes.h"

#include "dsc3/parallel/parallel.h"

#include "dsc3/algorithm/simulation.h"

#include "dsc3/io/surface.h"
#include "dsc3/io/vtu.h"
