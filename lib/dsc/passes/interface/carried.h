// SPDX-License-Identifier: MIT
// The vertices that a flow moves: those of the interface, and those inside the phases that are
// carried along (`Options::carried_phases`).
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/passes/options.h"

#include <span>
#include <vector>

namespace dsc {

/// Whether a living vertex lies inside one of these phases, away from the domain boundary.
/// O(degree).
template <class Real>
[[nodiscard]] bool is_carried(const Complex<Real>& complex, std::span<const Phase> phases,
                              Vertex vertex);

/// All of them: the interface curve by curve, then the others by id; shuffled as the options say.
/// O(n), once at the start.
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> collect_moved(const Complex<Real>& complex,
                                                       const Options<Real>& options);

/// Whether a flow moves this vertex now: it lives, in a triangle, on the interface or carried.
/// O(degree).
template <class Real>
[[nodiscard]] bool is_moved(const Complex<Real>& complex, const Options<Real>& options,
                            Vertex vertex);

/// Those among `changed` that a flow moves now. O(their degrees).
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> moved_among(const Complex<Real>& complex,
                                                     const Options<Real>& options,
                                                     std::span<const std::uint32_t> changed);

} // namespace dsc
