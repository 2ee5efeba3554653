// SPDX-License-Identifier: MIT
// The scene that a command line or a checkpoint names: one of the list, or a file.
#pragma once

#include "scenes/file/scene_file.h"
#include "scenes/run/checkpoint.h"

#include <string>
#include <vector>

namespace dsc::scenes {

/// The text of a scene file; empty for a scene of the list. Throws InputError, naming the scenes,
/// for what is neither.
[[nodiscard]] std::string text_of_scene(const std::string& name, const std::vector<Scene>& scenes);

/// The scene, from the text that the origin has. Throws InputError as read_scene_text does, also
/// for files that the scene names and that cannot be read.
[[nodiscard]] SceneFile scene_of(const RunOrigin& origin, const std::vector<Scene>& scenes);

} // namespace dsc::scenes
