// SPDX-License-Identifier: MIT
// Pictures of a complex (thesis, section 8.11): as SVG, with triangles coloured by phase or by
// other data, a bold interface and marked positions; and as files for ParaView.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/initial/initial_complex.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace dsc {

// --- as SVG --------------------------------------------------------------------------------------

/// Colours triangles by a number or a group rather than by their phase.
struct SvgFill {
    std::string name;                 ///< class names in the file are name-0, name-1, ...
    std::vector<std::string> colours; ///< as in CSS
    /// By id of the triangle: a position in `colours`; beyond the last one, it is grey.
    std::vector<std::uint32_t> of;
};

/// A place marked by a ring.
struct SvgMark {
    double x = 0; ///< in units of the domain
    double y = 0;
    std::string text{}; ///< its tooltip
};

/// How a picture looks.
struct SvgOptions {
    double size_px = 800;                     ///< the longer side of the picture
    double margin_px = 10;                    ///< around it
    double edge_width_px = 0.5;               ///< 0: only edges of the interface
    double interface_width_px = 2;            ///< 0: no interface
    std::string edge_colour = "#888888";      ///< as SVG and CSS write colours
    std::string interface_colour = "#000000"; ///< the same
    /// The fill of each phase. The first entry is the exterior's; phases beyond the list use the
    /// other entries again. The default is the colour-blind palette of Okabe and Ito (2008).
    std::vector<std::string> phase_colours{"#ffffff", "#56b4e9", "#e69f00", "#009e73",
                                           "#cc79a7", "#f0e442", "#0072b2", "#d55e00"};
    /// The part of the plane to show; empty: all living vertices. The frames of a film need a
    /// fixed one.
    std::optional<Rectangle> view{};
    std::string title{}; ///< empty: none
    /// Replaces the colours of phases. One entry for each triangle id.
    std::optional<SvgFill> fill{};
    std::vector<SvgMark> marks{};        ///< on top of everything else
    std::string mark_colour = "#d55e00"; ///< of the rings
};

/// Writes the picture, y upwards, atomically. O(n log phases). Throws FileError if it cannot be
/// written, InputError if an option is out of range.
template <class Real>
void write_svg(const Complex<Real>& complex, const std::string& path,
               const SvgOptions& options = {});

// --- for ParaView --------------------------------------------------------------------------------
// A complex as a VTK unstructured grid (.vtu), as Kitware's "VTK file formats" describes it:
// numbers are appended in binary, compressed by zlib, in a fifth of the bytes.

/// An array to be written beside the complex's own data.
struct VtuArray {
    std::string name;                       ///< in the file
    SimplexKind kind = SimplexKind::vertex; ///< or triangle; the format has no data of edges
    std::uint32_t components = 1;           ///< 1, or 2 for vectors of the plane
    /// By id: those of id i begin at i * components. Entries of free ids are left out.
    std::variant<std::vector<double>, std::vector<std::int32_t>> values;
};

/// Writes all living vertices and triangles; for each vertex its `position`, for each triangle its
/// `phase` and its `quality` (equation 4 of the thesis); the attributes of vertices and triangles
/// whose entries are numbers (double, float, integers of 8 to 64 bits) or points; and `more`. An
/// attribute whose name is already taken is left out. Numbers read back bitwise identical; vectors
/// get a third component of 0. The file is written atomically. O(n). Throws FileError; InputError
/// where the length or the components of an array are wrong.
template <class Real>
void write_vtu(const Complex<Real>& complex, const std::string& path,
               std::span<const VtuArray> more = {});

} // namespace dsc
