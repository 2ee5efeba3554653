// SPDX-License-Identifier: MIT
// What a scene file says of its exact shape. An [exact] is one of
//
//     back    = true       after the time `period` everything is where it was at the start
//     carried = true       the shapes are carried along by the flow, which must keep areas; it is
//                          followed closely, without any mesh
//     circle  = { centre = [x, y], radius = "formula in t" }
//     scene   = "NAME"     the exact shape of this scene of the catalogue, with the settings
//                          set = ["key=value", ...]; those that are not named are the file's, of a
//                          file that begins as this scene, or else the scene's own but for h;
//                          refused where the file has another shape or motion than that scene
#pragma once

#include "scenes/file/table_reader.h"
#include "scenes/scene.h"
#include "shapes/curve.h"

namespace dsc::scenes {

/// A shape of the scene at the start.
struct FirstShape {
    ParametricCurve curve;
    bool is_hole = false;
};

/// For a setup whose domain and flow are known.
using ExactSource = std::function<std::function<ExactShape(double time)>(
    const Parameters& parameters, const Setup& setup, const std::vector<FirstShape>& shapes)>;

/// `begins_as`: the scene that the file begins as, or empty. Throws InputError.
[[nodiscard]] ExactSource read_exact(const TableReader& reader, const std::vector<Scene>& scenes,
                                     const std::string& begins_as);

} // namespace dsc::scenes
