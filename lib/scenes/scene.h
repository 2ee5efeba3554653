// SPDX-License-Identifier: MIT
// The catalogue [thesis 9]: each scene is a shape, a flow, and the shape that an exact method would
// have at any time.
#pragma once

#include "dsc/initial/initial_complex.h"
#include "flows/exact.h"
#include "scenes/parameters.h"
#include "flows/velocity.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::scenes {

/// A scene with its parameters filled in.
struct Setup {
    Rectangle domain;
    std::vector<Outline> outlines; ///< each of phase 1
    Flow flow;
    double dt = 0;
    int steps = 0;                ///< in all
    std::optional<int> half_step; ///< the step at which a reversing flow is farthest out
    /// What is judged: the first outlines carried rigidly, or the smooth shape of the scene.
    std::function<ExactShape(double time)> exact;
};

struct Scene {
    std::string name;
    std::string description;
    std::string section;           ///< where it comes from
    std::vector<std::string> keys; ///< what --set takes
    Parameters defaults;
    std::function<Setup(const Parameters&)> prepare;
};

/// Thresholds of the scenes in which speed is the question: interface edges as long as those inside
/// the phases. A shape wants shorter ones.
[[nodiscard]] InterfaceThresholds coarse_interface();

/// All scenes, in the order of the thesis.
[[nodiscard]] const std::vector<Scene>& catalogue();

/// Throws InputError, naming all scenes, where there is none of that name.
[[nodiscard]] const Scene& find_scene(const std::string& name);

} // namespace dsc::scenes
