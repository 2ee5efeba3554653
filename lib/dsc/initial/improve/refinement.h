// SPDX-License-Identifier: MIT
// More vertices where triangles are poor or edges long (J. Ruppert, "A Delaunay refinement
// algorithm for quality 2-dimensional mesh generation", 1995): at the centres of the circles about
// triangles (L. P. Chew, "Guaranteed-quality mesh generation for curved surfaces", 1993), kept off
// the pieces of the interface and the sides of the domain.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/initial/build/insertion.h"

#include <span>

namespace dsc::initial {

/// The region around a piece of the interface, or of a side of the domain, that no new vertex may
/// enter.
enum class Protection : std::uint8_t {
    circle, ///< the smallest circle: the piece is seen at an angle of at most 90 degrees
    /// The part of that circle where the piece is seen at more than 120 degrees, so that triangles
    /// may have angles of 30 degrees at the ends of the piece. Where curves meet, short pieces next
    /// to long ones need that.
    lens,
};

template <class Real>
Point<double> position_of(const Complex<Real>& complex, std::uint32_t vertex) {
    return complex.position(Vertex{vertex}).template cast<double>();
}

/// The result of breaking up a triangle.
struct BreakUp {
    std::uint32_t vertex = no_id; ///< the new vertex, or none
    Corner in_the_way = no_id; ///< opposite to the constrained edge that prevented it, if one did
};

/// Inserts the centre of the circle about a triangle, unless it lies beyond a constrained edge or
/// too near to one.
template <class Real>
BreakUp break_up(Complex<Real>& complex, std::uint32_t triangle, Protection protection,
                 std::vector<Corner>& stack);

/// Breaks up poor triangles by the centres of their circles, as long as these do not crowd the
/// interface: new edges are no shorter than those that there are (with `lens`: not by much), and
/// grow with the distance from the short ones. Returns the number of new vertices.
template <class Real>
std::size_t refine(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                   Protection protection);

/// Halves edges of the interface at needles across the end of a film, if the triangle beyond
/// the edge does not reach another sheet. In rows of needles, and between two films, edges stay:
/// vertices that do not face each other there would make things worse once the interface moves.
/// Returns the number of new vertices.
template <class Real>
std::size_t halve_needles(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
                          double edge_length);

/// Splits inner edges that are much longer than the target. Returns the number of new vertices.
template <class Real>
std::size_t split_long(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                       double edge_length);

} // namespace dsc::initial
