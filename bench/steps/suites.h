// SPDX-License-Identifier: MIT
// Registration of the rows of Google Benchmark: main.cpp registers those of a suite, and Google
// Benchmark's flags select among them.
#pragma once

#include "steps/suite.h"

namespace dsc::bench {

/// `NAME_run/...`: whole runs of a scene, with other work between their steps.
void register_run(const Row& row);

/// `NAME_step/...`: a time step of a scene (thesis, section 9.7), measured or modelled.
void register_step(const Row& row);

/// `NAME_run/...` of a scene in three dimensions: whole runs, measured or modelled.
void register_space_run(const SpaceRow& row);

/// `option/NAME/SCENE`: the cost of an option in a step, compared with the scene without it.
void register_comparison(const Comparison& comparison);

/// `operation/NAME`: one operation of the library.
void register_operations();

/// `kernel/NAME`: a function of the whole mesh.
void register_kernels();

/// `flow/NAME`: a velocity by formulas, compared with the same one in C++.
void register_flows();

/// `space/SCENE/edges:N`: a run in three dimensions with edges of length 1 / N.
void register_space();

} // namespace dsc::bench
