// SPDX-License-Identifier: MIT
// The complex that a scene starts from (thesis, section 5.6 and chapter 9): a rectangle with any
// number of simple polygons, each with its phase, or with a network of curves that meet each other
// and the sides of the rectangle, triangulated at a target edge length. A lattice of
// near-equilateral triangles is laid over the rectangle; only the part near the interface is
// searched, changed or improved, unless edges grow away from it.
//
// The result is a constrained Delaunay triangulation (up to `delaunay_slack`) whose interface
// consists of the outlines or curves and nothing else.
#pragma once

#include "dsc/base/names.h"
#include "dsc/complex/complex.h"
#include "dsc/sizes/sizes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace dsc {

/// A polygon and the phase inside it. Rings may run either way, repeat their first point at the
/// end, touch each other and reach beyond the domain, but not cross.
struct Shape {
    std::vector<Point<double>> outline; ///< its first ring
    Phase phase = 1;                    ///< differs from the phase around the shape
    /// Further rings: by the even-odd rule, holes in the outline, islands in these, and other
    /// parts.
    std::vector<std::vector<Point<double>>> holes = {};
    std::string name = {}; ///< in messages; empty: its number, as in "shape 0"
};

/// A piece of the interface between two junctions, or a closed curve.
struct Curve {
    std::vector<Point<double>> points; ///< two or more; a closed curve repeats its first at the end
    Phase left = 1;                    ///< of the region on its left
    Phase right = exterior_phase;      ///< differs from the one on the left
};

/// A rectangle with sides parallel to the axes.
struct Rectangle {
    Point<double> low{0.0, 0.0};  ///< the corner of the smallest coordinates
    Point<double> high{1.0, 1.0}; ///< the corner of the largest coordinates
};

/// A domain of any shape. Rings may run either way and repeat their first point at the end, but not
/// cross or touch.
struct Polygon {
    /// Not an aggregate: `{}` is a rectangle.
    Polygon(std::vector<Point<double>> ring, std::vector<std::vector<Point<double>>> further = {})
        : outline(std::move(ring)), holes(std::move(further)) {}

    std::vector<Point<double>> outline; ///< its first ring
    /// Further rings: by the even-odd rule, holes in the outline, islands in these, and other
    /// parts.
    std::vector<std::vector<Point<double>>> holes;
};

// --- the frame -----------------------------------------------------------------------------------
// The units in which a scene is run whose coordinates are very large, very small, or far from the
// origin: the passes of the algorithm multiply up to six lengths, so that doubles would run out of
// exponents from about 1e-50 and 1e50 on, and out of digits far away. The application gives the
// library coordinates of a frame, and lengths and velocities divided by its unit:
//
//     world = origin + unit * coordinate

/// The origin and the unit of coordinates.
struct Frame {
    Point<double> origin{0.0, 0.0}; ///< in world coordinates
    double unit = 1;                ///< in world coordinates; a power of two: dividing is exact
};

/// The frame in which the larger side of the box from `low` to `high` is 1 to 2 long. An axis on
/// which the box lies at least its own size away from zero is shifted by its end next to zero; the
/// difference of two such coordinates is exact (P. H. Sterbenz, "Floating-point computation",
/// 1974). Throws InputError where a coordinate is not finite, the box is empty, or its size lies
/// beyond 1e-290 to 1e290.
[[nodiscard]] Frame choose_frame(const Point<double>& low, const Point<double>& high);

// --- the complex ---------------------------------------------------------------------------------

/// The treatment of detail that is finer than the mesh, where triangles would remain needles. The
/// edge length in these rules is the shortest target that `sizes` allows on the interface.
enum class Detail : std::uint8_t {
    /// Points at edges below 0.2 edge lengths are left out, if the interface stays within 0.1 edge
    /// lengths of them, and the area on each side of a curve within 0.001 edge lengths times its
    /// length, and within 0.001 of the area inside it. If neither end of such an edge can be left
    /// out, both are replaced by one point. Shapes that are smaller than the edge length are
    /// dropped.
    thin,
    /// All points and shapes stay. Edges below 0.05 edge lengths and shapes smaller than the edge
    /// length are refused.
    keep,
};

inline constexpr std::array detail_names{
    Named{Detail::thin, "thin"},
    Named{Detail::keep, "keep"},
};

/// The treatment of gaps (regions without a shape, between shapes and sides of the domain, whose
/// mean width is below the edge length) and of overlaps (common regions of two shapes of which
/// neither contains the other).
enum class Coverage : std::uint8_t {
    open,           ///< gaps are of `exterior_phase`, overlaps are refused
    whole,          ///< both are refused
    longest_border, ///< gaps and overlaps are given to the shape with the longest border there
    first,          ///< gaps and overlaps are given to the first such shape of the list
};

inline constexpr std::array coverage_names{
    Named{Coverage::open, "open"},
    Named{Coverage::whole, "whole"},
    Named{Coverage::longest_border, "longest_border"},
    Named{Coverage::first, "first"},
};

/// A report of the detail of shapes or curves that was left out because the mesh is too coarse for
/// it.
struct InputReport {
    std::size_t points = 0;  ///< given
    std::size_t thinned = 0; ///< points left out of the interface
    double deviation = 0;    ///< the largest distance of a left-out point from the interface
    double area_changed = 0; ///< by leaving points out: the sum over curves of the net change
    std::size_t dropped = 0; ///< shapes that are too small
    double area_dropped = 0; ///< of these shapes
    std::size_t clipped = 0; ///< outlines and holes that were cut at the sides of the domain

    friend bool operator==(const InputReport&, const InputReport&) = default;
};

/// A report in words: a sentence for each kind of detail that was left out; empty if there is none.
[[nodiscard]] std::vector<std::string> sentences(const InputReport& report);

/// How fine the first complex is, and how much it is improved.
struct InitialOptions {
    double edge_length = 0.05; ///< the target, in units of the coordinates
    int improve_rounds = 12;   ///< largest number of rounds of improvement near the interface
    /// Longer edges away from the interface. The interface is still cut by `edge_length`.
    SizeOptions<double> sizes = {};
    bool renumber = true;         ///< order ids along a space-filling curve
    Detail detail = Detail::thin; ///< what happens to detail finer than the mesh
    /// Borders of shapes that are nearer to each other than this times the edge length are merged;
    /// 0.001 to 0.1.
    double border_tolerance = 1e-3;
    Coverage coverage = Coverage::open; ///< the treatment of wider gaps and overlaps
};

/// Triangulates `domain` with the outlines of `shapes` as its interface.
///
/// The innermost shape that contains a triangle gives its phase; outside of all it is
/// `exterior_phase`. A shape inside a shape of the same phase is a hole, and so is a shape of
/// `exterior_phase`. Shapes side by side share their border. Parts of shapes beyond the domain are
/// clipped.
///
/// Each edge longer than `edge_length` is cut into ceil(length / edge_length) equal pieces; all
/// vertices at edges of at least 0.2 `edge_length` keep their coordinates exactly (for float: as
/// rounded), except those within `InitialOptions::border_tolerance` of another shape or a side.
/// `InitialOptions::detail` decides what happens to finer detail; `report` counts what was left
/// out.
///
/// Where edges grow (`sizes`), the lattice is coarse, and triangles are broken up until they are as
/// small as the targets of their vertices.
///
/// Time and memory: O(1) per triangle, plus O(n log n) for the n vertices of the cut outlines, and
/// for those of the complex where edges grow. The same input gives bitwise identical results.
///
/// \throw InputError if a coordinate, the edge length or a size is out of range, outlines cross,
/// shapes overlap of which none lies in the other, a shape of `exterior_phase` lies in no other, or
/// the complex would be too large.
template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Shape> shapes,
                              const InitialOptions& options = {}, InputReport* report = nullptr);

/// The same for shapes in braces. `{}` stands for no shapes: the whole domain is `exterior_phase`.
template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::initializer_list<Shape> shapes,
                              const InitialOptions& options = {}, InputReport* report = nullptr) {
    return initial_complex<Real>(domain, std::span(shapes.begin(), shapes.size()), options, report);
}

/// The same for a domain of any shape; what lies beyond its boundary is clipped. Points of the
/// boundary are treated like those of outlines: detail finer than the mesh is thinned.
///
/// \throw InputError also where a ring of the domain crosses or touches another one.
template <class Real>
Complex<Real> initial_complex(const Polygon& domain, std::span<const Shape> shapes,
                              const InitialOptions& options = {}, InputReport* report = nullptr);

/// Triangulates `domain` with a planar network of curves as its interface.
///
/// The curves cut the domain into regions; each region gets the phase that all curves around it
/// name for their side there. Several regions may have the same phase. Without curves, everything
/// is `exterior_phase`. An end of a curve lies exactly on a side of the domain, or at exactly the
/// coordinates of other ends: three and more make a junction. Edges are cut, and detail finer than
/// the mesh is treated, as for outlines; but ends and closed curves of any size are kept.
///
/// Time, memory and reproducibility: as above.
///
/// \throw InputError if a coordinate, the edge length or a size is out of range; a curve has too
/// few points, an edge without length, one phase on both sides or a reserved one; a point lies
/// outside the domain or, unless it is an end, on a side or next to it; an end meets nothing;
/// curves cross, touch or overlap anywhere but at common ends; two curves name different phases for
/// a region; or the complex would be too large.
template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Curve> curves,
                              const InitialOptions& options = {}, InputReport* report = nullptr);

} // namespace dsc
