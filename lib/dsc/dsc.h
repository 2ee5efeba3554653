// SPDX-License-Identifier: MIT
// The whole library, in reading order.
#pragma once

#include "dsc/base/error.h"
#include "dsc/base/predicates.h"
#include "dsc/base/types.h"
#include "dsc/base/unit_map.h"
#include "dsc/base/verdict.h"

#include "dsc/complex/algebra.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/hash.h"
#include "dsc/complex/mesh_functions.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/submesh.h"
#include "dsc/complex/validate.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/operations/local_retriangulation.h"
#include "dsc/operations/loop_subdivision.h"
#include "dsc/operations/smoothing.h"

#include "dsc/quality/histogram.h"
#include "dsc/quality/measures.h"
#include "dsc/quality/selection.h"

#include "dsc/initial/initial_complex.h"
#include "dsc/initial/unit_box.h"

#include "dsc/motion/integrator.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/unit_velocity.h"

#include "dsc/algorithm/algorithm.h"
#include "dsc/algorithm/driver.h"
#include "dsc/algorithm/options.h"
#include "dsc/algorithm/thesis_algorithm.h"

#include "dsc/parallel/blocks.h"
#include "dsc/parallel/cells.h"
#include "dsc/parallel/copied_submeshes.h"
#include "dsc/parallel/copy_executor.h"
#include "dsc/parallel/places.h"
#include "dsc/parallel/slabs.h"
#include "dsc/parallel/submesh_executor.h"

#include "dsc/io/svg.h"
#include "dsc/io/vtu.h"
