// SPDX-License-Identifier: MIT
// The first complexes of hard cases, and their measures at the end.
#pragma once

#include "result.h"

#include "dsc/initial/initial_complex.h"
#include "dsc/passes/options.h"
#include "shapes/outline.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace dsc::hard {

inline const Rectangle unit_square{{0, 0}, {1, 1}};

template <class Real>
struct Scene {
    Rectangle domain;
    Complex<Real> complex;
    Options<Real> options;
};

/// Outlines of phase 1 in a rectangle, at edge length h.
template <class Real>
Scene<Real> scene_of(const Rectangle& domain, std::span<const scenes::Outline> outlines, double h);

/// The same in a frame; the scene's domain is in its coordinates too.
template <class Real>
Scene<Real> scene_of(const Frame& frame, const Rectangle& domain,
                     std::span<const scenes::Outline> outlines, double h);

/// A grid of squares, columns by rows, each divided by alternating diagonals; the phase of a
/// triangle is that at its middle. `place` may move the grid's points; h is the side of a square.
Scene<double> grid_scene(const Rectangle& domain, int columns, int rows,
                         const std::function<Phase(const Point<double>&)>& phase_at,
                         const std::function<Point<double>(const Point<double>&)>& place = nullptr);

/// Symmetric difference between the interface and the exact outlines, relative to their area.
template <class Real>
double shape_error(const Complex<Real>& complex, std::span<const scenes::Outline> exact);

/// Maps each point of the outlines by a function.
std::vector<scenes::Outline> mapped(std::span<const scenes::Outline> outlines,
                                    const std::function<Point<double>(const Point<double>&)>& map);

/// The area of the whole domain, summed over triangles.
double domain_area(const Complex<double>& complex);

/// A number as text for a sentence: "1.2e-05".
std::string text(double value);

} // namespace dsc::hard
