// SPDX-License-Identifier: MIT
// The suites; main.cpp registers them all, and Google Benchmark's flags choose.
#pragma once

namespace dsc::bench {

/// `operation/NAME`: one operation of the library; `kernel/NAME`: a function of the whole mesh.
void register_operations();

/// `flow/NAME`: a velocity by formulas, against the same one in C++.
void register_flows();

/// `scaling_step/...` and `four_circles_step/...`: a time step of the two scenes of the thesis,
/// section 9.7.
void register_steps();

/// `scaling_run/...` and `four_circles_run/...`: whole runs of these scenes, with other work
/// between their steps.
void register_runs();

/// `option/NAME/SCENE`: what an option costs in a step, against the same scene without it.
void register_options();

} // namespace dsc::bench
