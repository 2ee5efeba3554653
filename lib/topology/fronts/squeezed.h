// SPDX-License-Identifier: MIT
// A front of a single edge between the ends of two seams. It vanishes by time, when both ends reach
// one place, and not by length: fast ends would pass each other, or meet the front beyond.
#pragma once

#include "topology/fronts/sight.h"

#include <optional>

namespace dsc {

/// From the end v of a seam, in its sector k of the film: the other end of a front that vanishes
/// within the coming sub-step, where it and the fronts on both sides of it, which are those of the
/// sight, meet. The speeds are the mean of the three. Only reads. O(degrees).
template <class Real>
[[nodiscard]] std::optional<Sight<Real>> see_squeezed(const TopologyWork<Real>& work,
                                                      const Sectors<Real>& sectors, std::uint32_t v,
                                                      std::size_t k);

/// Whether a front of this phase ends beside the end of a seam, in its sector k: it comes to that
/// end only as the front between them vanishes. False for other vertices. O(degrees).
template <class Real>
[[nodiscard]] bool is_behind_squeezed(const Complex<Real>& complex, const Sectors<Real>& sectors,
                                      std::size_t k, Phase front);

} // namespace dsc
