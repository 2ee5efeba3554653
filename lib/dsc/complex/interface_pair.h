// SPDX-License-Identifier: MIT
// Which pairs of phases make the edge between them an interface edge (thesis, section 8.6).
#pragma once

#include "dsc/base/types.h"

namespace dsc {

/// Whether an edge between these two phases, in either order, is an interface edge. The outside of
/// the domain counts as exterior.
constexpr bool is_interface_pair(Phase one, Phase other) {
    return (one == border_phase ? exterior_phase : one) !=
           (other == border_phase ? exterior_phase : other);
}

} // namespace dsc
