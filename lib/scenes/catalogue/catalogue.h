// SPDX-License-Identifier: MIT
// All scenes of this project. An application has its own list, with or without these.
#pragma once

#include "scenes/scene.h"

namespace dsc::scenes {

/// The scenes in the order of the thesis, then fluids.
[[nodiscard]] const std::vector<Scene>& catalogue();

/// Throws InputError, which lists all scenes, if there is none of that name.
[[nodiscard]] const Scene& find_scene(const std::string& name,
                                      const std::vector<Scene>& scenes = catalogue());

/// Thresholds of the scenes for measuring speed: interface edges are as long as those inside the
/// phases. Scenes that measure shapes use shorter ones.
[[nodiscard]] InterfaceThresholds coarse_interface();

} // namespace dsc::scenes
