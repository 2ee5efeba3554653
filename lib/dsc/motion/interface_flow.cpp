// SPDX-License-Identifier: MIT
#include "dsc/motion/interface_flow.h"

#include "dsc/geometry/points.h"

#include "dsc/motion/interpolation.h"

#include <algorithm>

namespace dsc {

template <class Real>
std::span<const InterfaceArm> arms_of(const InterfaceView<Real>& view, std::size_t i) {
    if (!view.is_junction(i)) {
        return {};
    }
    const auto found = std::ranges::lower_bound(view.junctions, i);
    const auto k = static_cast<std::size_t>(found - view.junctions.begin());
    return view.arms.subspan(view.arm_begin[k], view.arm_begin[k + 1] - view.arm_begin[k]);
}

template <class Real>
bool borders_on(const InterfaceView<Real>& view, std::size_t i, Phase phase) {
    return view.left[i] == phase || view.right[i] == phase ||
           std::ranges::any_of(arms_of(view, i), [phase](const InterfaceArm& arm) {
               return arm.left == phase || arm.right == phase;
           });
}

template <class Real>
Point<Real> normal(const InterfaceView<Real>& view, std::size_t i) {
    if (view.is_junction(i)) {
        return Point<Real>::Zero();
    }
    const Point<Real> in = view.positions[i] - view.positions[view.previous[i]];
    const Point<Real> out = view.positions[view.next[i]] - view.positions[i];
    const Real before = in.norm();
    const Real after = out.norm();
    if (!(before > 0) || !(after > 0)) {
        return Point<Real>::Zero();
    }
    // A chord leaves a circle at an angle whose sine is proportional to its length: weighted by the
    // inverse lengths the two unit chords add up to the tangent.
    const Point<Real> tangent = (after / before) * in + (before / after) * out;
    const Real size = tangent.norm();
    return size > 0 ? Point<Real>(tangent.y() / size, -tangent.x() / size)
                    : Point<Real>(Point<Real>::Zero());
}

template <class Real>
Real curvature(const InterfaceView<Real>& view, std::size_t i) {
    return view.is_junction(i) ? Real(0)
                               : curvature<Real>(view.positions[view.previous[i]],
                                                 view.positions[i], view.positions[view.next[i]]);
}

template <class Real>
Real length(const InterfaceView<Real>& view, std::size_t i) {
    const auto to = [&](std::uint32_t neighbour) {
        return (view.positions[neighbour] - view.positions[i]).norm();
    };
    Real sum = 0;
    if (!view.is_junction(i)) {
        sum = to(view.previous[i]) + to(view.next[i]);
    }
    for (const InterfaceArm& arm : arms_of(view, i)) {
        sum += to(arm.neighbour);
    }
    return sum / 2;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::span<const InterfaceArm> arms_of(const InterfaceView<Real>&, std::size_t);       \
    template bool borders_on(const InterfaceView<Real>&, std::size_t, Phase);                      \
    template Point<Real> normal(const InterfaceView<Real>&, std::size_t);                          \
    template Real curvature(const InterfaceView<Real>&, std::size_t);                              \
    template Real length(const InterfaceView<Real>&, std::size_t);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
