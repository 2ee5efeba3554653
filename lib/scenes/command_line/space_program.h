// SPDX-License-Identifier: MIT
// `dsc_scene run` for a scene in three dimensions.
#pragma once

#include "scenes/command_line/arguments.h"
#include "scenes/space/scene_file.h"

namespace dsc::scenes {

/// Runs the scene, prints and writes its results, and returns the exit code. Throws InputError for
/// options that are not supported in three dimensions.
int run_in_space(const std::string& program, const space::SceneFile& file,
                 const Arguments& arguments, const RunOrigin& origin,
                 const std::optional<Checkpoint>& checkpoint);

} // namespace dsc::scenes
