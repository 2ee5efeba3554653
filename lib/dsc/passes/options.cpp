// SPDX-License-Identifier: MIT
#include "dsc/passes/options.h"

#include "dsc/base/error.h"
#include "dsc/geometry/triangle.h"

#include <cmath>

namespace dsc {

namespace {

/// Upper bounds, which leave squares of lengths and sums of counts far from overflow.
constexpr double max_lengths = 1e6;
constexpr int max_passes = 100'000;

void check_thresholds(const PhaseThresholds& t) {
    require(t.collapse_quality >= 0 && t.collapse_quality < 1, "phases.collapse_quality",
            t.collapse_quality, "0 to 1, 1 excluded");
    require(t.smooth_quality >= 0 && t.smooth_quality <= 1, "phases.smooth_quality",
            t.smooth_quality, "0 to 1");
    require(t.shortest >= 0, "phases.shortest", t.shortest, "0 or more, in edge lengths");
    require(t.crowded >= 0 && t.crowded <= 2, "phases.crowded", t.crowded,
            "0 to 2, in edge lengths");
    require(t.longest > 2 * t.shortest && t.longest <= max_lengths, "phases.longest", t.longest,
            "more than twice phases.shortest, or splits and collapses undo each other; up to 1e6");
}

} // namespace

template <class Real>
void check_options(const Options<Real>& options) {
    require(std::isfinite(options.edge_length) && options.edge_length > 0, "edge_length",
            static_cast<double>(options.edge_length), "a positive finite length");
    require(static_cast<double>(options.edge_length) >= min_edge_length<Real> &&
                static_cast<double>(options.edge_length) <= max_edge_length<Real>,
            "edge_length", static_cast<double>(options.edge_length),
            sizeof(Real) == sizeof(double) ? "1e-50 to 1e50; scale other scenes with choose_frame"
                                           : "1e-5 to 1e5; scale other scenes with choose_frame");
    check_sizes(options.sizes, options.edge_length);
    check_thresholds(options.phases);
    for (const auto& thresholds : options.per_phase) {
        check_thresholds(thresholds);
    }
    const auto& i = options.interface;
    require(i.shortest >= 0, "interface.shortest", i.shortest, "0 or more, in edge lengths");
    require(
        i.longest > 2 * i.shortest && i.longest <= max_lengths, "interface.longest", i.longest,
        "more than twice interface.shortest, or splits and collapses undo each other; up to 1e6");
    require(i.deviation >= 0 && i.deviation <= max_lengths, "interface.deviation", i.deviation,
            "0 to 1e6, in edge lengths");
    require(i.degenerate >= 0 && i.degenerate <= max_lengths, "interface.degenerate", i.degenerate,
            "0 to 1e6, in deviations");
    require(i.feature_degrees > 0 && i.feature_degrees <= 180, "interface.feature_degrees",
            i.feature_degrees, "more than 0, up to 180 degrees");
    require(i.grading == 0 || (i.grading >= 2 && i.grading <= max_lengths), "interface.grading",
            i.grading, "0, or 2 to 1e6");
    require(i.turn_degrees == 0 || (i.turn_degrees >= 1 && i.turn_degrees <= 180),
            "interface.turn_degrees", i.turn_degrees, "0, or 1 to 180 degrees");
    require(i.gap == 0 || (i.gap >= 0.1 && i.gap <= max_lengths), "interface.gap", i.gap,
            "0, or 0.1 to 1e6");
    require(i.finest > 0 && i.finest <= 1, "interface.finest", i.finest,
            "more than 0, up to 1, in edge lengths");
    require(options.tolerance > 0 && options.tolerance <= max_lengths, "tolerance",
            options.tolerance, "more than 0, up to 1e6, in edge lengths");
    require(options.sub_step > 0 && options.sub_step <= 2, "sub_step", options.sub_step,
            "more than 0, up to 2 edge lengths");
    require(options.max_sub_steps > 0, "max_sub_steps", options.max_sub_steps, "1 or more");
    require(options.max_passes > 0 && options.max_passes <= max_passes, "max_passes",
            options.max_passes, "1 to 100000");
    require(options.max_idle_passes > 0 && options.max_idle_passes <= max_passes, "max_idle_passes",
            options.max_idle_passes, "1 to 100000");
}

template void check_options(const Options<double>&);
template void check_options(const Options<float>&);

} // namespace dsc
