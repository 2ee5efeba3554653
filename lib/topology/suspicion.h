// SPDX-License-Identifier: MIT
// Where the topology may have to change.
#pragma once

#include <cstdint>

namespace dsc {

/// A vertex of the interface, where it was before the sub-step, and whether the topology may have
/// to change there.
template <class Real>
struct Suspect {
    Real x;               ///< before the sub-step
    Real y;               ///< before the sub-step
    std::uint32_t vertex; ///< its id
    bool is_thin;         ///< a triangle of its star is, or may be
    bool is_facing;       ///< one is, and the edge opposite to the vertex may be of the interface
    /// The interface turns sharply or tightly there, has a junction, or is beside the domain
    /// boundary.
    bool is_sharp;
    bool is_junction; ///< it turns sharply or has one, and not just between two edges inside
};

} // namespace dsc
