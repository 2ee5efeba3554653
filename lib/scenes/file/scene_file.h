// SPDX-License-Identifier: MIT
// A scene in one file of TOML (https://toml.io), for scenes of your own. Only [options] is needed.
// The header that is named beside a table describes what the table holds.
//
//     name = "my-scene"           # of result files; else the file's own
//     scene = "swirl"             # begins as this scene of the catalogue; what follows replaces
//                                 # its parts; its exact shape holds while shape and motion do
//     advected = [phases]          # whose inside moves with the flow
//     [domain]                    # low = [0, 0], high = [1, 1]; clamped = true: the ends of
//                                 # curves on the sides stay where they are
//     [[shape]]                   # phase = 1, hole_phase = 0, and a source (outline_source.h):
//                                 # inside an odd number of its closed lines is the phase
//     [shape]                     # labels = "FILE": an image of phases, spread over the domain
//                                 # (label_file.h); min_pixels = N: smaller grains go to their
//                                 # neighbours
//     [[curve]]                   # left, right: the phases beside it, and a source; in place of
//                                 # shapes, where several phases meet
//     [flow]                      # flow_source.h
//     [curvature]                 # keeps = [phases], pairs = [{one, other, tension, mobility}]
//     [growth]                    # speed, turns_at: phase 1 into 0 (scene.h)
//     [fluid]                     # fluid_source.h
//     [options]                   # all keys of --set; h, and two of dt, steps and period
//     [sizes]                     # where edges grow by `grade`: edges_to_interface = the number
//                                 # wanted on the way there; longest = their greatest length;
//                                 # shortest = the finest that a formula below may ask for, if
//                                 # that is less than h;
//                                 # by_phase = [lengths], or by_place = a formula in x, y, t and
//                                 # h; on_interface = one for the interface's own edges
//     [exact]                     # scene_parts.h
//     [measure]                   # phase: whose shape is measured; else all but 0;
//                                 # shape = false: not against the exact one
//     [limits]                    # figure = most, or figure = { least, most }: names as in
//                                 # result files, such as sd_rel_last, area_ratio, inverted and
//                                 # jaggedness_last.largest_excess_deg. `dsc_verify run FILE`
//                                 # judges them
#pragma once

#include "scenes/catalogue/catalogue.h"
#include "scenes/file/figure_limits.h"

#include <filesystem>

namespace dsc::scenes {

struct SceneFile {
    Scene scene;
    std::vector<FigureLimit> limits{};
    std::vector<std::string> outlines{}; ///< the files that it names
};

/// Reads a scene and the files that it names, relative to its own folder. Nothing is written, and
/// what the scene computes later depends on these texts alone. Throws InputError with file, line,
/// key, value and what is allowed; FileError for a file that cannot be read.
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& path,
                                        const std::vector<Scene>& scenes = catalogue());

/// The same from a text that is called `path` in errors.
[[nodiscard]] SceneFile read_scene_text(const std::string& text, const std::filesystem::path& path,
                                        const std::vector<Scene>& scenes = catalogue());

/// True for what names a file rather than a scene: with a slash, or ending in .toml.
[[nodiscard]] bool is_scene_file(const std::string& name);

} // namespace dsc::scenes
