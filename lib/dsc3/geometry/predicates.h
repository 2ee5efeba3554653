// SPDX-License-Identifier: MIT
// The exact sign of a volume: a static filter decides nearly all, Boost.Multiprecision the rest.
#pragma once

#include "dsc3/base/types.h"

namespace dsc3 {

/// +1 if (b, c, d) turns clockwise as seen from a, -1 if counter-clockwise, 0 if the four points
/// lie in a plane or one is not finite. Exact for every finite input. Thread-safe.
[[nodiscard]] int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

} // namespace dsc3
