// SPDX-License-Identifier: MIT
// The answers of guards.
#pragma once

#include "dsc/base/names.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace dsc {

/// The answer of a guard, and of the operation behind it: the restriction (thesis, section 6.5)
/// that stops it. Anything but `legal` means that the complex was left untouched. Guards test in
/// the order of this list and return the first restriction that stops the operation.
enum class Verdict : std::uint8_t {
    legal,
    not_a_simplex,        ///< the handle names no living simplex of the complex
    on_boundary,          ///< would change the shape of the domain
    on_submesh_boundary,  ///< touches a simplex that another submesh owns (thesis, section 6.4)
    on_interface,         ///< would change the interface (thesis, section 6.5)
    locked,               ///< a vertex that would vanish or move is locked by the application
    changes_topology,     ///< would make a phase vanish, pinch it, or break the complex
    not_a_simple_polygon, ///< local retriangulation: the trace is not one simple polygon (thesis,
                          ///< section 7.3)
    inverts,              ///< a triangle would be inverted or degenerate
    no_gain,              ///< legal, but the quality would not rise (smoothing, improvement)
    out_of_ids,           ///< the pool of a submesh is empty; another colour does the operation
};

inline constexpr std::array verdict_names{
    Named{Verdict::legal, "legal"},
    Named{Verdict::not_a_simplex, "not_a_simplex"},
    Named{Verdict::on_boundary, "on_boundary"},
    Named{Verdict::on_submesh_boundary, "on_submesh_boundary"},
    Named{Verdict::on_interface, "on_interface"},
    Named{Verdict::locked, "locked"},
    Named{Verdict::changes_topology, "changes_topology"},
    Named{Verdict::not_a_simple_polygon, "not_a_simple_polygon"},
    Named{Verdict::inverts, "inverts"},
    Named{Verdict::no_gain, "no_gain"},
    Named{Verdict::out_of_ids, "out_of_ids"},
};

[[nodiscard]] constexpr std::string_view to_string(Verdict verdict) {
    return name_in(verdict_names, verdict);
}

} // namespace dsc
