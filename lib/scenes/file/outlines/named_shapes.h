// SPDX-License-Identifier: MIT
// The shapes of lib/shapes by name, with their parameters from a scene file:
//
//     circle       = { centre = [x, y], radius }
//     ellipse      = { centre = [x, y], radii = [a, b], angle in degrees }
//     rectangle    = { low = [x, y], high = [x, y] }
//     polygon      = { corners = [[x, y], ...] }
//     slotted_disc = { centre = [x, y], radius, slot_width, slot_height }
//     crescent     = { centre = [x, y], radius, bite_centre = [x, y], bite_radius }
//     dumbbell     = { centre = [x, y], radius, distance, neck, rounding }
//     star         = { centre = [x, y], outer_radius, inner_radius, tips }
//
// A parameter that is left out has the value of the struct in shapes.h, if there is one there.
#pragma once

#include "scenes/file/table_reader.h"
#include "shapes/curve.h"

#include <functional>

namespace dsc::scenes {

struct NamedShape {
    std::function<Outline(double edge_length)> outline;
    std::optional<ParametricCurve> curve{}; ///< exact, where there is one
};

/// In the order above.
[[nodiscard]] std::vector<std::string> shape_names();

/// The shape that the table `name` of `reader` describes. Throws InputError for unknown keys, and
/// for sizes that make no shape.
[[nodiscard]] NamedShape read_named_shape(const TableReader& reader, const std::string& name);

} // namespace dsc::scenes
