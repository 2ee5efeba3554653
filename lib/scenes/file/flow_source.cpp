// SPDX-License-Identifier: MIT
#include "scenes/file/flow_source.h"

#include "dsc/base/error.h"
#include "scenes/file/formula/formula_flow.h"

#include <array>
#include <limits>

namespace dsc::scenes {

namespace {

using VelocitySource = std::function<Velocity(const Parameters& parameters)>;

constexpr Bounds any_speed{-largest_coordinate, largest_coordinate};
constexpr Bounds any_time{0, 1e12};

template <class Field>
VelocitySource always(Field field) {
    return [velocity = Velocity(std::move(field))](const Parameters&) { return velocity; };
}

VelocitySource read_translation(const TableReader& reader) {
    reader.allow({"velocity"});
    return always(Translation{reader.point("velocity")});
}

VelocitySource read_radial(const TableReader& reader) {
    reader.allow({"centre", "speed"});
    return always(Radial{reader.point("centre"), reader.number_or(1, "speed", any_speed)});
}

VelocitySource read_rotation(const TableReader& reader) {
    reader.allow({"centre", "angular_speed"});
    return always(
        Rotation{reader.point("centre"), reader.number_or(1, "angular_speed", any_speed)});
}

VelocitySource read_vortex(const TableReader& reader) {
    reader.allow({"centre", "speed"});
    return always(Vortex{reader.point("centre"), reader.number_or(1, "speed", any_speed)});
}

VelocitySource read_swirl(const TableReader& reader) {
    reader.allow({"amplitude", "period"});
    return always(Swirl{reader.number_or(1, "amplitude", any_speed),
                        reader.number_or(0, "period", any_time)});
}

VelocitySource read_falling(const TableReader& reader) {
    reader.allow({"surface", "depth", "speed"});
    return always(Falling{reader.number("surface"), reader.number("depth", positive_length),
                          reader.number_or(1, "speed", any_speed)});
}

FormulaParameters read_parameters(const TableReader& leg) {
    FormulaParameters parameters;
    if (!leg.has("parameters")) {
        return parameters;
    }
    const TableReader table = leg.table("parameters");
    for (const std::string& name : table.keys()) {
        if (!is_parameter_name(name) || name == "pi" || name == "h" || name == "period") {
            table.refuse(name, "bad name for a parameter",
                         "letters, digits and _, a letter first; not x, y, t, pi, h, period or a "
                         "function");
        }
        parameters[name] = table.number(name, {-1e300, 1e300});
    }
    return parameters;
}

VelocitySource read_formulas(const TableReader& leg) {
    FormulaTexts texts{.u = leg.text("u"),
                       .v = leg.text("v"),
                       .parameters = read_parameters(leg),
                       .where_u = leg.where("u"),
                       .where_v = leg.where("v")};
    return [texts = std::move(texts)](const Parameters& parameters) {
        FormulaTexts now = texts;
        now.parameters["h"] = parameters.h;
        now.parameters["period"] = parameters.period;
        return Velocity(FormulaFlow(std::move(now)));
    };
}

struct NameOfFlow {
    const char* name;
    VelocitySource (*read)(const TableReader&);
};

constexpr std::array named_flows{
    NameOfFlow{"translation", read_translation},
    NameOfFlow{"radial", read_radial},
    NameOfFlow{"rotation", read_rotation},
    NameOfFlow{"vortex", read_vortex},
    NameOfFlow{"swirl", read_swirl},
    NameOfFlow{"falling", read_falling},
};

VelocitySource read_velocity(const TableReader& leg) {
    std::vector<std::string> kinds{"u"};
    for (const NameOfFlow& flow : named_flows) {
        kinds.emplace_back(flow.name);
    }
    std::vector<std::string> keys = kinds;
    keys.insert(keys.end(), {"v", "parameters", "until", "reversed"});
    leg.allow(keys);
    const std::string kind = leg.one_of(kinds);
    if (kind == "u") {
        return read_formulas(leg);
    }
    for (const char* alien : {"v", "parameters"}) {
        if (leg.has(alien)) {
            leg.refuse(alien, "this belongs to formulas", "u and v in place of " + kind);
        }
    }
    const auto found = std::ranges::find(named_flows, kind, &NameOfFlow::name);
    return found->read(leg.table(kind));
}

} // namespace

FlowSource read_flow(const std::vector<TableReader>& legs) {
    struct LegSource {
        double end;
        bool is_reversed;
        VelocitySource velocity;
    };
    std::vector<LegSource> sources;
    double end = 0;
    for (const TableReader& leg : legs) {
        const bool is_last = &leg == &legs.back();
        VelocitySource velocity = read_velocity(leg);
        if (!is_last || leg.has("until")) {
            const double until = leg.number("until", any_time);
            if (!(until >= end)) {
                leg.refuse("until", "times out of order", "after the flow before it");
            }
            end = until;
        } else {
            end = std::numeric_limits<double>::infinity();
        }
        sources.push_back({end, leg.flag_or(false, "reversed"), std::move(velocity)});
    }
    return [sources](const Parameters& parameters) {
        Flow flow;
        for (const LegSource& source : sources) {
            Velocity velocity = source.velocity(parameters);
            flow.push_back(
                {source.end, source.is_reversed ? reversed(std::move(velocity)) : velocity});
        }
        return flow;
    };
}

} // namespace dsc::scenes
