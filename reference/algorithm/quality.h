// SPDX-License-Identifier: MIT
// Quality measures of the thesis, section 4.3, equations 1 to 4, and the Delaunay condition of
// section 4.2.
#pragma once

#include "reference/complex/complex.h"

namespace dsc::reference {

/// Equation 1: the distance of a vertex to its destination.
double distance(const Point<double>& a, const Point<double>& b);

/// Equation 2: the length of an edge.
double length(const Complex& K, const EdgeKey& e);

/// Equation 3: the area of a triangle.
double area(const Complex& K, const TriangleKey& t);

/// Equation 4: 2 / sqrt(3) times the sine of the smallest angle; 1 for an equilateral triangle, 0
/// for one without area. It uses the absolute area: see `Complex::orientation` for the sign.
double quality(const Point<double>& a, const Point<double>& b, const Point<double>& c);
double quality(const Complex& K, const TriangleKey& t);

/// The smallest quality of the triangles around a vertex; infinity if it has none.
double star_quality(const Complex& K, Vertex v);

/// The Delaunay condition as a quality of an edge: negative if the two opposite angles sum to more
/// than 180 degrees, i.e. if flipping would improve equation 4; dimensionless, in [-1, 1]. 1 for an
/// edge with one triangle.
double delaunay(const Complex& K, const EdgeKey& e);

} // namespace dsc::reference
