// SPDX-License-Identifier: MIT
#include "fluid/interface/even_spacing.h"

#include <algorithm>

namespace dsc {

namespace {

bool can_slide(const InterfaceView<double>& view, std::size_t i) { return view.flags[i] == 0; }

// The curve from a vertex to the next one, at least one of which can slide and therefore has two
// neighbours.
CurveNeighbours<double> curve_between(const InterfaceView<double>& view,
                                      std::span<const Point<double>> targets, std::uint32_t from,
                                      std::uint32_t to) {
    CurveNeighbours<double> curve;
    curve.p1 = targets[from];
    curve.p2 = targets[to];
    curve.has_first = can_slide(view, from);
    curve.has_last = can_slide(view, to);
    if (curve.has_first) {
        curve.p0 = targets[view.previous[from]];
    }
    if (curve.has_last) {
        curve.p3 = targets[view.next[to]];
    }
    return curve;
}

// The target of a vertex after it slides towards the longer of its two edges.
Point<double> slid(const InterfaceView<double>& view, std::span<const Point<double>> targets,
                   std::uint32_t i) {
    const std::uint32_t previous = view.previous[i];
    const std::uint32_t next = view.next[i];
    const double before = (targets[i] - targets[previous]).norm();
    const double after = (targets[next] - targets[i]).norm();
    if (before == after) {
        return targets[i];
    }
    const double way = (after - before) / 4;
    return way > 0 ? curve_point(curve_between(view, targets, i, next), way / after)
                   : curve_point(curve_between(view, targets, previous, i), 1 + way / before);
}

} // namespace

void space_evenly(const InterfaceView<double>& view, std::span<Point<double>> targets) {
    std::vector<Point<double>> spaced(targets.begin(), targets.end());
    for (std::uint32_t i = 0; i < view.size(); ++i) {
        if (can_slide(view, i)) {
            spaced[i] = slid(view, targets, i);
        }
    }
    std::ranges::copy(spaced, targets.begin());
}

} // namespace dsc
