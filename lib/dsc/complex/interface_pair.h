// SPDX-License-Identifier: MIT
// Between which two phases an edge is an interface edge [8.6].
#pragma once

#include "dsc/base/types.h"

namespace dsc {

/// Whether an edge between these two phases, in either order, is an interface edge. What lies
/// beyond the domain's border counts as exterior.
constexpr bool is_interface_pair(Phase one, Phase other) {
    return (one == border_phase ? exterior_phase : one) !=
           (other == border_phase ? exterior_phase : other);
}

} // namespace dsc
