// SPDX-License-Identifier: MIT
// Everything that an application chooses [2.2]: sizes, thresholds, interpolators, integrator, when
// to stop. Lengths are relative to `edge_length`, qualities are those of equation 4 (0 to 1).
#pragma once

#include "dsc/base/enum_table.h"
#include "dsc/motion/integrator.h"
#include "dsc/motion/interpolation.h"

#include <vector>

namespace dsc {

/// Thresholds of one phase.
struct PhaseThresholds {
    double collapse_quality = 0.35; ///< below: collapse a vertex, if that raises the worst quality
    double smooth_quality = 0.65;   ///< below: smooth, if that raises the worst quality
    double longest = 1.6;           ///< spokes longer than this times the edge length are split
    double shortest = 0.4; ///< spokes shorter than this times the edge length are collapsed
    double crowded = 0.9;  ///< vertices all of whose spokes are shorter than this times the edge
                           ///< length may be collapsed too: they are left over from finer places
};

/// Which interface vertices at short edges may go. Corners never do.
enum class Coarsening : std::uint8_t {
    deviation, ///< those without which the curve stays where it is
    length,    ///< all: the thesis's
    area,      ///< all, and a neighbour moves so that the area of the phases stays
    never,     ///< none: the curve keeps all it ever knew, at the price of short edges
};

inline constexpr std::array coarsening_names{
    Named{Coarsening::deviation, "deviation"},
    Named{Coarsening::length, "length"},
    Named{Coarsening::area, "area"},
    Named{Coarsening::never, "never"},
};

[[nodiscard]] constexpr std::string_view to_string(Coarsening coarsening) {
    return name_in(coarsening_names, coarsening);
}

/// Thresholds of the interface.
struct InterfaceThresholds {
    double longest = 1; ///< edges longer than this times the edge length are split
    double shortest =
        0.3; ///< vertices at an edge shorter than this times the edge length may go...
    double deviation = 0.02; ///< ...if the curve moves by less than this times the edge length
    double degenerate = 5;   ///< ...or at an edge shorter than this times the deviation, where the
                           ///< curve turns by more than 45 degrees: that is no shape any more, but
                           ///< what a tip has left
    double corner_degrees = 40; ///< turns sharper than this at the start are corners: kept, and
                                ///< not interpolated over

    Coarsening coarsening = Coarsening::deviation;
    Reading reading = Reading::chords; ///< what `deviation` is measured from

    double grading = 3; ///< beside an interface edge others are split that are longer than this
                        ///< times it; 0: none

    // Sizes that follow the shape; 0: they do not, and cost nothing.
    double turn_degrees = 0; ///< edges along which the curve turns by more are split
    double gap = 0;          ///< edges longer than this times the distance to the next sheet of the
                             ///< interface are split
    double finest = 0.2;     ///< edges shorter than twice this times the edge length are split for
                             ///< neither
};

template <class Real>
struct Options {
    Real edge_length = 0; ///< target length of edges, in units of the domain; must be positive

    PhaseThresholds phases = {};                 ///< of every phase that has none of its own
    std::vector<PhaseThresholds> per_phase = {}; ///< by phase number; may be shorter
    InterfaceThresholds interface = {};

    Integrator integrator = Integrator::rk4;
    double tolerance = 1e-4; ///< of `adaptive`: error of a sub-step, in edge lengths
    Insertion insertion = Insertion::cubic;
    InsertionFunction<Real> insertion_function = {}; ///< replaces `insertion` where set

    std::uint64_t shuffle_seed =
        0; ///< not 0: work through the interface in another order in each step

    double sub_step = 0.6;     ///< no vertex is asked to travel farther at a time, in edge lengths
    int max_sub_steps = 10000; ///< of one step; then the step gives up and says so
    int max_passes = 32;       ///< movement and mesh update, of one sub-step
    int max_idle_passes = 6;   ///< passes without any progress before the sub-step ends

    [[nodiscard]] const PhaseThresholds& thresholds(Phase phase) const {
        return phase < per_phase.size() ? per_phase[phase] : phases;
    }
};

/// Throws InputError where a value is not finite, out of range, or at odds with another.
template <class Real>
void check_options(const Options<Real>& options);

} // namespace dsc
