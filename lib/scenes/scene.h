// SPDX-License-Identifier: MIT
// A scene (thesis, section 9): a shape, a flow, and the shape that an exact method would have at
// any time.
#pragma once

#include "dsc/initial/initial_complex.h"
#include "dsc/motion/curvature_flow.h"
#include "flows/velocity.h"
#include "scenes/keys.h"
#include "shapes/exact_shape.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::scenes {

/// Motion by curvature.
struct CurvatureMotion {
    std::vector<PairCurvature> pairs{}; ///< those of another tension or mobility than 1
    std::vector<Phase> keeps{};         ///< phases whose areas at the start are kept
};

/// Growth along the normal, at a speed that changes its sign once.
struct Growth {
    double speed = 1;    ///< of phase 1 into the exterior
    double turns_at = 0; ///< the time at which it begins to shrink at that speed
};

/// Edges as long as the way from them to the interface divided by their number on it, and none
/// shorter than the finest.
struct EdgesToInterface {
    double finest = 0;
    double number = 0;

    double operator()(double distance) const { return std::max(finest, distance / number); }
};

/// A scene with its parameters filled in.
struct Setup {
    Rectangle domain{};
    std::vector<Outline> outlines{};
    std::vector<Phase> phases{};      ///< of the outlines, in their order; empty: each of phase 1
    std::vector<dsc::Curve> curves{}; ///< in place of outlines: where several phases meet
    bool clamped = false;             ///< where curves end on the domain's sides, they stay
    std::optional<Phase> measured{};  ///< the one whose shape is measured; none: all but 0
    Flow flow{};
    std::optional<CurvatureMotion> curvature{}; ///< replaces `flow`; not for the reference
    std::optional<Growth> growth{};             ///< the same
    SizeOptions<double> sizes{}; ///< targets of edges; unless edges are all of one length
    double dt = 0;
    int steps = 0;                  ///< in total
    std::optional<int> half_step{}; ///< the step at which a reversing flow is farthest out
    /// What errors are measured against: the first outlines moved rigidly, or the smooth shape of
    /// the scene. Empty if it is unknown; at times when it is unknown, a shape whose area is NaN.
    std::function<ExactShape(double time)> exact{};

    /// The interface moves by its own geometry.
    [[nodiscard]] bool sees_interface() const { return curvature || growth; }
};

struct Scene {
    std::string name;
    std::string description;
    std::string section; ///< the section of the thesis that it comes from
    Parameters defaults{};
    std::function<Setup(const Parameters&)> prepare;
    std::vector<std::string> keys = common_keys(); ///< the keys that --set accepts
    bool counts_steps_each_way = false; ///< the key `steps`; otherwise it counts them all
};

} // namespace dsc::scenes
