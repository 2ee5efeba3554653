// SPDX-License-Identifier: MIT
// The answer of a guard: which restriction of thesis section 6.5 stops an operation.
#pragma once

#include <cstdint>
#include <string_view>

namespace dsc {

/// The answer of a guard, and of the operation behind it. Anything but `legal` means that the
/// complex was left untouched. Guards test in the order of this list and name the first that stops.
enum class Verdict : std::uint8_t {
    legal,
    not_a_simplex,        ///< the handle names nothing that lives in the complex
    on_boundary,          ///< would change the shape of the domain
    on_submesh_boundary,  ///< touches a simplex that another submesh owns (thesis, section 6.4)
    on_interface,         ///< would change the interface (thesis, section 6.5)
    locked,               ///< a vertex that would vanish or move is locked by the application
    changes_topology,     ///< would make a phase vanish, pinch it, or break the complex
    not_a_simple_polygon, ///< local retriangulation: the trace is not one simple polygon (thesis,
                          ///< section 7.3)
    inverts,              ///< a triangle would turn over or lose its area
    no_gain,              ///< legal, but the quality would not rise (smoothing, improvement)
    out_of_ids,           ///< the pool of a submesh is used up; another colour takes it
};

inline constexpr int verdict_count = 11;

[[nodiscard]] constexpr std::string_view to_string(Verdict verdict) {
    switch (verdict) {
    case Verdict::legal: return "legal";
    case Verdict::not_a_simplex: return "not_a_simplex";
    case Verdict::on_boundary: return "on_boundary";
    case Verdict::on_submesh_boundary: return "on_submesh_boundary";
    case Verdict::on_interface: return "on_interface";
    case Verdict::locked: return "locked";
    case Verdict::changes_topology: return "changes_topology";
    case Verdict::not_a_simple_polygon: return "not_a_simple_polygon";
    case Verdict::inverts: return "inverts";
    case Verdict::no_gain: return "no_gain";
    case Verdict::out_of_ids: return "out_of_ids";
    }
    return "unknown";
}

} // namespace dsc
