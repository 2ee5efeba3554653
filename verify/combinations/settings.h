// SPDX-License-Identifier: MIT
// What a row asks of the library: options, the flow along normals, threads.
#pragma once

#include "combinations/scene.h"
#include "support/topology/changing.h"

#include "dsc/parallel/parallel.h"
#include "dsc/passes/options.h"
#include "geometric_flows/growth.h"

namespace dsc::combinations {

/// `half`: 0 in the first half of the run, 1 in the second.
template <class Real>
[[nodiscard]] test::ChangingOptions<Real> options_of(const Row& row, const Scene& scene, int half);

/// Of `grow` and `shrink`.
template <class Real>
[[nodiscard]] GrowthOptions<Real> growth_of(const Row& row);

/// Of all ways but the sequential one.
[[nodiscard]] Parallel parallel_of(const Row& row, std::uint32_t threads);

/// The thickness at which a film opens, in edge lengths.
[[nodiscard]] double contact_of(const Row& row);

} // namespace dsc::combinations
