// SPDX-License-Identifier: MIT
// All scenes of this project. An application has its own list, with or without these.
#pragma once

#include "scenes/scene.h"

namespace dsc::scenes {

/// In the order of the thesis, then fluids.
[[nodiscard]] const std::vector<Scene>& catalogue();

/// Throws InputError, naming all scenes of the list, if there is none of that name.
[[nodiscard]] const Scene& find_scene(const std::string& name,
                                      const std::vector<Scene>& scenes = catalogue());

/// Thresholds of the scenes for measuring speed: interface edges as long as those inside the
/// phases. Scenes that judge a shape use shorter ones.
[[nodiscard]] InterfaceThresholds coarse_interface();

} // namespace dsc::scenes
