// SPDX-License-Identifier: MIT
// All options of an application (thesis, section 2.2): sizes, thresholds, interpolators,
// integrator, limits of a step. Lengths are relative to `edge_length`, qualities are those of
// equation 4 of the thesis (0 to 1).
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "dsc/motion/integrator.h"
#include "dsc/motion/interpolation.h"
#include "dsc/sizes/sizes.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace dsc {

/// Thresholds of one phase.
struct PhaseThresholds {
    double collapse_quality = 0.35; ///< poorer: collapse a vertex, if that raises the worst quality
    double smooth_quality = 0.65;   ///< poorer: smooth, if that raises the worst quality
    double longest = 1.6;  ///< incident edges longer than this times the edge length are split
    double shortest = 0.4; ///< incident edges shorter than this times the edge length are collapsed
    /// Vertices whose incident edges are all shorter than this times the edge length may be
    /// collapsed too: they remain from a time when the mesh was finer there.
    double crowded = 0.9;
};

/// The interface vertices at short edges that may be removed. Features never are.
enum class Coarsening : std::uint8_t {
    deviation, ///< those whose removal leaves the curve in place
    length,    ///< all, as in the thesis
    never,     ///< none: the curve keeps all its detail, at the price of short edges
};

inline constexpr std::array coarsening_names{
    Named{Coarsening::deviation, "deviation"},
    Named{Coarsening::length, "length"},
    Named{Coarsening::never, "never"},
};

[[nodiscard]] constexpr std::string_view to_string(Coarsening coarsening) {
    return name_in(coarsening_names, coarsening);
}

/// Thresholds of the interface.
struct InterfaceThresholds {
    double longest = 1; ///< edges longer than this times the edge length are split
    /// Vertices at an edge shorter than this times the edge length may be removed...
    double shortest = 0.3;
    double deviation = 0.02; ///< ...if the curve moves by less than this times the edge length
    /// ...or if the edge is shorter than this times the deviation and the curve turns by more than
    /// 45 degrees there: it is then the remnant of a collapsed tip.
    double degenerate = 5;
    /// Turns sharper than this at the start are features: they are kept, and curves are not
    /// interpolated across them.
    double feature_degrees = 40;

    Coarsening coarsening = Coarsening::deviation; ///< which vertices may go
    Reading reading = Reading::chords;             ///< what `deviation` is measured from

    /// Edges beside an interface edge are split if they are longer than this times its length; 0:
    /// none are.
    double grading = 3;

    // Sizes that adapt to the shape; 0: off, at no cost.
    double turn_degrees = 0; ///< edges along which the curve turns by more are split
    /// Edges longer than this times the distance to the next sheet of the interface are split.
    double gap = 0;
    /// Edges shorter than twice this times the edge length are not split for either reason.
    double finest = 0.2;
};

/// The options of a simulation.
template <class Real>
struct Options {
    Real edge_length = 0; ///< target length of edges, in units of the domain; must be positive

    /// Sizes that grow away from the interface: thresholds of phases are then relative to the local
    /// target instead of the edge length. Uniform by default.
    SizeOptions<Real> sizes = {};

    PhaseThresholds phases = {}; ///< thresholds of every phase that is not in `per_phase`
    std::vector<PhaseThresholds> per_phase = {}; ///< by phase number; may be shorter
    InterfaceThresholds interface = {};          ///< of all interfaces

    /// Phases whose inside moves with the flow as well, not only the interface around it (thesis,
    /// section 9.1): a phase that moves as a rigid body keeps its triangles. Only for flows that
    /// are velocities. Without such phases there is no cost.
    std::vector<Phase> advected_phases = {};

    Integrator integrator = Integrator::rk4; ///< how targets are found from velocities
    double tolerance = 1e-4; ///< of `adaptive`: error of a sub-step, in edge lengths
    /// Replaces `integrator` if set.
    std::shared_ptr<const CustomIntegrator<Real>> custom_integrator = {};
    Insertion insertion = Insertion::cubic;          ///< where new interface vertices go
    InsertionFunction<Real> insertion_function = {}; ///< replaces `insertion` if set

    /// If not 0, the interface is processed in a different order in each step.
    std::uint64_t shuffle_seed = 0;

    double sub_step = 0.6; ///< largest distance that a vertex moves in a sub-step, in edge lengths
    int max_sub_steps = 10000; ///< of one step; then the step gives up and reports it
    /// Bound on the passes of movement and mesh update in one sub-step, which normally ends much
    /// earlier: when all vertices have arrived or none makes progress. A step that reaches the
    /// bound gives up and reports it.
    int max_passes = 1000;
    int max_idle_passes = 6; ///< passes without any progress before the sub-step ends

    /// The thresholds of a phase. O(1).
    [[nodiscard]] const PhaseThresholds& thresholds(Phase phase) const {
        return phase < per_phase.size() ? per_phase[phase] : phases;
    }
    /// Whether the inside of a phase moves with the flow. O(advected phases).
    [[nodiscard]] bool advects(Phase phase) const {
        return std::ranges::find(advected_phases, phase) != advected_phases.end();
    }
};

/// Throws InputError if a value is not finite, out of range, or inconsistent with another.
template <class Real>
void check_options(const Options<Real>& options);

} // namespace dsc
