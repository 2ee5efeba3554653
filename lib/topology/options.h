// SPDX-License-Identifier: MIT
// Options of topology changes: whether, where and how (thesis, section 13: merging of phases).
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace dsc {

/// The condition under which a thin film opens.
enum class Opening : std::uint8_t {
    squeezed, ///< while the flow takes area from it: its sheets approach each other
    thin,     ///< always: filaments that are stretched break as well
};

inline constexpr std::array opening_names{
    Named{Opening::squeezed, "squeezed"},
    Named{Opening::thin, "thin"},
};

/// What happens when a phase becomes thin.
enum class Topology : std::uint8_t {
    keep,   ///< colliding interfaces block each other; the topology is kept
    change, ///< thin films open and necks close; small remnants vanish
};

inline constexpr std::array topology_names{
    Named{Topology::keep, "keep"},
    Named{Topology::change, "change"},
};

[[nodiscard]] constexpr std::string_view to_string(Topology topology) {
    return name_in(topology_names, topology);
}

/// A rule for one pair of phases; the order of the two does not matter. A film of phase `one`
/// between two pieces of phase `other`, and the reverse, follow this rule.
template <class Real>
struct PairTopology {
    Phase one = exterior_phase;     ///< either phase of the pair
    Phase other = exterior_phase;   ///< the other one
    Topology rule = Topology::keep; ///< of this pair
    Real contact = 0;               ///< as in `TopologyOptions`

    /// Whether both are the same, member by member.
    bool operator==(const PairTopology&) const = default;
};

/// Two sheets of the interface that have come close, with a film of one phase between them.
struct Contact {
    Phase film = exterior_phase;     ///< the phase that is thin here
    std::array<Phase, 2> sides = {}; ///< the phases beyond its two sheets; `border_phase` last: the
                                     ///< film lies along the domain boundary
    double x = 0;                    ///< where, in units of the domain
    double y = 0;
    double thickness = 0; ///< of the film, a length
};

/// Which phases may meet, merge and split, and when.
template <class Real>
struct TopologyOptions {
    Topology rule = Topology::keep; ///< the rule of all pairs that `pairs` does not list
    /// The thickness, a length, at which a film opens or a neck closes. 0: 0.4 edge lengths. It may
    /// be several edge lengths: as edges become shorter, the time of an event then converges to the
    /// time at which the film has this thickness; each sub-step searches across films from the
    /// whole interface. Films along the domain boundary open as well, and the phase beyond wets the
    /// domain boundary; `may_change` or the rule of the pair keeps them. A distance wider than a
    /// phase is refused when a simulation begins (contact_check.h).
    Real contact = 0;
    Opening opening = Opening::squeezed; ///< when a thin film opens
    /// Whether an opened film continues to open along its seam. Set it to false for flows in which
    /// the ends of a film retract by themselves, as under surface tension: a filament is then cut
    /// at its thinnest point, and both parts stay.
    bool follows_seams = true;
    /// Pieces of a phase that are smaller than this area vanish. 0: one edge length squared.
    Real min_area = 0;
    /// Area that an event takes from a phase is given back to it at once: the nearest interface
    /// with the phase that took it moves, by a tenth of an edge length at most. See
    /// topology/give_back.h.
    bool gives_back_area = false;
    std::vector<PairTopology<Real>> pairs = {}; ///< rules of single pairs; each pair at most once
    /// Called before a film opens; false keeps the film. Runs on the thread that calls
    /// `Simulation::step`, between sub-steps; the step rethrows its exceptions, and the complex
    /// stays valid.
    std::function<bool(const Contact& contact)> may_change = {};

    /// The energy of an interface between two phases, per length: 0 or more. It decides how
    /// unstable junctions split. Empty: the same for all pairs.
    std::function<double(Phase one, Phase other)> energy = {};

    /// Whether any topology may change.
    [[nodiscard]] bool changes() const {
        return rule == Topology::change || std::ranges::any_of(pairs, [](const auto& pair) {
                   return pair.rule == Topology::change;
               });
    }
};

/// The default of `TopologyOptions::contact`, in edge lengths: below 0.15 a seam leaves holes; at
/// 0.4 it leaves none, and the error of a merged area is of second order.
inline constexpr double default_contact = 0.4;
/// Up to this contact distance, in edge lengths (the height of a triangle), single triangles span a
/// film.
inline constexpr double max_contact_of_triangles = 0.75;

/// Whether a contact distance (a length) is wider than single triangles span.
template <class Real>
[[nodiscard]] bool is_wide(Real contact, Real edge_length) {
    return contact > static_cast<Real>(max_contact_of_triangles) * edge_length;
}

/// The rule of a pair, and its contact distance.
template <class Real>
struct TopologyRule {
    Topology rule; ///< keep or change
    Real contact;  ///< a length
};
/// The rule of a pair of phases, in either order. O(pairs).
template <class Real>
[[nodiscard]] TopologyRule<Real> rule_of(const TopologyOptions<Real>& options, Real edge_length,
                                         Phase one, Phase other);
/// The largest contact distance of any pair that may change; 0 if none may.
template <class Real>
[[nodiscard]] Real largest_contact(const TopologyOptions<Real>& options, Real edge_length);

/// The area below which a piece vanishes.
template <class Real>
[[nodiscard]] Real min_area(const TopologyOptions<Real>& options, Real edge_length) {
    return options.min_area > 0 ? options.min_area : edge_length * edge_length;
}

/// Throws InputError if a distance or an area is negative or not finite, or a pair is named twice
/// or has twice the same phase.
template <class Real>
void check_topology(const TopologyOptions<Real>& options);

} // namespace dsc
