// SPDX-License-Identifier: MIT
// A scene as the text of a scene file, in full: the user sees what it consists of, and every part
// can be changed. Outlines and curves are points, cut for the scene's own h; flows have their names
// and parameters; numbers have the digits that read back as the same bits. So the file runs to the
// same mesh as the scene. Only the exact shape stays the scene's own: [exact] scene = "NAME", which
// is refused once the shape or the motion has been changed.
//
// Not in the file are the exact height of a fluid's small wave or neck, and the keys that shape the
// scene itself (angle, grains): what they led to is. The measures are all named, so that those of
// no interest can be struck out.
#pragma once

#include "scenes/file/scene_file.h"

#include <string>

namespace dsc::scenes {

/// Throws InputError for a scene whose flow is neither one of flows/velocity.h nor a formula.
[[nodiscard]] std::string describe(const Scene& scene, const Parameters& parameters);

/// The same of a scene that was read from a file, with its measures, limits and exact shape. Shapes
/// have become points, so an exact shape that is made from the first ones (`back`, `carried`) is
/// that of the points.
[[nodiscard]] std::string describe(const SceneFile& file, const Parameters& parameters);

} // namespace dsc::scenes
