// SPDX-License-Identifier: MIT
// A scene of the catalogue as the text of a scene file that begins as this scene and names all of
// its options, with what is allowed: to be changed, and to be added to. Numbers have the digits
// that read back as the same bits, so the file runs to the same mesh.
#pragma once

#include "scenes/scene.h"

#include <string>

namespace dsc::scenes {

/// With these values of the options.
[[nodiscard]] std::string describe(const Scene& scene, const Parameters& parameters);

} // namespace dsc::scenes
