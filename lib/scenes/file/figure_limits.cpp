// SPDX-License-Identifier: MIT
#include "scenes/file/figure_limits.h"

#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace dsc::scenes {

namespace {

constexpr std::string_view at_end = "_last";
constexpr std::string_view at_half = "_half";
const std::string kept_value = "attribute_error_last";

// The counts and figures of a whole run, and the measures.
std::vector<std::string> names_of_figures() {
    std::vector<std::string> names{"inverted",   "unreached",        "held",
                                   "area_ratio", "min_quality_ever", kept_value};
    for (const Measure& measure : default_measures()) {
        for (const std::string_view moment : {at_end, at_half}) {
            names.push_back(measure.name + std::string(moment));
        }
    }
    return names;
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
    return read_limits(reader, names_of_figures());
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

std::string why_missing(const std::string& figure, const Setup& setup, bool is_quick) {
    if (figure == kept_value) {
        return setup.value ? "" : "the scene has no value at its vertices";
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
