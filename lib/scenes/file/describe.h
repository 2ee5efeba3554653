// SPDX-License-Identifier: MIT
// A scene as the text of a scene file, in full: the user sees what it consists of, and every part
// can be changed. Outlines and curves are points, cut for the scene's own h; flows have their names
// and parameters; numbers have the digits that read back as the same bits. So the file runs to the
// same mesh as the scene. Only the exact shape stays the scene's own: [exact] scene = "NAME".
//
// Not in the file are the keys that shape the scene itself (period, angle, grains): what they led
// to is.
#pragma once

#include "scenes/scene.h"

#include <string>

namespace dsc::scenes {

/// Throws InputError for a scene whose flow is neither one of flows/velocity.h nor a formula.
[[nodiscard]] std::string describe(const Scene& scene, const Parameters& parameters);

} // namespace dsc::scenes
