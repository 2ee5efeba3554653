// SPDX-License-Identifier: MIT
#include "checks.h"

#include "scenes/catalogue/catalogue.h"

#include "accuracy.h"

#include "dsc/base/error.h"
#include "dsc/quality/histogram.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>

namespace dsc::gate {

namespace {

using scenes::RunResult;
using scenes::Strategy;
using Names = std::vector<std::string>;

const Names compared{"scaling", "translation",  "rotation-rectangle", "speedup-four-circles",
                     "swirl",   "single-vortex"};

Names every_scene() {
    Names names;
    for (const auto& scene : scenes::catalogue()) {
        names.push_back(scene.name);
    }
    return names;
}

Names scenes_with_exact_shape() {
    Names names;
    for (const auto& scene : scenes::catalogue()) {
        if (scene.prepare(scene.defaults).exact) {
            names.push_back(scene.name);
        }
    }
    return names;
}

// Scenes in which phases merge or part in a way that does not depend on the order of operations.
const Names eventful{"grow-shrink", "erode-dumbbell", "drop-and-pool", "t1"};

// The parallel runs; two threads stand for any number, since `mesh_hash` shows no difference.
std::vector<Configuration> parallel(const std::string& scene) {
    std::vector<Configuration> all;
    for (const Strategy strategy : scenes::all_strategies()) {
        if (scenes::is_parallel(strategy)) {
            all.push_back({scene, Size::full, strategy, 2});
        }
    }
    return all;
}

// How far the change of the area differs from that of the exact shape; for flows without divergence
// |A(t) / A(0) - 1|.
double area_drift(const RunResult& r) {
    return std::abs(r.area_ratio / (number(r.last, "area_exact") / r.area_exact_first) - 1);
}

// Runs that break their invariants say nothing about anything else.
const RunResult& finished(const RunResult& r) {
    if (!r.gave_up.empty()) {
        throw InvariantError("the run gave up: " + r.gave_up);
    }
    return r;
}

double distinct_hashes(Runs& runs, const std::string& scene) {
    double most = 0;
    for (const Strategy strategy : scenes::all_strategies()) {
        if (!scenes::is_parallel(strategy)) {
            continue;
        }
        std::set<std::uint64_t> hashes;
        std::set<std::map<std::string, std::uint64_t>> counts;
        for (const std::uint32_t threads : {1U, 2U, 3U, 5U}) {
            const RunResult& r =
                finished(runs.get({scene, Size::coarse, strategy, threads, {}, false}));
            hashes.insert(r.mesh_hash);
            counts.insert(r.operations);
        }
        most = std::max(most, static_cast<double>(std::max(hashes.size(), counts.size())));
    }
    return most;
}

using Figure = std::function<double(const RunResult&)>;
using Difference = std::function<double(const RunResult&, const RunResult&)>;

Check of_sequential(std::string name, std::string description, std::string unit, bool at_least,
                    Names scenes, Figure figure) {
    return {std::move(name),
            std::move(description),
            std::move(unit),
            at_least,
            std::move(scenes),
            [figure = std::move(figure)](Runs& runs, const std::string& scene) {
                return figure(finished(runs.get({scene})));
            }};
}

// The worst of all strategies. The limits are the spread of the sequential method over shuffled
// orders (verify/gate/bands.py): threads must not produce a mesh that no other order would have
// produced.
Check against_parallel(std::string name, std::string description, Difference difference,
                       Names scenes = every_scene()) {
    return {std::move(name),
            std::move(description),
            "1",
            false,
            std::move(scenes),
            [difference = std::move(difference)](Runs& runs, const std::string& scene) {
                const RunResult& sequential = finished(runs.get({scene}));
                double worst = 0;
                for (const Configuration& one : parallel(scene)) {
                    worst = std::max(worst, difference(finished(runs.get(one)), sequential));
                }
                return worst;
            }};
}

Check least_of_parallel(std::string name, std::string description, std::string unit,
                        Figure figure) {
    return {std::move(name),
            std::move(description),
            std::move(unit),
            true,
            every_scene(),
            [figure = std::move(figure)](Runs& runs, const std::string& scene) {
                double least = std::numeric_limits<double>::infinity();
                for (const Configuration& one : parallel(scene)) {
                    least = std::min(least, figure(finished(runs.get(one))));
                }
                return least;
            }};
}

Check against_reference(std::string name, std::string description, Difference difference) {
    return {std::move(name),
            std::move(description),
            "1",
            false,
            compared,
            [difference = std::move(difference)](Runs& runs, const std::string& scene) {
                const RunResult& library = finished(runs.get({scene, Size::coarse}));
                return difference(library,
                                  finished(runs.get({scene, Size::coarse, Strategy::reference})));
            }};
}

double area_difference(const RunResult& a, const RunResult& b) {
    return std::abs(a.area_ratio - b.area_ratio) / b.area_ratio;
}

double area_distance(const RunResult& a, const RunResult& b) {
    return histogram_distance(a.area_histogram, b.area_histogram);
}

double quality_distance(const RunResult& a, const RunResult& b) {
    return histogram_distance(a.quality_histogram, b.quality_histogram);
}

// Of the kinds that say how pieces are joined; how often a seam goes on depends on the order.
double event_difference(const RunResult& a, const RunResult& b) {
    double sum = 0;
    for (const EventKind kind :
         {EventKind::merge, EventKind::split, EventKind::meet, EventKind::exchange}) {
        const auto in_a = std::ranges::count(a.events, kind, &Event::kind);
        const auto in_b = std::ranges::count(b.events, kind, &Event::kind);
        sum += static_cast<double>(std::abs(in_a - in_b));
    }
    return sum;
}

std::vector<Check> make_checks() {
    std::vector<Check> checks{
        of_sequential("area_ratio", "area against the exact shape's, both relative to their first",
                      "1", false, compared, area_drift),
        of_sequential("symmetric_difference", "area between the shape and the exact one at the end",
                      "1", false, compared,
                      [](const RunResult& r) { return number(r.last, "sd_rel"); }),
        of_sequential("symmetric_difference_half",
                      "the same at the half of a reversing flow, where errors do not cancel", "1",
                      false, {"swirl", "single-vortex"},
                      [](const RunResult& r) { return number(r.half.value(), "sd_rel"); }),
        of_sequential("inverted", "triangles that are not positive, by the exact predicate",
                      "triangles", false, every_scene(),
                      [](const RunResult& r) { return static_cast<double>(r.inverted); }),
        of_sequential("unreached", "vertices that did not arrive", "vertices", false, every_scene(),
                      [](const RunResult& r) { return static_cast<double>(r.unreached); }),
        of_sequential("min_quality", "worst quality at the end", "1", true, every_scene(),
                      [](const RunResult& r) { return number(r.last, "min_quality"); }),
        against_reference("reference_area", "area ratio, library against reference",
                          area_difference),
        against_reference("reference_area_histogram",
                          "Kolmogorov-Smirnov distance of the triangles' areas", area_distance),
        against_reference("reference_quality_histogram",
                          "Kolmogorov-Smirnov distance of the triangles' qualities",
                          quality_distance),
        against_parallel("parallel_area", "area ratio, parallel against sequential",
                         area_difference),
        against_parallel(
            "parallel_symmetric_difference", "by how much the parallel one's is the larger",
            [](const RunResult& a, const RunResult& b) {
                return std::max(number(a.last, "sd_rel") - number(b.last, "sd_rel"), 0.0);
            },
            scenes_with_exact_shape()),
        against_parallel("parallel_events",
                         "merge, split, meet and exchange, parallel against sequential",
                         event_difference, eventful),
        against_parallel("parallel_area_histogram",
                         "Kolmogorov-Smirnov distance of the triangles' areas", area_distance),
        against_parallel("parallel_quality_histogram",
                         "Kolmogorov-Smirnov distance of the triangles' qualities",
                         quality_distance),
        least_of_parallel("parallel_min_quality", "worst quality at the end, in parallel", "1",
                          [](const RunResult& r) { return number(r.last, "min_quality"); }),
        least_of_parallel("parallel_min_angle", "smallest angle at the end, in parallel", "degrees",
                          [](const RunResult& r) { return number(r.last, "min_angle_deg"); }),
        {"parallel_unreached", "vertices that did not arrive, and triangles inverted, in parallel",
         "vertices", false, every_scene(),
         [](Runs& runs, const std::string& scene) {
             double sum = 0;
             for (const Configuration& one : parallel(scene)) {
                 const RunResult& r = finished(runs.get(one));
                 sum += static_cast<double>(r.unreached + r.inverted);
             }
             return sum;
         }},
        {"mesh_hash", "different results of 1, 2, 3 and 5 threads, by each strategy", "results",
         false, compared, distinct_hashes},
    };
    for (Check& check : accuracy_checks()) {
        checks.push_back(std::move(check));
    }
    return checks;
}

} // namespace

const std::vector<Check>& all_checks() {
    static const std::vector<Check> checks = make_checks();
    return checks;
}

std::vector<const Check*> select_checks(const std::vector<std::string>& names) {
    const auto& checks = all_checks();
    std::string known;
    for (const Check& check : checks) {
        known += (known.empty() ? "" : ", ") + check.name;
    }
    for (const std::string& name : names) {
        if (std::none_of(checks.begin(), checks.end(),
                         [&](const Check& check) { return check.name == name; })) {
            throw InputError({.what = "unknown check",
                              .where = "run",
                              .value = "'" + name + "'",
                              .allowed = known});
        }
    }
    std::vector<const Check*> selected;
    for (const Check& check : checks) {
        if (names.empty() || std::find(names.begin(), names.end(), check.name) != names.end()) {
            selected.push_back(&check);
        }
    }
    return selected;
}

void check_limits(const std::vector<const Check*>& checks, const Limits& limits) {
    for (const Check* check : checks) {
        for (const std::string& scene : check->scenes) {
            (void)limits.find(check->name, scene);
        }
    }
    std::set<Limits::Key> read;
    for (const Check& check : all_checks()) {
        for (const std::string& scene : check.scenes) {
            read.insert({check.name, scene});
        }
    }
    for (const auto& [key, limit] : limits.all()) {
        if (read.count(key) == 0) {
            throw InputError({.what = "a limit that no check reads",
                              .where = limits.path(),
                              .value = "'" + key.first + "', '" + key.second + "'",
                              .allowed = "the checks and scenes of `dsc_verify list`"});
        }
    }
}

Row judge(const Check& check, const std::string& scene, const Limits& limits, Runs& runs) {
    Row row;
    row.check = &check;
    row.scene = scene;
    row.limit = limits.find(check.name, scene).value;
    const auto start = std::chrono::steady_clock::now();
    try {
        const double measured = check.measure(runs, scene);
        row.measured = measured;
        // Written so that NaN fails.
        row.pass = check.at_least ? measured >= row.limit : measured <= row.limit;
    } catch (const std::exception& error) {
        row.failure = error.what();
    }
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return row;
}

} // namespace dsc::gate
