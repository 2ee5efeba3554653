// SPDX-License-Identifier: MIT
// The surfaces of the shapes of a first complex: which of them meet at a vertex or along an edge,
// and the place where they meet.
#pragma once

#include "dsc3/initial/initial_complex.h"
#include "dsc3/operations/workspace.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dsc3::initial {

/// The phase, inside a shape, of what had this phase before.
[[nodiscard]] Phase phase_inside(const Shape& shape, Phase phase);

/// Shapes on whose surfaces something lies.
using ShapeList = std::vector<const Shape*>;

/// The shapes, and the complex that is made from them; both must outlive it.
class Surfaces {
public:
    Surfaces(const Complex& complex, std::span<const Shape> shapes, Real edge_length)
        : complex_(complex), shapes_(shapes), edge_length_(edge_length) {}

    /// The distance of the nearest surface that is part of the interface at this place. O(shapes).
    [[nodiscard]] Real distance(const Point& p) const;
    /// Whether the vertex is on the surface, up to a thousandth of an edge.
    [[nodiscard]] bool is_on(const Shape& shape, std::uint32_t vertex) const;
    /// Whether a point is on all of these surfaces, up to a thousandth of an edge.
    [[nodiscard]] bool is_on(const ShapeList& surfaces, const Point& p) const;
    /// The surfaces on which an interface vertex lies; none for other vertices. O(shapes).
    [[nodiscard]] ShapeList at(std::uint32_t vertex) const;
    /// The surfaces on which both ends of an edge lie. O(shapes).
    [[nodiscard]] ShapeList between(std::uint32_t a, std::uint32_t b) const;
    /// The projection of p onto all of these surfaces, within the sides of the domain that fix
    /// coordinates of p.
    [[nodiscard]] Point project(const ShapeList& surfaces, Point p, std::uint32_t fixed) const;
    /// The place of a new vertex on an edge of the interface: on all surfaces that meet there.
    [[nodiscard]] Point place_between(Workspace& work, std::uint32_t a, std::uint32_t b) const;

private:
    [[nodiscard]] Point project(const Distance& distance, Point p, std::uint32_t fixed) const;
    [[nodiscard]] Point project_nearest(const Point& p, std::uint32_t fixed) const;

    const Complex& complex_;
    std::span<const Shape> shapes_;
    Real edge_length_;
};

} // namespace dsc3::initial
