// SPDX-License-Identifier: MIT
// The tables of a scene file that become parts of a setup, one function for each.
#pragma once

#include "scenes/file/exact_source.h"
#include "scenes/file/outlines/outline_source.h"
#include "scenes/file/scene_file.h"

namespace dsc::scenes {

/// A [[shape]].
struct ShapeSource {
    OutlineSource source;
    Phase phase = 1;
    Phase hole_phase = exterior_phase;
    std::string where; ///< for errors
};

/// A [[curve]].
struct CurveSource {
    OutlineSource source;
    Phase left = 1;
    Phase right = exterior_phase;
};

[[nodiscard]] Rectangle read_domain(const TableReader& reader);
[[nodiscard]] ShapeSource read_shape(const TableReader& reader);
[[nodiscard]] CurveSource read_curve(const TableReader& reader);
[[nodiscard]] CurvatureMotion read_curvature(const TableReader& reader);
[[nodiscard]] Growth read_growth(const TableReader& reader);
/// A [sizes], given the parameters: their h is the shortest target.
[[nodiscard]] std::function<SizeOptions<double>(const Parameters& parameters)>
read_sizes(const TableReader& reader);
/// Sets the parameters that the table names; `keys` are those that it may.
void read_options(const TableReader& reader, const std::vector<std::string>& keys,
                  Parameters& parameters);

/// Throws InputError for a scene of the catalogue with so many grains that preparing it takes long.
void check_grains(const Scene& scene, const Parameters& parameters, const std::string& where);

/// Fills in `outlines` and `phases`. Throws InputError for open lines.
void add_shapes(const std::vector<ShapeSource>& shapes, double edge_length, Setup& setup);
/// Fills in `curves`; closed ones repeat their first point.
void add_curves(const std::vector<CurveSource>& curves, double edge_length, Setup& setup);
/// The shapes as curves, for exact solutions: smooth where they are known as such. Throws
/// InputError for several phases.
[[nodiscard]] std::vector<FirstShape> first_shapes(const std::vector<ShapeSource>& shapes,
                                                   const Setup& setup);

} // namespace dsc::scenes
