// SPDX-License-Identifier: MIT
// The whole library, to write passes, stages, executors, partitioners or operations: dsc.h and the
// parts that it is built from, in reading order.
#pragma once

#include "dsc/dsc.h"

#include "dsc/base/timer.h"

#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/side.h"
#include "dsc/geometry/triangle.h"

#include "dsc/complex/edit_log.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"

#include "dsc/motion/integrator.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/movement.h"
#include "dsc/motion/time_ahead.h"

#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/stage.h"

#include "dsc/parallel/executors.h"
#include "dsc/parallel/partition/partition.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/parallel/threads/thread_pool.h"

#include "dsc/io/part_file.h"
