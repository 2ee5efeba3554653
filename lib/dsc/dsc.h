// SPDX-License-Identifier: MIT
// The whole library, in reading order.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/base/error.h"
#include "dsc/base/types.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/edit_log.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/submesh.h"

#include "dsc/sizes/sizes.h"

#include "dsc/queries/locate.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"

#include "dsc/quality/measures.h"

#include "dsc/initial/initial_complex.h"
#include "dsc/initial/label_image.h"

#include "dsc/motion/integrator.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/movement.h"

#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/options.h"

#include "dsc/algorithm/simulation.h"

#include "dsc/parallel/parallel.h"
#include "dsc/parallel/partition/partition.h"

#include "dsc/io/part_file.h"
#include "dsc/io/pictures.h"
