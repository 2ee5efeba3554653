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
// The walls are no-slip, slip or open. In a domain that is no rectangle the four names are those of
// the sides of the box around it, and `other` is the boundary that lies on none of them.
//
// Each phase of the scene needs an entry, and each pair that meets a tension. The defaults are
// no-slip walls, no gravity, contact angles of 90 degrees, and steps of `dt`. A phase without fluid
// is { phase = 0, void = true }.
#pragma once

#include "fluid/options.h"
#include "scenes/file/table_reader.h"

namespace dsc::scenes {

/// Throws InputError with file, line, key and value.
[[nodiscard]] FluidOptions read_fluid(const TableReader& reader);

} // namespace dsc::scenes
