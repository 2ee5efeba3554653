// SPDX-License-Identifier: MIT
// The program behind dsc_scene, for any list of scenes.
#pragma once

#include "scenes/scene.h"

namespace dsc::scenes {

/// NAME list
/// NAME describe SCENE [--set key=value]...
/// NAME run SCENE|FILE.toml [--set key=value]... [--strategy S] [--submeshes M] [--threads N]
///                [--frames DIR] [--json FILE] [--checkpoint FILE] [--every N] ...
/// NAME run --resume FILE [--threads N] ...
/// Exit: 0 success; 1 the run broke an invariant or could not write its results; 2 bad usage.
/// Results go to stdout, errors to stderr, one line each that begins with the program's name.
int scene_program(const std::string& program, const std::vector<Scene>& scenes, int argc,
                  const char* const* argv);

} // namespace dsc::scenes
