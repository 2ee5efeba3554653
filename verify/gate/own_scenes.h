// SPDX-License-Identifier: MIT
// Scenes of your own in the gate: those of scene files, held to their [limits] and to the checks
// for which the limits file has a limit of theirs.
#pragma once

#include "checks.h"

#include <string>
#include <vector>

namespace dsc::gate {

/// Throws what read_scene_file throws, and InputError for two files of the same name of scene.
[[nodiscard]] std::vector<scenes::SceneFile> read_scenes(const std::vector<std::string>& paths);

/// The checks of the files' [limits], named after the keys: `limits.sd_rel_last`, or
/// `limits.area_ratio.least` where both bounds are given. Adds their limits to `limits`.
[[nodiscard]] std::vector<Check> checks_of_files(const std::vector<scenes::SceneFile>& files,
                                                 Limits& limits);

/// Which of these checks are made of which scenes: those that have a limit. Throws InputError for a
/// limit of a figure that the scene has no number for.
[[nodiscard]] std::vector<Task> tasks_of_files(const std::vector<const Check*>& checks,
                                               const std::vector<scenes::SceneFile>& files,
                                               const Limits& limits);

/// Throws InputError for a scene that has no limit at all, or none in the limits file that is
/// given.
void check_has_limits(const std::vector<scenes::SceneFile>& files, const Limits& limits,
                      bool has_limits_file);

/// Why these figures cannot be had from the scene; empty if they can.
[[nodiscard]] std::string why_not(const std::vector<std::string>& figures,
                                  const scenes::SceneFile& file);

} // namespace dsc::gate
