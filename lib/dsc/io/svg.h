// SPDX-License-Identifier: MIT
// Pictures of a complex as SVG (thesis, section 8.11): triangles coloured by phase or by something
// else, the interface bold, places marked.
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dsc {

/// An upright rectangle, in units of the domain.
struct SvgBox {
    double low_x = 0; ///< the corner of the smallest coordinates
    double low_y = 0;
    double high_x = 1; ///< the corner of the largest coordinates
    double high_y = 1;
};

/// Colours of triangles by something other than their phase: a number, or which group they are in.
struct SvgFill {
    std::string name;                 ///< class names in the file are name-0, name-1, ...
    std::vector<std::string> colours; ///< as in CSS
    /// By id of the triangle: a position in `colours`; beyond the last one, it is grey.
    std::vector<std::uint32_t> of;
};

/// A place that is pointed out by a ring.
struct SvgMark {
    double x = 0; ///< in units of the domain
    double y = 0;
    std::string text{}; ///< its tooltip
};

/// From dark blue at `low` and below to yellow at `high` and above, in 32 steps of equal lightness
/// (the map viridis, readable by the colour-blind and in grey). NaN is grey. Throws InputError
/// unless low < high, both finite.
[[nodiscard]] SvgFill fill_by_value(std::string name, std::span<const double> values, double low,
                                    double high);

/// A colour for each number, the palette again and again; negative numbers are grey.
[[nodiscard]] SvgFill fill_by_number(std::string name, std::span<const std::int32_t> numbers);

/// How a picture looks.
struct SvgOptions {
    double size_px = 800;                     ///< the longer side of the picture
    double margin_px = 10;                    ///< around it
    double edge_width_px = 0.5;               ///< 0: no edges but those of the interface
    double interface_width_px = 2;            ///< 0: no interface
    std::string edge_colour = "#888888";      ///< as SVG and CSS write colours
    std::string interface_colour = "#000000"; ///< the same
    /// The fill of each phase. The first entry is the exterior's; phases beyond the list use the
    /// other entries again. The default is the colour-blind palette of Okabe and Ito (2008).
    std::vector<std::string> phase_colours{"#ffffff", "#56b4e9", "#e69f00", "#009e73",
                                           "#cc79a7", "#f0e442", "#0072b2", "#d55e00"};
    /// The part of the plane to show; empty: all living vertices. The frames of a film need a
    /// fixed one.
    std::optional<SvgBox> view{};
    std::string title{}; ///< empty: none
    /// In place of the colours of phases. One entry for each triangle id.
    std::optional<SvgFill> fill{};
    std::vector<SvgMark> marks{};        ///< on top of everything else
    std::string mark_colour = "#d55e00"; ///< of the rings
};

/// Writes the picture, y upwards. The file exists as a whole or not at all. O(n log phases).
/// Throws FileError where it cannot be written, InputError where the options do not make sense.
template <class Real>
void write_svg(const Complex<Real>& complex, const std::string& path,
               const SvgOptions& options = {});

} // namespace dsc
