// SPDX-License-Identifier: MIT
// All scenes of this project. An application has a list of its own, with these in it or not.
#pragma once

#include "scenes/scene.h"

namespace dsc::scenes {

/// In the order of the thesis.
[[nodiscard]] const std::vector<Scene>& catalogue();

/// Throws InputError, naming all scenes of the list, where there is none of that name.
[[nodiscard]] const Scene& find_scene(const std::string& name,
                                      const std::vector<Scene>& scenes = catalogue());

/// Thresholds of the scenes in which speed is the question: interface edges as long as those inside
/// the phases. A shape wants shorter ones.
[[nodiscard]] InterfaceThresholds coarse_interface();

} // namespace dsc::scenes
