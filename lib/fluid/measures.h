// SPDX-License-Identifier: MIT
// Measures of a flow.
#pragma once

#include "fluid/field/snapshot_field.h"
#include "fluid/options.h"

namespace dsc {

/// Measures of a phase whose outline is read as the cubic through its vertices (`curve_point`),
/// with fourth order accuracy where the outline is smooth.
struct CubicOutline {
    double length = 0;                ///< of all outlines
    double area = 0;                  ///< inside them
    Point<double> centroid{0.0, 0.0}; ///< of the area

    /// The perimeter of the disc of the same area over the length: 1 for a disc.
    [[nodiscard]] double circularity() const;
};

/// The sums over all outlines of the phase. For phases that do not touch the domain boundary, whose
/// corners a cubic would cut off. O(triangles).
[[nodiscard]] CubicOutline cubic_outline(const Complex<double>& complex, Phase phase);

/// The mean velocity in a phase; (0, 0) if there is no such phase. O(triangles).
[[nodiscard]] Point<double> mean_velocity(const FluidField& field, Phase phase);

/// The mean pressure in a phase. O(triangles).
[[nodiscard]] double mean_pressure(const FluidField& field, Phase phase);

/// The largest speed at a node of a fluid, not inside a void. O(n).
[[nodiscard]] double largest_speed(const FluidField& field, const FluidOptions& options);

/// Energies; only viscosity changes their sum.
struct FluidEnergy {
    double kinetic = 0;   ///< of all phases
    double potential = 0; ///< energy of gravity, relative to the origin of coordinates
    double surface = 0;   ///< tension times length

    /// All of it.
    [[nodiscard]] double sum() const { return kinetic + potential + surface; }
};

/// The energies of a solution; a void has no mass. Masses per area and forces per length, as in
/// `FluidOptions`. O(n).
[[nodiscard]] FluidEnergy energy(const FluidField& field, const FluidOptions& options);

} // namespace dsc
