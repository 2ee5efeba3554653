// SPDX-License-Identifier: MIT
// A scene in one file of TOML (https://toml.io), for scenes of your own. Only [options] is needed.
// Headers named beside tables describe them.
//
//     name = "my-scene"           # in result files; by default the file's name
//     scene = "swirl"             # starts from this scene of the catalogue; the tables below
//                                 # replace its parts; its exact shape is kept unless the shape or
//                                 # the motion is replaced
//     advected = [phases]         # phases whose inside moves with the flow
//     [domain]                    # low = [0, 0], high = [1, 1]; or outline = a source, or a list
//                                 # of them (outline_source.h): the domain is inside by the
//                                 # even-odd rule and takes shapes only; with a source, sides = a
//                                 # name for its edges, or a list with one for each, of which the
//                                 # first edge is that from the first point to the second;
//                                 # clamped = true: the ends of curves on the sides do not move
//     [[shape]]                   # phase = 1, hole_phase = 0, and a source (outline_source.h): by
//                                 # the even-odd rule for its closed lines
//     [shape]                     # labels = "FILE": an image of phases, spread over the domain
//                                 # (label_file.h); min_pixels = N: smaller grains go to their
//                                 # neighbours
//     [[curve]]                   # left, right: the phases beside it, and a source; instead of
//                                 # shapes if several phases meet
//     [flow]                      # flow_source.h
//     [curvature]                 # keeps = [phases], pairs = [{one, other, tension, mobility}]
//     [growth]                    # speed, turns_at: phase 1 into 0 (scene.h)
//     [fluid]                     # fluid_source.h
//     [options]                   # all keys of --set; h, and two of dt, steps and period
//     [sizes]                     # with `grade`: edges_to_interface = the number of edges from
//                                 # any point to the interface; longest = the largest length;
//                                 # shortest = the lower bound of the formulas below, if it is
//                                 # less than h; by_phase = [lengths], or by_place = a formula in
//                                 # x, y, t and h; on_interface = a formula for interface edges
//     [exact]                     # scene_parts.h
//     [measure]                   # phase: the one whose shape is measured; by default all but 0;
//                                 # shape = false: not compared with the exact one
//     [limits]                    # figure = max, or figure = { min, max }: names as in result
//                                 # files, such as sd_rel_last, area_ratio, inverted,
//                                 # jaggedness_last.largest_excess_deg and, of a fluid,
//                                 # force_x_SIDE_last and energy_last. `dsc_verify run FILE`
//                                 # checks them
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

/// Reads a scene and the files that it names, relative to its own folder. Writes nothing; the scene
/// reads no files later. Throws InputError with file, line, key, value and what is allowed;
/// FileError for a file that cannot be read.
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& path,
                                        const std::vector<Scene>& scenes = catalogue());

/// The same from a text; errors call it `path`.
[[nodiscard]] SceneFile read_scene_text(const std::string& text, const std::filesystem::path& path,
                                        const std::vector<Scene>& scenes = catalogue());

/// Whether the name is that of a file rather than of a scene: it has a slash, or ends in .toml.
[[nodiscard]] bool is_scene_file(const std::string& name);

} // namespace dsc::scenes
