// SPDX-License-Identifier: MIT
#include "propose.h"

#include "checks.h"
#include "own_scenes.h"

#include "dsc/base/error.h"
#include "scenes/digits.h"
#include "scenes/output/machine.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace dsc::gate {

namespace {

using scenes::RunResult;
using scenes::SceneFile;
using OrderedJson = nlohmann::ordered_json;

// The limits of the catalogue keep to the same margins (bands.py, limits.json).
constexpr double margin_of_errors = 0.5;  ///< above the worst of all orders
constexpr double margin_of_bands = 0.1;   ///< above the largest difference of two
constexpr double margin_of_quality = 0.1; ///< below the worst
/// Runs of rigid motions end on the exact shape to rounding, in any order.
constexpr double least_error = 1e-12;

// To two digits, away from what was measured.
double rounded(double value, bool up) {
    if (value == 0) {
        return 0;
    }
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
    const double steps = value / unit;
    // Those that are two digits already stay.
    const double whole = std::abs(steps - std::round(steps)) < 1e-9
                             ? std::round(steps)
                             : (up ? std::ceil(steps) : std::floor(steps));
    return std::stod(scenes::shortest_digits(whole) + 'e' +
                     std::to_string(std::lround(std::log10(unit))));
}

std::string three_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

Band band_of(const std::string& check, std::vector<double> values, int orders) {
    for (const double value : values) {
        if (!std::isfinite(value)) {
            throw InvariantError(check + " has no number in one of " + std::to_string(orders) +
                                 " orders");
        }
    }
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return {.check = check,
            .median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2,
            .least = values.front(),
            .most = values.back(),
            .orders = orders};
}

// The scene in one order: 0 is its own.
Runs in_order(const SceneFile& file, int order) {
    SceneFile shuffled = file;
    if (order > 0) {
        shuffled.scene.defaults.seed = static_cast<std::uint64_t>(order);
    }
    return Runs({shuffled});
}

std::string in_orders(int orders) { return std::to_string(orders) + " orders"; }

// A figure of one run: errors and counts from above, quality and angles from below.
Band of_one_run(const Check& check, const std::vector<double>& values, int orders) {
    Band band = band_of(check.name, values, orders);
    band.at_least = check.at_least;
    const bool is_count = check.unit == "triangles" || check.unit == "vertices";
    if (check.at_least) {
        band.limit = rounded(band.least * (1 - margin_of_quality), false);
        band.note =
            in_orders(orders) + " had " + three_digits(band.least) + " and more; a tenth below";
    } else if (is_count) {
        band.limit = band.most;
        band.note = in_orders(orders) + " had " + three_digits(band.most) + " at most";
    } else {
        band.limit = std::max(rounded(band.most * (1 + margin_of_errors), true), least_error);
        band.note =
            in_orders(orders) + " had " + three_digits(band.most) + " at most; half as much again";
    }
    return band;
}

Band of_pairs(const Comparison& comparison, const std::vector<const RunResult*>& runs) {
    std::vector<double> values;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            values.push_back(std::max(comparison.difference(*runs[i], *runs[j]),
                                      comparison.difference(*runs[j], *runs[i])));
        }
    }
    const int orders = static_cast<int>(runs.size());
    Band band = band_of(comparison.name, values, orders);
    const bool has_floor = comparison.name != "parallel_events";
    band.limit =
        std::max(rounded(band.most * (1 + margin_of_bands), true), has_floor ? least_error : 0.0);
    band.note = "any two of " + in_orders(orders) + " differ by up to " + three_digits(band.most) +
                "; a tenth above";
    return band;
}

bool has_events(const std::vector<const RunResult*>& runs) {
    return std::ranges::any_of(runs, [](const RunResult* one) { return !one->events.empty(); });
}

OrderedJson finite_json(double value) {
    return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

} // namespace

double Band::ratio() const {
    return median == 0 ? std::numeric_limits<double>::quiet_NaN() : limit / median;
}

std::vector<Band> propose(const SceneFile& file, int orders) {
    const std::string& scene = file.scene.name;
    std::vector<Runs> all;
    for (int order = 0; order < orders; ++order) {
        all.push_back(in_order(file, order));
    }
    std::vector<const RunResult*> results;
    for (Runs& runs : all) {
        results.push_back(&runs.get({scene}));
    }
    std::vector<Band> bands;
    for (const char* name : {"area_ratio", "symmetric_difference", "symmetric_difference_half",
                             "inverted", "unreached", "min_quality"}) {
        const auto check = std::ranges::find(scene_checks(), name, &Check::name);
        if (why_not(check->figures, file).empty()) {
            std::vector<double> values;
            for (Runs& runs : all) {
                values.push_back(check->measure(runs, scene).value);
            }
            bands.push_back(of_one_run(*check, values, orders));
        }
    }
    for (const Comparison& comparison : comparisons()) {
        const bool is_of_events = comparison.name == "parallel_events";
        if (why_not(comparison.figures, file).empty() && (!is_of_events || has_events(results))) {
            bands.push_back(of_pairs(comparison, results));
        }
    }
    const auto same = std::ranges::find(bands, std::string("min_quality"), &Band::check);
    if (same != bands.end()) {
        // What parallel runs are held to is what sequential ones do in other orders.
        Band parallel = *same;
        parallel.check = "parallel_min_quality";
        bands.push_back(parallel);
    }
    bands.push_back({.check = "mesh_hash",
                     .median = 1,
                     .least = 1,
                     .most = 1,
                     .limit = 1,
                     .orders = 1,
                     .note = "required: the same for any number of threads"});
    return bands;
}

std::string to_limits(const std::string& scene, const std::vector<Band>& bands) {
    OrderedJson limits = OrderedJson::object();
    for (const Band& band : bands) {
        limits[band.check][scene] = {{"value", band.limit},
                                     {"note", band.note},
                                     {"band",
                                      {{"median", band.median},
                                       {"spread", band.spread()},
                                       {"ratio", finite_json(band.ratio())},
                                       {"orders", band.orders}}}};
    }
    const OrderedJson json{{"about",
                            "Proposed by `dsc_verify propose`: look at each limit before it is "
                            "committed. The ratio is that of the limit to the median."},
                           {"commit", scenes::commit()},
                           {"limits", limits}};
    return json.dump(2) + "\n";
}

} // namespace dsc::gate
