// SPDX-License-Identifier: MIT
#include "steps/rows.h"

#include "steps/context.h"
#include "steps/space/rows.h"

#include "dsc/base/error.h"
#include "dsc/parallel/executors.h"
#include "scenes/run/run.h"

#include <algorithm>
#include <utility>

namespace dsc::bench {

namespace {

using scenes::at_key;
using scenes::CaseReader;
using scenes::CaseSize;
using scenes::read_settings;
using scenes::Strategy;

constexpr double own_area_error = 0.01; ///< unless a case says otherwise
constexpr int max_submeshes = 65536;

// The number of submeshes; 0: chosen during the run.
std::uint32_t submeshes_of(const SuiteCase& c, Strategy strategy, std::uint32_t threads) {
    const CaseReader& reader = *c.reader;
    if (!reader.has("submeshes")) {
        const std::uint32_t own = scenes::submeshes_of(strategy, {});
        return c.measure == Measure::run || own == 0 ? 0 : std::max(own, threads);
    }
    if (reader.is_text("submeshes", "threads")) {
        return threads;
    }
    if (reader.is_text("submeshes", "cores")) {
        return core_count();
    }
    if (reader.is_text("submeshes")) {
        reader.refuse("submeshes", "bad value", "a whole number, \"threads\" or \"cores\"");
    }
    return static_cast<std::uint32_t>(
        reader.of("submeshes").integer("submeshes", 1, max_submeshes));
}

std::optional<double> read_area_error(const CaseReader& reader) {
    if (!reader.has("area_error")) {
        return own_area_error;
    }
    if (reader.is_text("area_error", "round")) {
        return std::nullopt;
    }
    if (reader.is_text("area_error")) {
        reader.refuse("area_error", "bad value", "a number, or \"round\"");
    }
    return reader.of("area_error").number("area_error", {0, 1});
}

void read_part(const CaseReader& reader, Measure measure, Workload& workload) {
    if (measure == Measure::run) {
        workload.part = Part::whole;
    } else if (!reader.has("at")) {
        workload.part = Part::middle;
    } else if (reader.is_text("at", "half")) {
        workload.part = Part::before_half;
    } else if (reader.is_text("at")) {
        reader.refuse("at", "bad value", "a time, or \"half\"");
    } else {
        workload.part = Part::around;
        workload.around = reader.of("at").number("at", {0, 1e6});
    }
}

// A text of all parameters on which a start depends.
std::string key_of(const Workload& workload, const std::string& scene) {
    std::string key = scene + scenes::text_of(workload.parameters) + '/' +
                      std::to_string(static_cast<int>(workload.part));
    for (const double value :
         {workload.around, workload.dt_over_h.value_or(-1), workload.area_error.value_or(-1)}) {
        key += '/' + to_text(value);
    }
    return key;
}

std::string name_of(const SuiteCase& c, const std::string& of, const std::string& size,
                    const Row& row, bool names_submeshes) {
    std::string name = of + (c.measure == Measure::run ? "_run" : "_step") +
                       "/strategy:" + scenes::to_string(row.strategy) + '/' + size;
    if (scenes::is_parallel(row.strategy)) {
        if (names_submeshes) {
            name += "/submeshes:" + std::to_string(row.submeshes);
        }
        name += "/threads:" + std::to_string(row.threads);
    }
    if (c.measure == Measure::run) {
        name += "/between_us:" + std::to_string(row.between_us);
    }
    return c.measure == Measure::model ? name + "/modelled:1" : name;
}

void add_rows_of(const SuiteCase& c, const std::string& name, const std::string& size,
                 const scenes::Scene& scene, const std::shared_ptr<Start>& start, Suite& suite) {
    const bool names_submeshes = c.measure != Measure::run || c.reader->has("submeshes");
    for (const int between_us : c.between_us) {
        for (const Strategy strategy : c.strategies) {
            for (const std::uint32_t threads :
                 scenes::is_parallel(strategy) ? c.threads : std::vector<std::uint32_t>{1}) {
                Row row{.measure = c.measure,
                        .start = start,
                        .strategy = strategy,
                        .submeshes = submeshes_of(c, strategy, threads),
                        .threads = threads,
                        .between_us = between_us};
                row.name = name_of(c, name, size, row, names_submeshes);
                at_key(c.reader->of("strategies"), "strategies", [&] {
                    scenes::check_usage(scene, start->setup, start->parameters,
                                        row.options(threads));
                });
                suite.rows.push_back(std::move(row));
            }
        }
    }
}

void add_comparison(const SuiteCase& c, const std::string& name, const scenes::Scene& scene,
                    scenes::Parameters without, Suite& suite) {
    if (!c.reader->has("option")) {
        c.reader->refuse("option", "the option that is compared is missing",
                         "option = { key = value }");
    }
    Comparison comparison{.name = "option/" + name + '/' + scene.name,
                          .scene = scene,
                          .without = without,
                          .with = without,
                          .same_mesh = c.reader->of("same_mesh").flag_or(false, "same_mesh")};
    read_settings(*c.reader, "option", scene.keys, comparison.with);
    suite.comparisons.push_back(std::move(comparison));
}

// Finds errors that dsc_scene would refuse before the first of many runs.
void check_results(const SuiteCase& c, const Workload& workload) {
    for (const char* key : {"threads", "submeshes"}) {
        if (c.reader->has(key) && c.reader->is_text(key)) {
            c.reader->refuse(key, "bad value", "whole numbers in measure = \"result\"");
        }
    }
    scenes::Parameters parameters = workload.parameters;
    parameters.dt = workload.dt_over_h ? *workload.dt_over_h * parameters.h : parameters.dt;
    at_key(c.reader->of("scene"), "scene", [&] {
        const scenes::Setup setup = workload.scene.prepare(parameters);
        for (const Strategy strategy : c.strategies) {
            scenes::check_usage(workload.scene, setup, parameters,
                                Row{.strategy = strategy}.options(1));
        }
    });
}

} // namespace

scenes::RunOptions Row::options(std::uint32_t on_threads) const {
    scenes::RunOptions options;
    options.strategy = strategy;
    options.submeshing.submeshes = submeshes;
    options.submeshing.threads = on_threads;
    // A whole run uses as many threads as pay off, as in an application.
    options.submeshing.always_all_threads = measure != Measure::run;
    return options;
}

void add_rows(const SuiteCase& c, Suite& suite) {
    const CaseReader& reader = *c.reader;
    suite.has_results = suite.has_results || c.measure == Measure::result;
    for (std::size_t i = 0; i < c.scenes.size(); ++i) {
        if (const auto in_space = find_in_space(reader, c.scenes[i])) {
            add_rows_in_space(c, *in_space, c.names[i], suite);
            continue;
        }
        if (reader.has("vertex_error")) {
            reader.refuse("vertex_error", "only for scenes in three dimensions", "area_error");
        }
        if (reader.has("stop_after")) {
            reader.refuse("stop_after", "only for scenes in three dimensions",
                          R"(measure = "step", or set = { dt = ..., steps = ... })");
        }
        const scenes::Scene scene = scenes::read_scene(reader, c.scenes[i]).scene;
        const std::string name = c.names[i].empty() ? scene.name : c.names[i];
        Workload workload{.scene = scene, .parameters = scene.defaults};
        read_settings(reader, "set", scene.keys, workload.parameters);
        if (c.measure != Measure::option) {
            if (reader.has("dt_over_h")) {
                workload.dt_over_h = reader.of("dt_over_h").number("dt_over_h", {1e-6, 1e3});
            }
            workload.area_error = read_area_error(reader);
            read_part(reader, c.measure, workload);
        }
        for (const CaseSize& size : c.sizes) {
            workload.parameters.h = size.h > 0 ? size.h : workload.parameters.h;
            if (c.measure == Measure::option) {
                add_comparison(c, name, scene, workload.parameters, suite);
                continue;
            }
            if (c.measure == Measure::result) {
                check_results(c, workload);
                continue;
            }
            const auto start =
                start_of(workload, key_of(workload, c.scenes[i]), reader.where("scene"));
            add_rows_of(c, name,
                        size.name.empty() ? "h:" + to_text(workload.parameters.h) : size.name,
                        scene, start, suite);
        }
    }
}

} // namespace dsc::bench
