// SPDX-License-Identifier: MIT
#include "scenes/file/figure_limits.h"

#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>

namespace dsc::scenes {

namespace {

constexpr std::string_view at_end = "_last";
constexpr std::string_view at_half = "_half";
const std::string kept_value = "attribute_error_last";
constexpr std::array of_fluids{"circularity_min",       "circularity_last",   "rise_velocity_max",
                               "centre_last",           "area_drift_last",    "energy_last",
                               "largest_velocity_last", "pressure_jump_last", "amplitude_error",
                               "frequency_error",       "neck_error",         "neck_last"};

// Those of the measured phase alone.
constexpr std::array of_one_phase{"circularity_min", "circularity_last", "rise_velocity_max",
                                  "centre_last",     "area_drift_last",  "pressure_jump_last"};

// The side of the domain whose force the figure is; empty if it is none.
std::string side_of_force(const std::string& figure) {
    constexpr std::string_view stem = "force_x_";
    const bool is_force = (figure.starts_with(stem) || figure.starts_with("force_y_")) &&
                          figure.ends_with(at_end) && figure.size() > stem.size() + at_end.size();
    return is_force ? figure.substr(stem.size(), figure.size() - stem.size() - at_end.size())
                    : std::string();
}

// The counts and figures of a whole run, and the measures.
std::vector<std::string> names_of_figures() {
    std::vector<std::string> names{"inverted",   "unreached",        "held",
                                   "area_ratio", "min_quality_ever", kept_value};
    for (const Measure& measure : default_measures()) {
        for (const std::string_view moment : {at_end, at_half}) {
            names.push_back(measure.name + std::string(moment));
        }
    }
    names.insert(names.end(), of_fluids.begin(), of_fluids.end());
    return names;
}

// Whether the shapes of a scene have one of the phases for which `is_meant` is true.
bool has_phase(const Setup& setup, const std::function<bool(Phase)>& is_meant) {
    if (setup.labels) {
        return std::ranges::any_of(setup.labels->labels, is_meant);
    }
    const auto is_beside = [&](const dsc::Curve& c) {
        return is_meant(c.left) || is_meant(c.right);
    };
    return is_meant(exterior_phase) || std::ranges::any_of(setup.phases, is_meant) ||
           (setup.phases.empty() && !setup.outlines.empty() && is_meant(1)) ||
           std::ranges::any_of(setup.curves, is_beside);
}

// The reason why a run does not measure a figure of a fluid; empty if it does.
std::string why_missing_of_fluid(const std::string& figure, const Setup& setup) {
    if (!setup.fluid) {
        return "the scene has no fluid";
    }
    const Phase measured = setup.measured.value_or(1);
    if (std::ranges::find(of_one_phase, figure) != of_one_phase.end() &&
        !has_phase(setup, [&](Phase phase) { return phase == measured; })) {
        return "no shape has the phase " + std::to_string(measured) +
               ", which is measured unless [measure] has another one";
    }
    if (const std::string side = side_of_force(figure); !side.empty()) {
        const std::vector<FluidSide>& sides = setup.fluid->options.sides;
        if (std::ranges::find(sides, side, &FluidSide::name) != sides.end()) {
            return "";
        }
        return "no side '" + side + "' with a name or a formula" +
               (sides.empty() ? "" : ", only " + name_list(sides, &FluidSide::name));
    }
    if (figure.starts_with("amplitude") || figure.starts_with("frequency")) {
        return setup.fluid->wave ? "" : "the exact height of a wave is not known";
    }
    return figure.starts_with("neck") && !setup.fluid->neck ? "the exact neck is not known" : "";
}

FigureLimit read_limit(const TableReader& reader, const std::string& key, std::string figure) {
    constexpr Bounds any{-1e300, 1e300};
    FigureLimit limit{.figure = std::move(figure), .where = reader.where(key)};
    if (const auto bounds = reader.table_if_one(key)) {
        bounds->allow({"min", "max"});
        if (!bounds->has("min") && !bounds->has("max")) {
            reader.refuse(key, "a limit without bounds", "min, max or both");
        }
        limit.min = bounds->number_or(limit.min, "min", any);
        limit.max = bounds->number_or(limit.max, "max", any);
    } else {
        limit.max = reader.number(key, any);
    }
    if (!(limit.min <= limit.max)) {
        reader.refuse(key, "bad value", "a min that is not above max");
    }
    return limit;
}

} // namespace

std::vector<FigureLimit> read_limits(const TableReader& reader) {
    std::vector<std::string> names = names_of_figures();
    std::vector<std::string> keys = reader.keys();
    std::ranges::copy_if(keys, std::back_inserter(names),
                         [](const std::string& key) { return !side_of_force(key).empty(); });
    names.insert(names.end(), {"force_x_SIDE_last", "force_y_SIDE_last"});
    return read_limits(reader, names);
}

std::vector<FigureLimit> read_limits(const TableReader& reader,
                                     const std::vector<std::string>& names) {
    reader.allow(names);
    std::vector<FigureLimit> limits;
    for (const std::string& figure : reader.keys()) {
        if (figure.starts_with(
                "jaggedness")) { // has several parts; limits apply to the one named here
            const TableReader parts = reader.table(figure);
            const std::string excess = "largest_excess_deg";
            parts.allow({excess});
            limits.push_back(read_limit(parts, excess, figure + '.' + excess));
        } else {
            limits.push_back(read_limit(reader, figure, figure));
        }
    }
    if (limits.empty()) {
        throw InputError({.what = "no limits",
                          .where = reader.where(),
                          .value = "an empty table",
                          .allowed = name_list(names)});
    }
    return limits;
}

bool is_figure_of_fluid(const std::string& figure) {
    return !side_of_force(figure).empty() ||
           std::ranges::find(of_fluids, figure) != of_fluids.end();
}

std::string why_missing(const std::string& figure, const Setup& setup, bool is_quick) {
    if (figure == kept_value) {
        return setup.value ? "" : "the scene has no value at its vertices";
    }
    if (figure == "area_ratio") {
        const bool has = has_phase(setup, [&](Phase phase) {
            return setup.measured ? phase == *setup.measured : phase != exterior_phase;
        });
        return has ? "" : "no shape has a phase that is measured";
    }
    if (is_figure_of_fluid(figure)) {
        return why_missing_of_fluid(figure, setup);
    }
    const std::string stem = figure.substr(0, figure.find('.'));
    const bool is_half = stem.ends_with(at_half);
    if (!is_half && !stem.ends_with(at_end)) {
        return "";
    }
    const std::string name = stem.substr(0, stem.size() - at_end.size());
    const auto measure = std::ranges::find(default_measures(), name, &Measure::name);
    const bool needs_shape = measure->needs == Needs::exact_shape;
    if (needs_shape && !setup.exact) {
        return "the exact shape is not known";
    }
    if (is_half && !setup.half_step) {
        return "the flow of the scene does not turn back, so there is no half-way time";
    }
    const bool is_unknown = is_half && needs_shape && !is_quick &&
                            std::isnan(setup.exact(*setup.half_step * setup.dt).area);
    return is_unknown ? "the exact shape is not known half-way" : "";
}

void check_measured(const std::vector<FigureLimit>& limits, const Setup& setup) {
    for (const FigureLimit& limit : limits) {
        const std::string reason = why_missing(limit.figure, setup);
        if (!reason.empty()) {
            throw InputError({.what = "the run does not measure the figure of this limit",
                              .where = limit.where,
                              .value = limit.figure + ": " + reason,
                              .allowed = "figures that the run measures"});
        }
    }
}

} // namespace dsc::scenes
