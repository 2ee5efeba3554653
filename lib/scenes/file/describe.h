// SPDX-License-Identifier: MIT
// A scene of the catalogue as the text of a scene file, to be changed and extended: it starts from
// this scene and lists all options with their allowed values. Numbers have enough digits to be read
// back exactly, so a run of the file gives the same mesh.
#pragma once

#include "scenes/scene.h"

#include <string>

namespace dsc::scenes {

/// The text with these values of the options.
[[nodiscard]] std::string describe(const Scene& scene, const Parameters& parameters);

} // namespace dsc::scenes
