// SPDX-License-Identifier: MIT
// The whole library, in reading order.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/base/error.h"
#include "dsc/base/require.h"
#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/geometry/frame.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/turn.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/edit_log.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/spokes.h"
#include "dsc/complex/submesh.h"

#include "dsc/queries/hash.h"
#include "dsc/queries/locate.h"
#include "dsc/queries/outlines.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include "dsc/sizes/field.h"
#include "dsc/sizes/options.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/operations/fan.h"
#include "dsc/operations/replay.h"
#include "dsc/operations/smoothing.h"

#include "dsc/quality/measures.h"
#include "dsc/quality/ring_quality.h"

#include "dsc/initial/initial_complex.h"

#include "dsc/motion/custom_integrator.h"
#include "dsc/motion/integrator.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/movement.h"

#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/carried.h"
#include "dsc/passes/options.h"

#include "dsc/algorithm/run.h"
#include "dsc/algorithm/simulation.h"

#include "dsc/parallel/partition/blocks.h"
#include "dsc/parallel/partition/cells.h"
#include "dsc/parallel/partition/places.h"
#include "dsc/parallel/partition/slabs.h"

#include "dsc/parallel/threads/thread_choice.h"
#include "dsc/parallel/threads/thread_pool.h"

#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/parallel.h"
#include "dsc/parallel/timer.h"

#include "dsc/io/edit_file.h"
#include "dsc/io/part_file.h"
#include "dsc/io/svg.h"
#include "dsc/io/vtu.h"
