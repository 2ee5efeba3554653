// SPDX-License-Identifier: MIT
#include "propose.h"

#include "dsc/base/error.h"
#include "scenes/output/machine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <iterator>
#include <string_view>

namespace dsc::gate {

namespace {

// Checks of a scene that has no limits yet.
constexpr std::string_view of_any_scene[]{"area_ratio",         "symmetric_difference",
                                          "inverted",           "symmetric_difference_half",
                                          "unreached",          "min_quality",
                                          "parallel_area",      "parallel_symmetric_difference",
                                          "parallel_events",    "parallel_area_histogram",
                                          "parallel_unreached", "parallel_quality_histogram",
                                          "parallel_min_angle", "parallel_min_quality",
                                          "area_histogram",     "quality_histogram",
                                          "angle_histogram",    "median_area",
                                          "median_quality",     "median_angle",
                                          "mesh_hash"};

std::string here_and_now() {
    std::array<char, 16> day{};
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    (void)gmtime_r(&now, &utc);
    (void)std::strftime(day.data(), day.size(), "%F", &utc);
    return scenes::commit() + ", " + day.data() + ", " + scenes::machine() + ", " +
           scenes::compiler();
}

// Rounds a limit to two digits, away from the measurement.
double rounded(double value, bool up) {
    if (value == 0) {
        return 0;
    }
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
    const double steps = value / unit;
    // A limit that has two digits already stays.
    const double whole = std::abs(steps - std::round(steps)) < 1e-9
                             ? std::round(steps)
                             : (up ? std::ceil(steps) : std::floor(steps));
    return std::stod(to_text(whole) + 'e' + std::to_string(std::lround(std::log10(unit))));
}

bool is_count(const Check& check) {
    return check.unit == "triangles" || check.unit == "vertices" || check.group == "events";
}

// Whether the check is measured by sequential runs in shuffled orders; parallel runs are held to
// the spread of these.
bool is_of_orders(const Check& check) {
    return check.of != Of::all_parallel && check.of != Of::threads && check.of != Of::reference;
}

Limit new_limit(const Check& check, int orders) {
    const bool is_comparison = check.of == Of::difference || check.of == Of::reference;
    return {.rule = check.of == Of::threads            ? "required"
                    : check.at_least                   ? "a tenth below"
                    : is_comparison || is_count(check) ? "a tenth above"
                                                       : "half as much again",
            .orders = is_of_orders(check) ? orders : 0};
}

std::vector<Held> wanted(const Case& of, int orders) {
    std::vector<Held> all;
    // The suite's common limits are not changed, nor are limits that have neither a measurement nor
    // a rule with a factor.
    std::ranges::copy_if(of.held, std::back_inserter(all), [](const Held& held) {
        return held.limit.is_own && (held.limit.measured || find_rule(held.limit.rule).factor != 1);
    });
    const auto add = [&](std::string_view name) {
        const auto check = find_check(std::string(name));
        if (why_not(*check, of).empty()) {
            all.push_back({check, new_limit(*check, orders)});
        }
    };
    if (all.empty()) {
        for (const std::string_view name : of_any_scene) {
            if (std::ranges::none_of(of.held,
                                     [&](const Held& held) { return held.check->name == name; })) {
                add(name);
            }
        }
    } else {
        std::ranges::for_each(of.missing, add);
    }
    return all;
}

// The runs in all orders. Comparisons are made with the first one.
std::vector<Configuration> in_orders(const Held& held, const Case& of) {
    if (held.limit.orders == 0) {
        return configurations_of(*held.check, of);
    }
    std::vector<Configuration> all;
    for (int order = 0; order < held.limit.orders; ++order) {
        all.push_back({.of = &of, .parameters = of.parameters});
        if (order > 0) {
            all.back().parameters.seed = static_cast<std::uint64_t>(order);
        }
    }
    return all;
}

double median_of(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Measures what the limit stores.
void store(Held& held, const std::vector<const Outcome*>& outcomes) {
    const Check& check = *held.check;
    if (find_rule(held.limit.rule).factor == 1 &&
        (held.limit.around || !held.limit.histogram.empty())) {
        return; // required, or kept
    }
    if (check.stores == Stores::figure) {
        std::vector<double> values;
        std::ranges::transform(outcomes, std::back_inserter(values),
                               [&](const Outcome* one) { return check.figure(finished(*one)); });
        held.limit.around = std::stod(few_digits(median_of(std::move(values))));
    } else if (check.stores == Stores::histogram) {
        held.limit.histogram.assign(check.bins, 0);
        for (const Outcome* one : outcomes) {
            std::ranges::transform((finished(*one).*check.histogram).counts, held.limit.histogram,
                                   held.limit.histogram.begin(), std::plus{});
        }
    }
}

std::vector<double> values_of(const Held& held, const std::vector<const Outcome*>& outcomes) {
    const Check& check = *held.check;
    std::vector<double> values;
    if (held.limit.orders == 0) {
        return {measure(check, held.limit, outcomes).value};
    }
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (check.of != Of::difference) {
            values.push_back(measure(check, held.limit, std::span(outcomes).subspan(i, 1)).value);
        }
        for (std::size_t j = 0; check.of == Of::difference && j < i; ++j) {
            const auto& a = finished(*outcomes[i]);
            const auto& b = finished(*outcomes[j]);
            values.push_back(std::max(check.difference(a, b), check.difference(b, a)));
        }
    }
    return values;
}

void set_limit(const Check& check, double measured, Limit& limit) {
    if (check.of == Of::threads) {
        limit = {.value = 1}; // whatever was measured
        return;
    }
    limit.measured = measured;
    limit.at = here_and_now();
    const double factor = find_rule(limit.rule).factor;
    if (is_count(check) && measured == 0) {
        limit = {.value = 0}; // nothing may be lost
    } else if (factor != 1) {
        limit.value = rounded(measured * factor, !check.at_least);
        if (!check.at_least && !is_count(check)) {
            limit.value = std::max(limit.value, rounding_error);
        }
    }
}

Band band_of(const Case& of, const Held& held, std::vector<double> values) {
    for (const double value : values) {
        if (!std::isfinite(value)) {
            throw InvariantError(held.check->name + " of " + of.name + " has no number in one of " +
                                 std::to_string(std::max(held.limit.orders, 1)) + " orders");
        }
    }
    const auto [min, max] = std::ranges::minmax(values);
    Band band{.of = &of,
              .check = held.check,
              .median = median_of(std::move(values)),
              .min = min,
              .max = max,
              .limit = held.limit};
    set_limit(*held.check, held.check->at_least ? band.min : band.max, band.limit);
    return band;
}

// Whether the check compares events, and the scene has none.
bool is_of_no_event(const Held& held, const std::vector<const Outcome*>& outcomes) {
    return held.check->group == "events" && held.limit.where.empty() &&
           std::ranges::all_of(outcomes,
                               [](const Outcome* one) { return one->result.events.empty(); });
}

} // namespace

std::vector<Wanted> limits_to_measure(const Cases& cases, int orders) {
    std::vector<Wanted> all;
    for (const auto& c : cases) {
        for (Held& held : wanted(*c, orders)) {
            // What is stored differs from itself only in other orders.
            if (held.limit.orders > 0 || held.check->stores != Stores::nothing) {
                held.limit.orders = orders;
            }
            all.push_back({c.get(), std::move(held)});
        }
    }
    return all;
}

std::vector<Band> propose(const std::vector<Wanted>& limits, int jobs) {
    std::vector<Configuration> configurations;
    for (const auto& [of, held] : limits) {
        std::ranges::move(in_orders(held, *of), std::back_inserter(configurations));
    }
    Runs runs(configurations, jobs);
    std::vector<Band> bands;
    for (auto [of, held] : limits) {
        std::vector<const Outcome*> outcomes;
        for (const Configuration& one : in_orders(held, *of)) {
            outcomes.push_back(&runs.wait(one));
        }
        store(held, outcomes);
        if (!is_of_no_event(held, outcomes)) {
            bands.push_back(band_of(*of, held, values_of(held, outcomes)));
        }
    }
    return bands;
}

} // namespace dsc::gate
