// SPDX-License-Identifier: MIT
#include "scenes/file/fluid_source.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"

#include <array>

namespace dsc::scenes {

namespace {

/// Bound of densities, viscosities and tensions: larger values mean wrong units.
constexpr double largest_property = 1e12;
constexpr Bounds property{0, largest_property};
constexpr Bounds positive_property{1 / largest_property, largest_property};

constexpr std::array wall_names{
    Named{Wall::no_slip, "no-slip"},
    Named{Wall::slip, "slip"},
    Named{Wall::open, "open"},
};
constexpr std::array equations_names{
    Named{FluidEquations::navier_stokes, "navier-stokes"},
    Named{FluidEquations::stokes, "stokes"},
};

Walls read_walls(const TableReader& reader) {
    reader.allow({"left", "right", "bottom", "top", "other"});
    const auto wall = [&](const char* side) {
        return read_choice(reader, side, wall_names, Wall::no_slip);
    };
    return {wall("left"), wall("right"), wall("bottom"), wall("top"), wall("other")};
}

} // namespace

FluidOptions read_fluid(const TableReader& reader) {
    reader.allow({"equations", "gravity", "walls", "phases", "tensions", "tolerance"});
    FluidOptions options;
    options.equations =
        read_choice(reader, "equations", equations_names, FluidEquations::navier_stokes);
    options.gravity = reader.point_or({0, 0}, "gravity");
    options.tolerance = reader.number_or(0, "tolerance", {0, 1});
    if (reader.has("walls")) {
        options.walls = read_walls(reader.table("walls"));
    }
    for (const TableReader& phase : reader.tables("phases")) {
        phase.allow({"phase", "density", "viscosity", "void"});
        if (phase.flag_or(false, "void")) {
            phase.allow({"phase", "void"});
            options.phases.push_back({.phase = phase.phase("phase"), .is_void = true});
            continue;
        }
        options.phases.push_back({.phase = phase.phase("phase"),
                                  .density = phase.number("density", property),
                                  .viscosity = phase.number("viscosity", positive_property)});
    }
    for (const TableReader& pair : reader.tables("tensions")) {
        pair.allow({"one", "other", "tension", "contact-angle"});
        options.tensions.push_back(
            {.one = pair.phase("one"),
             .other = pair.phase("other"),
             .tension = pair.number("tension", property),
             .contact_angle = pair.number_or(90, "contact-angle", {0, 180})});
    }
    at_key(reader, "", [&] { check_fluid(options); });
    return options;
}

} // namespace dsc::scenes
