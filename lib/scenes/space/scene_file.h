// SPDX-License-Identifier: MIT
// Scene files in three dimensions (TOML):
//
//     scene = "enright"          # optional: starts from this scene of `dsc_scene list`
//     name  = "mine"             # in results; by default the file's name
//
//     [domain]
//     size = [1, 1, 1]           # three numbers, which make the scene three-dimensional
//     low  = [0, 0, 0]           # the corner with the smallest coordinates; this is the default
//
//     [shape]                    # or several [[shape]]: inside each other, the later one counts
//     sphere    = { centre = [0.3, 0.3, 0.3], radius = 0.15 }    # or one of the next
//     box       = { low = [0.2, 0.2, 0.2], high = [0.4, 0.5, 0.4] }
//     ellipsoid = { centre = [0.5, 0.5, 0.5], radii = [0.3, 0.2, 0.1] }
//     torus     = { centre = [0.5, 0.5, 0.5], axis = [0, 0, 1], radius = 0.25, tube = 0.1 }
//     file      = "bunny.stl"    # closed; also .ply, .obj; relative to the scene file
//     scale, move = 0.01, [0.5, 0.5, 0]     # of the surface in `file`: first scaled, then moved
//     phase     = 1
//     plane     = { point = [0.3, 0.3, 0.3], normal = [1, 0, 0] } # with divides
//     divides   = [1, 2]         # phase 1 becomes 2 inside: in junction curves the surfaces meet
//
//     [flow]                     # formulas in x, y, z, t, the parameters and pi, h, period
//     u, v, w   = "-y", "x", "0"
//     parameters = { s = 0.5 }
//
//     [options]                  # h, dt, steps, period (two of the last three), integrator
//
//     [exact]
//     back = true                # the flow returns the shape to its first place
//
//     [limits]                   # figure = max, or { min, max }: see `figures` of run.h
#pragma once

#include "scenes/file/figure_limits.h"
#include "scenes/space/scene.h"

#include <filesystem>

namespace dsc::scenes::space {

struct SceneFile {
    Scene scene;
    std::vector<FigureLimit> limits{};
    std::vector<std::string> files{}; ///< the files that the scene names
};

/// Whether the text is a scene in three dimensions: its domain has a `size`, or it starts from such
/// a scene. Errors call the text `path`. Throws InputError if it is not TOML.
[[nodiscard]] bool is_in_space(const std::string& text, const std::filesystem::path& path);

/// Reads a scene and the files that it names. Throws InputError with file, line, key, value and
/// what is allowed; FileError for a file that cannot be read.
[[nodiscard]] SceneFile read_scene_text(const std::string& text, const std::filesystem::path& path);

} // namespace dsc::scenes::space
