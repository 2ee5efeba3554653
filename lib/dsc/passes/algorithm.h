// SPDX-License-Identifier: MIT
// Algorithm 5.1 as a list of passes. An application replaces, removes or adds passes without
// touching the drivers; both drivers run the same list, on the whole complex or on each submesh.
#pragma once

#include "dsc/passes/work.h"

#include <functional>
#include <string>
#include <vector>

namespace dsc {

/// One pass over the work of one submesh. Must only change what the submesh owns, which every
/// operation sees to by itself, and must not keep state between calls.
template <class Real>
struct Pass {
    std::string name;
    std::function<void(Work<Real>&)> run;
};

template <class Real>
struct Algorithm {
    std::vector<Pass<Real>> upkeep; ///< once a sub-step, before anything moves
    std::vector<Pass<Real>> motion; ///< repeated until all vertices have arrived
};

/// The default: interface upkeep; movement, then the mesh update on the active set.
template <class Real>
Algorithm<Real> default_algorithm();

} // namespace dsc
