// SPDX-License-Identifier: MIT
// The tables of a scene file that become parts of a setup, one function for each.
#pragma once

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

/// An outline of the domain.
struct DomainOutline {
    OutlineSource source;
    std::vector<std::string> sides{}; ///< one name for all edges, or one for each; empty: none
    std::string where{};              ///< of `sides`, for errors
};

/// An [exact]. It is one of
///
///     back = true          after the time `period` the shapes are those of the start
///     advected = true      the shapes are advected accurately, without a mesh, by the flow, which
///                          must conserve areas
struct ExactSource {
    bool is_advected = false;
    std::string where; ///< for errors
};

/// The name of a scene; by default that of its file. The names of frames contain it, so it must not
/// contain a path.
[[nodiscard]] std::string read_name(const TableReader& top);

[[nodiscard]] Rectangle read_domain(const TableReader& reader);
/// Outlines of a domain that is no rectangle, from `outline`. Their pieces are rings: holes,
/// islands and parts by the even-odd rule.
[[nodiscard]] std::vector<DomainOutline> read_domain_outline(const TableReader& reader);
[[nodiscard]] ShapeSource read_shape(const TableReader& reader);
/// Reads the [shape] with `labels`, and the file that it names.
[[nodiscard]] std::shared_ptr<const LabelImage> read_label_image(const TableReader& reader);
[[nodiscard]] CurveSource read_curve(const TableReader& reader);
[[nodiscard]] CurvatureMotion read_curvature(const TableReader& reader);
[[nodiscard]] Growth read_growth(const TableReader& reader);
[[nodiscard]] ExactSource read_exact(const TableReader& reader);
/// Reads [sizes]; the result gives the sizes for parameters, whose h is the shortest target.
[[nodiscard]] std::function<SizeOptions<double>(const Parameters& parameters)>
read_sizes(const TableReader& reader);
/// Sets the parameters in the table [options] of a scene file; `keys` are the allowed ones. Throws
/// InputError if neither the file nor its scene of the catalogue gives an edge length.
void read_options(const TableReader& top, const std::vector<std::string>& keys,
                  Parameters& parameters);

/// Throws InputError for a scene of the catalogue with so many grains that preparing it takes long.
void check_grains(const Scene& scene, const Parameters& parameters, const std::string& where);

/// Fills in `outlines` and `phases`. Throws InputError for lines that enclose nothing.
void add_shapes(const std::vector<ShapeSource>& shapes, double edge_length, Setup& setup);
/// Fills in `curves`; closed ones repeat their first point.
void add_curves(const std::vector<CurveSource>& curves, double edge_length, Setup& setup);
/// Fills in `exact` for known shapes and flows. Throws InputError for shapes of several phases, and
/// for a setup without the needed flow or period.
void set_exact(const ExactSource& exact, const std::vector<ShapeSource>& shapes, double period,
               double edge_length, Setup& setup);

} // namespace dsc::scenes
