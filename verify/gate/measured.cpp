// SPDX-License-Identifier: MIT
// The runs that a check needs, and the figures computed from them.
#include "checks.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace dsc::gate {

namespace {

using scenes::Histogram;
using scenes::RunResult;
using scenes::Strategy;

// Two threads stand for any number of them, because `mesh_hash` checks that results do not depend
// on it.
const std::vector<std::uint32_t> two_threads{2};
const std::vector<std::uint32_t> many_threads{1, 2, 3, 5};

// The worst value of a function over the runs after the first `skipped`; NaN is worse than any
// number.
template <class Value>
Measured worst(std::span<const Outcome* const> outcomes, std::size_t skipped, bool at_least,
               Value value) {
    Measured found{.value = at_least ? std::numeric_limits<double>::infinity() : 0,
                   .run = outcomes.front()->configuration};
    for (const Outcome* outcome : outcomes.subspan(skipped)) {
        const double here = value(finished(*outcome));
        if (std::isnan(here)) {
            return {here, outcome->configuration};
        }
        if (at_least ? here < found.value : here > found.value) {
            found = {here, outcome->configuration};
        }
    }
    return found;
}

Measured sum_of(const Check& check, std::span<const Outcome* const> outcomes) {
    Measured sum{.run = outcomes.front()->configuration};
    for (const Outcome* outcome : outcomes) {
        const double here = check.figure(finished(*outcome));
        if (here > 0) {
            sum = {sum.value + here, outcome->configuration};
        }
    }
    return sum;
}

Measured distinct_results(std::span<const Outcome* const> outcomes) {
    using Result = std::pair<std::uint64_t, std::map<std::string, std::uint64_t>>;
    std::map<Strategy, std::set<Result>> by_strategy;
    Measured largest{.run = outcomes.front()->configuration};
    for (const Outcome* outcome : outcomes) {
        const RunResult& r = finished(*outcome);
        std::set<Result>& results = by_strategy[r.strategy];
        results.emplace(r.mesh_hash, r.operations);
        if (static_cast<double>(results.size()) > largest.value) {
            largest = {static_cast<double>(results.size()), outcome->configuration};
        }
    }
    return largest;
}

// The meshes at the end depend on the start, for either method: the methods are compared by the
// mean over the starts.
Measured mean_difference(const Check& check, std::span<const Outcome* const> outcomes) {
    double sum = 0;
    for (std::size_t i = 0; i < outcomes.size(); i += 2) {
        sum += check.difference(finished(*outcomes[i]), finished(*outcomes[i + 1]));
    }
    return {2 * sum / static_cast<double>(outcomes.size()), outcomes.front()->configuration};
}

Measured figure_of(const Check& check, const Limit& limit,
                   std::span<const Outcome* const> outcomes) {
    const Outcome& base = *outcomes.front();
    const auto difference = [&](const RunResult& r) { return check.difference(r, finished(base)); };
    switch (check.of) {
    case Of::sequential:
        if (check.histogram != nullptr) {
            const Histogram& own = finished(base).*check.histogram;
            return {histogram_distance(own, {own.edges, limit.histogram}), base.configuration};
        }
        return {check.figure(finished(base)), base.configuration};
    case Of::worst_parallel: return worst(outcomes, 0, check.at_least, check.figure);
    case Of::all_parallel: return sum_of(check, outcomes);
    case Of::difference: return worst(outcomes, 1, false, difference);
    case Of::reference: return mean_difference(check, outcomes);
    case Of::threads: return distinct_results(outcomes);
    }
    return {};
}

} // namespace

std::string why_not(const Check& check, const Case& of) {
    if ((check.group == in_space) != (of.space != nullptr) && check.name != "accuracy_lost") {
        return of.space ? "the scene is one in three dimensions" : "the scene is one of the plane";
    }
    if (of.space) {
        return "";
    }
    if (check.figures.empty() && check.group != "fluid") {
        return "";
    }
    const scenes::Setup setup = of.file.scene.prepare(of.parameters);
    if (check.group == "fluid" && !setup.fluid) {
        return "the scene has no fluid";
    }
    const bool is_ours = of.path.empty(); // scenes of the catalogue know their shape half-way
    for (const std::string& figure : check.figures) {
        std::string reason = scenes::why_missing(figure, setup, is_ours);
        if (!reason.empty()) {
            return reason;
        }
    }
    return "";
}

std::vector<Configuration> configurations_of(const Check& check, const Case& of) {
    const Configuration base{.of = &of, .parameters = of.parameters};
    std::vector<Configuration> all;
    const auto add_parallel = [&](const std::vector<std::uint32_t>& threads) {
        for (const Strategy strategy : of.strategies) {
            for (const std::uint32_t n : of.threads.empty() ? threads : of.threads) {
                all.push_back(base);
                all.back().strategy = strategy;
                all.back().threads = n;
                all.back().is_shared = check.of == Of::threads;
            }
        }
    };
    switch (check.of) {
    case Of::sequential: return {base};
    case Of::reference:
        for (int start = 0; start < of.starts; ++start) {
            all.insert(all.end(), {base, base});
            all.back().strategy = Strategy::reference;
            for (Configuration& one : std::span(all).last(2)) {
                one.parameters.h *= 1 + 0.002 * start;
            }
        }
        return all;
    case Of::difference: all = {base}; [[fallthrough]];
    case Of::worst_parallel:
    case Of::all_parallel: add_parallel(two_threads); return all;
    case Of::threads: add_parallel(many_threads); return all;
    }
    return all;
}

const RunResult& finished(const Outcome& outcome) {
    if (outcome.error) {
        std::rethrow_exception(outcome.error);
    }
    if (!outcome.result.gave_up.empty()) {
        throw GaveUp(outcome.result.gave_up, outcome.configuration);
    }
    return outcome.result;
}

Measured measure(const Check& check, const Limit& limit, std::span<const Outcome* const> outcomes) {
    Measured measured = figure_of(check, limit, outcomes);
    if (limit.around) {
        measured.value = std::abs(measured.value - *limit.around);
    }
    return measured;
}

} // namespace dsc::gate
