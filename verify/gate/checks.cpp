// SPDX-License-Identifier: MIT
#include "checks.h"

#include "scenes/catalogue/catalogue.h"

#include "accuracy.h"

#include "dsc/base/error.h"
#include "measures/histogram.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/nearest.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
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

// Flows that stretch and fold the interface: many short edges, and many of them at boundaries.
const Names winding{"swirl", "single-vortex", "swirl-zalesak"};

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

Measured distinct_hashes(Runs& runs, const std::string& scene) {
    Measured most;
    for (const Strategy strategy : scenes::all_strategies()) {
        if (!scenes::is_parallel(strategy)) {
            continue;
        }
        std::set<std::uint64_t> hashes;
        std::set<std::map<std::string, std::uint64_t>> counts;
        for (const std::uint32_t threads : {1U, 2U, 3U, 5U}) {
            const RunResult& r =
                finished(runs, {scene, Size::shared, strategy, threads, {}, false});
            hashes.insert(r.mesh_hash);
            counts.insert(r.operations);
        }
        const auto different = static_cast<double>(std::max(hashes.size(), counts.size()));
        if (different > most.value) {
            most = {different, {scene, Size::shared, strategy, 2, {}, false}};
        }
    }
    return most;
}

using Figure = std::function<double(const RunResult&)>;

Check of_sequential(std::string name, std::string description, std::string unit, bool at_least,
                    Names scenes, Figure figure, Names figures = {},
                    Culprit culprit = Culprit::none) {
    return {std::move(name),
            std::move(description),
            std::move(unit),
            at_least,
            std::move(scenes),
            [figure = std::move(figure)](Runs& runs, const std::string& scene) {
                return Measured{figure(finished(runs, {scene})), {scene}};
            },
            std::move(figures),
            culprit};
}

// The worst of all strategies. The limits are the spread of the sequential method over shuffled
// orders (verify/gate/bands.py): threads must not produce a mesh that no other order would have
// produced.
Check against_parallel(const Comparison& comparison) {
    return {comparison.name,
            comparison.description,
            "1",
            false,
            comparison.scenes,
            [difference = comparison.difference](Runs& runs, const std::string& scene) {
                const RunResult& sequential = finished(runs, {scene});
                Measured worst{.run = {scene}};
                for (const Configuration& one : parallel(scene)) {
                    const double here = difference(finished(runs, one), sequential);
                    if (std::isnan(here)) {
                        return Measured{here, one};
                    }
                    if (here > worst.value) {
                        worst = {here, one};
                    }
                }
                return worst;
            },
            comparison.figures};
}

Check least_of_parallel(std::string name, std::string description, std::string unit, Figure figure,
                        Names figures, Culprit culprit) {
    return {std::move(name),
            std::move(description),
            std::move(unit),
            true,
            every_scene(),
            [figure = std::move(figure)](Runs& runs, const std::string& scene) {
                Measured least{.value = std::numeric_limits<double>::infinity()};
                for (const Configuration& one : parallel(scene)) {
                    const double here = figure(finished(runs, one));
                    if (std::isnan(here)) {
                        return Measured{here, one};
                    }
                    if (here < least.value) {
                        least = {here, one};
                    }
                }
                return least;
            },
            std::move(figures),
            culprit};
}

Check against_reference(std::string name, std::string description,
                        Comparison::Difference difference) {
    return {
        std::move(name),
        std::move(description),
        "1",
        false,
        compared,
        [difference = std::move(difference)](Runs& runs, const std::string& scene) {
            const Configuration coarse{scene, Size::coarse};
            const RunResult& library = finished(runs, coarse);
            const RunResult& literal = finished(runs, {scene, Size::coarse, Strategy::reference});
            return Measured{difference(library, literal), coarse};
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

// Dividing the mesh makes no work: what a boundary keeps from being done for a while looks like a
// fault of the mesh, and vertices that are made for it have to go again.
double effort_ratio(const RunResult& a, const RunResult& b) {
    const auto splits_and_collapses = [](const RunResult& r) {
        return static_cast<double>(r.operations.at("splits") + r.operations.at("collapses"));
    };
    return splits_and_collapses(a) / splits_and_collapses(b);
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

std::vector<Check> make_scene_checks() {
    using enum Culprit;
    std::vector<Check> checks{
        of_sequential("area_ratio", "area against the exact shape's, both relative to their first",
                      "1", false, compared, area_drift, {"area_exact_last"}, deviation),
        of_sequential(
            "symmetric_difference", "area between the shape and the exact one at the end", "1",
            false, compared, [](const RunResult& r) { return number(r.last, "sd_rel"); },
            {"sd_rel_last"}, deviation),
        of_sequential(
            "symmetric_difference_half",
            "the same at the half of a reversing flow, where errors do not cancel", "1", false,
            {"swirl", "single-vortex"},
            [](const RunResult& r) { return number(r.half.value(), "sd_rel"); }, {"sd_rel_half"},
            deviation),
        of_sequential(
            "inverted", "triangles that are not positive, by the exact predicate", "triangles",
            false, every_scene(),
            [](const RunResult& r) { return static_cast<double>(r.inverted); }, {}, first_failure),
        of_sequential(
            "unreached", "vertices that did not arrive", "vertices", false, every_scene(),
            [](const RunResult& r) { return static_cast<double>(r.unreached); }, {},
            worst_triangle),
        of_sequential(
            "min_quality", "worst quality at the end", "1", true, every_scene(),
            [](const RunResult& r) { return number(r.last, "min_quality"); }, {"min_quality_last"},
            worst_triangle),
        against_reference("reference_area", "area ratio, library against reference",
                          area_difference),
        against_reference("reference_area_histogram",
                          "Kolmogorov-Smirnov distance of the triangles' areas", area_distance),
        against_reference("reference_quality_histogram",
                          "Kolmogorov-Smirnov distance of the triangles' qualities",
                          quality_distance),
    };
    for (const Comparison& comparison : comparisons()) {
        checks.push_back(against_parallel(comparison));
    }
    checks.push_back(
        against_parallel({"parallel_effort", "splits and collapses, parallel over sequential",
                          effort_ratio, winding}));
    std::vector<Check> of_parallel{
        least_of_parallel(
            "parallel_min_quality", "worst quality at the end, in parallel", "1",
            [](const RunResult& r) { return number(r.last, "min_quality"); }, {"min_quality_last"},
            worst_triangle),
        least_of_parallel(
            "parallel_min_angle", "smallest angle at the end, in parallel", "degrees",
            [](const RunResult& r) { return number(r.last, "min_angle_deg"); },
            {"min_angle_deg_last"}, sharpest_corner),
        {"parallel_unreached",
         "vertices that did not arrive, and triangles inverted, in parallel",
         "vertices",
         false,
         every_scene(),
         [](Runs& runs, const std::string& scene) {
             Measured sum{.run = {scene}};
             for (const Configuration& one : parallel(scene)) {
                 const RunResult& r = finished(runs, one);
                 if (r.unreached + r.inverted > 0) {
                     sum = {sum.value + static_cast<double>(r.unreached + r.inverted), one};
                 }
             }
             return sum;
         },
         {},
         first_failure},
        {"mesh_hash", "different results of 1, 2, 3 and 5 threads, by each strategy", "results",
         false, compared, distinct_hashes},
    };
    std::ranges::move(of_parallel, std::back_inserter(checks));
    return checks;
}

} // namespace

const RunResult& finished(Runs& runs, const Configuration& configuration) {
    const RunResult& result = runs.get(configuration);
    if (!result.gave_up.empty()) {
        throw GaveUp(result.gave_up, configuration);
    }
    return result;
}

const std::vector<Comparison>& comparisons() {
    static const std::vector<Comparison> all{
        {"parallel_area", "area ratio, parallel against sequential", area_difference,
         every_scene()},
        {"parallel_symmetric_difference",
         "by how much the parallel one's is the larger",
         [](const RunResult& a, const RunResult& b) {
             return std::max(number(a.last, "sd_rel") - number(b.last, "sd_rel"), 0.0);
         },
         scenes_with_exact_shape(),
         {"sd_rel_last"}},
        {"parallel_events", "merge, split, meet and exchange, parallel against sequential",
         event_difference, eventful},
        {"parallel_area_histogram", "Kolmogorov-Smirnov distance of the triangles' areas",
         area_distance, every_scene()},
        {"parallel_quality_histogram", "Kolmogorov-Smirnov distance of the triangles' qualities",
         quality_distance, every_scene()},
    };
    return all;
}

const std::vector<Check>& scene_checks() {
    static const std::vector<Check> checks = make_scene_checks();
    return checks;
}

const std::vector<Check>& all_checks() {
    static const std::vector<Check> checks = [] {
        std::vector<Check> all = scene_checks();
        std::ranges::move(accuracy_checks(), std::back_inserter(all));
        return all;
    }();
    return checks;
}

std::vector<const Check*> select_checks(const std::vector<const Check*>& checks,
                                        const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const Check* check : checks) {
        known.push_back(check->name);
    }
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) == known.end()) {
            throw InputError({.what = "unknown check",
                              .where = "run",
                              .value = scenes::quoted_excerpt(name),
                              .allowed = scenes::allowed_names(name, known)});
        }
    }
    std::vector<const Check*> selected;
    std::ranges::copy_if(checks, std::back_inserter(selected), [&](const Check* check) {
        return names.empty() || std::ranges::find(names, check->name) != names.end();
    });
    return selected;
}

void check_limits(const std::vector<Task>& tasks, const Limits& limits) {
    for (const Task& task : tasks) {
        (void)limits.find(task.check->name, task.scene);
    }
}

void check_all_read(const std::vector<Task>& tasks, const Limits& limits) {
    std::set<Limits::Key> read;
    for (const Task& task : tasks) {
        read.insert({task.check->name, task.scene});
    }
    for (const Check& check : all_checks()) {
        for (const std::string& scene : check.scenes) {
            read.insert({check.name, scene});
        }
    }
    for (const auto& [key, limit] : limits.all()) {
        if (!read.contains(key)) {
            throw InputError({.what = "a limit that no check reads",
                              .where = limits.path(),
                              .value = "'" + key.first + "', '" + key.second + "'",
                              .allowed = "the checks and scenes of `dsc_verify list`, and scenes "
                                         "whose files are given"});
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
        const Measured measured = check.measure(runs, scene);
        row.measured = measured.value;
        row.run = measured.run;
        // Written so that NaN fails.
        row.pass = check.at_least ? measured.value >= row.limit : measured.value <= row.limit;
    } catch (const GaveUp& error) {
        row.failure = error.what();
        row.run = error.run();
    } catch (const std::exception& error) {
        row.failure = error.what();
    }
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return row;
}

} // namespace dsc::gate
