// SPDX-License-Identifier: MIT
// Scenes of one's own in three dimensions, as TOML:
//
//     scene = "enright"          # to begin with one of `dsc_scene list`; unless given, all is here
//     name  = "mine"             # of results; unless given, the file's
//
//     [domain]
//     size = [1, 1, 1]           # three numbers: what makes it a scene in three dimensions
//     low  = [0, 0, 0]           # the corner of the smallest coordinates, unless it is this one
//
//     [shape]                    # or [[shape]], several: of those within each other the later
//     counts sphere    = { centre = [0.3, 0.3, 0.3], radius = 0.15 }                   # or one of
//     box       = { low = [0.2, 0.2, 0.2], high = [0.4, 0.5, 0.4] }
//     ellipsoid = { centre = [0.5, 0.5, 0.5], radii = [0.3, 0.2, 0.1] }
//     torus     = { centre = [0.5, 0.5, 0.5], axis = [0, 0, 1], radius = 0.25, tube = 0.1 }
//     file      = "bunny.stl"    # closed; also .ply, .obj; relative to the scene file
//     scale, move = 0.01, [0.5, 0.5, 0]     # of what a file holds: first scaled, then moved
//     phase     = 1
//
//     [flow]                     # formulas in x, y, z, t, the parameters and pi, h, period
//     u, v, w   = "-y", "x", "0"
//     parameters = { s = 0.5 }
//
//     [options]                  # h, dt, steps, period (two of the last three), integrator
//
//     [exact]
//     back = true                # the flow leads the shape back to where it was
//
//     [limits]                   # figure = most, or { least, most }: see `figures` of run.h
#pragma once

#include "scenes/file/figure_limits.h"
#include "scenes/space/scene.h"

#include <filesystem>

namespace dsc::scenes::space {

struct SceneFile {
    Scene scene;
    std::vector<FigureLimit> limits{};
    std::vector<std::string> files{}; ///< that it names
};

/// Whether the text, which is called `path` in errors, is a scene in three dimensions: its domain
/// has a size, or it begins with a scene that is one. Throws InputError for what is no TOML.
[[nodiscard]] bool is_in_space(const std::string& text, const std::filesystem::path& path);

/// Reads a scene and the files that it names. Throws InputError with file, line, key, value and
/// what is allowed; FileError for a file that cannot be read.
[[nodiscard]] SceneFile read_scene_text(const std::string& text, const std::filesystem::path& path);

} // namespace dsc::scenes::space
