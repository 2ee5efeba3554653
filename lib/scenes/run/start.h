// SPDX-License-Identifier: MIT
// The first complex and the options of a scene, for runs, benchmarks and tests.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/run/strategy.h"
#include "scenes/scene.h"
#include "topology/options.h"

#include <memory>

namespace dsc {
template <class Real>
class Simulation;
} // namespace dsc

namespace dsc::scenes {

/// `report` gets the simplification of shapes.
template <class Real>
Complex<Real> first_complex(const Setup& setup, const Parameters& parameters,
                            InputReport* report = nullptr);
template <class Real>
Options<Real> scene_options(const Setup& setup, const Parameters& parameters);
template <class Real>
TopologyOptions<Real> topology_options(const Parameters& parameters);
/// A simulation of `complex`, which must outlive it, as must `options`.
template <class Real>
std::unique_ptr<Simulation<Real>> make_simulation(Complex<Real>& complex,
                                                  const Options<Real>& options,
                                                  const TopologyOptions<Real>& topology,
                                                  Strategy strategy, const Submeshing& submeshing);

} // namespace dsc::scenes
