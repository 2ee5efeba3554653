// SPDX-License-Identifier: MIT
#include "scenes/file/fluid_source.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"
#include "scenes/file/formula/formula_flow.h"

#include <algorithm>
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

// The velocity on a side: its first component is an inflow, if `v` is "0".
std::function<Point<double>(const Point<double>&, double)>
formula_at(const TableReader& side, const std::string& key, std::string u, std::string v) {
    const FormulaFlow flow({.u = std::move(u),
                            .v = std::move(v),
                            .where_u = side.where(key),
                            .where_v = side.where(key)});
    return [flow](const Point<double>& place, double time) {
        Point<double> velocity;
        flow({&place, 1}, time, {&velocity, 1});
        return velocity;
    };
}

FluidSide read_side(const TableReader& walls, const std::string& name) {
    FluidSide side{.name = name};
    const auto table = walls.has(name) ? walls.table_if_one(name) : std::nullopt;
    if (!table) {
        side.wall = read_choice(walls, name, wall_names, Wall::no_slip);
        return side;
    }
    const std::vector<std::string> kinds{"inflow", "velocity"};
    table->allow(kinds);
    if (table->one_of(kinds) == "inflow") {
        side.inflow = [speed = formula_at(*table, "inflow", table->text("inflow"), "0")](
                          const Point<double>& place, double time) {
            return speed(place, time).x();
        };
        return side;
    }
    const std::vector<std::string> components = table->texts("velocity");
    if (components.size() != 2) {
        table->refuse("velocity", "bad value", "two formulas, [\"u\", \"v\"]");
    }
    side.velocity = formula_at(*table, "velocity", components[0], components[1]);
    return side;
}

// Named edges are sides with a force; those of the box only if they have a formula.
void read_walls(const TableReader& reader, const std::vector<std::string>& names,
                FluidOptions& options) {
    const std::array<std::pair<std::string, Wall*>, 5> box{{{"left", &options.walls.left},
                                                            {"right", &options.walls.right},
                                                            {"bottom", &options.walls.bottom},
                                                            {"top", &options.walls.top},
                                                            {"other", &options.walls.other}}};
    std::vector<std::string> keys = names;
    for (const auto& [name, wall] : box) {
        if (std::ranges::find(names, name) != names.end()) {
            continue;
        }
        keys.push_back(name);
        const FluidSide side = read_side(reader, name);
        *wall = side.wall;
        if (side.inflow || side.velocity) {
            options.sides.push_back(side);
        }
    }
    for (const std::string& name : names) {
        options.sides.push_back(read_side(reader, name));
    }
    reader.allow(keys);
}

} // namespace

FluidOptions read_fluid(const TableReader& reader, const std::vector<std::string>& sides) {
    reader.allow({"equations", "gravity", "walls", "phases", "tensions", "tolerance"});
    FluidOptions options;
    options.equations =
        read_choice(reader, "equations", equations_names, FluidEquations::navier_stokes);
    options.gravity = reader.point_or({0, 0}, "gravity");
    options.tolerance = reader.number_or(0, "tolerance", {0, 1});
    if (reader.has("walls")) {
        read_walls(reader.table("walls"), sides, options);
    } else {
        for (const std::string& name : sides) {
            options.sides.push_back({.name = name});
        }
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
