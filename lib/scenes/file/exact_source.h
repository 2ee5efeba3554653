// SPDX-License-Identifier: MIT
// What a scene file says of its exact shape. An [exact] is one of
//
//     back    = true       after the time `period` everything is where it was at the start
//     carried = true       the shapes are carried along by the flow, which must keep areas; it is
//                          followed closely, without any mesh
//     circle  = { centre = [x, y], radius = "formula in t" }
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

/// Throws InputError.
[[nodiscard]] ExactSource read_exact(const TableReader& reader);

} // namespace dsc::scenes
