// SPDX-License-Identifier: MIT
// For applications: make a complex, choose options, move the interface, query it, write it. Custom
// passes, stages, executors and operations need dsc/engine.h.
#pragma once

#include "dsc/base/error.h"

#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"

#include "dsc/queries/locate.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"

#include "dsc/quality/measures.h"

#include "dsc/initial/initial_complex.h"
#include "dsc/initial/label_image.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/parallel.h"

#include "dsc/io/pictures.h"
