// SPDX-License-Identifier: MIT
// A fluid in a scene file (fluid/options.h says what each number means):
//
//     [fluid]
//     equations = "navier-stokes"    # the default; or "stokes"
//     gravity = [0, -0.98]
//     walls = { left = "slip", right = "slip", bottom = "no-slip", top = "no-slip" }
//     phases = [
//         { phase = 0, density = 1000, viscosity = 10 },
//         { phase = 1, density = 100, viscosity = 1 },
//     ]
//     tensions = [{ one = 0, other = 1, tension = 24.5, contact-angle = 60 }]
//     tolerance = 0.01
//
// The walls are no-slip, slip or open (outflow without stress); or without slip and
//
//     left = { inflow = "6 * y * (1 - y)" }           # the speed at a right angle to the wall
//     cylinder = { velocity = ["-2 * y", "2 * x"] }
//
// by formulas in x, y and t. The four names are those of the sides of the box around the domain,
// and `other` is the boundary that lies on none of them; further names are the `sides` of the
// domain's outlines (scene_file.h). Results have the force of the fluid on these and on each side
// with a formula: `force_x_cylinder_last` and `force_y_cylinder_last`.
//
// Each phase of the scene needs an entry, and each pair that meets a tension. The defaults are
// no-slip walls, no gravity, contact angles of 90 degrees, and steps of `dt`. A phase without fluid
// is { phase = 0, void = true }.
#pragma once

#include "fluid/options.h"
#include "scenes/file/table_reader.h"

namespace dsc::scenes {

/// `sides`: the names of the domain's edges. Throws InputError with file, line, key and value.
[[nodiscard]] FluidOptions read_fluid(const TableReader& reader,
                                      const std::vector<std::string>& sides);

} // namespace dsc::scenes
