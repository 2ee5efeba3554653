// SPDX-License-Identifier: MIT
#include "scenes/file/flow_source.h"

#include "dsc/base/error.h"
#include "scenes/file/formula/formula_flow.h"

#include <limits>

namespace dsc::scenes {

namespace {

constexpr Bounds any_time{0, 1e12};

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

} // namespace

FlowSource read_flow(const std::vector<TableReader>& legs) {
    struct LegSource {
        double end;
        FormulaTexts velocity;
    };
    std::vector<LegSource> sources;
    double end = 0;
    for (const TableReader& leg : legs) {
        leg.allow({"u", "v", "parameters", "until"});
        if (&leg == &legs.back() && !leg.has("until")) {
            end = std::numeric_limits<double>::infinity();
        } else {
            const double until = leg.number("until", any_time);
            if (!(until >= end)) {
                leg.refuse("until", "times out of order", "a time after that of the flow before");
            }
            end = until;
        }
        sources.push_back({end,
                           {.u = leg.text("u"),
                            .v = leg.text("v"),
                            .parameters = read_parameters(leg),
                            .where_u = leg.where("u"),
                            .where_v = leg.where("v")}});
    }
    return [sources](const Parameters& parameters) {
        Flow flow;
        for (auto [leg_end, velocity] : sources) {
            velocity.parameters["h"] = parameters.h;
            velocity.parameters["period"] = parameters.period;
            flow.push_back({leg_end, FormulaFlow(velocity)});
        }
        return flow;
    };
}

} // namespace dsc::scenes
