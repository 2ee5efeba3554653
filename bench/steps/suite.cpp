// SPDX-License-Identifier: MIT
#include "suite.h"

#include "context.h"

#include "dsc/base/error.h"
#include "dsc/base/types.h"
#include "scenes/digits.h"
#include "scenes/file/case_reader.h"
#include "scenes/file/text_file.h"
#include "scenes/name_list.h"
#include "scenes/run/usage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace dsc::bench {

namespace {

using scenes::at_key;
using scenes::CaseReader;
using scenes::CaseSize;
using scenes::integers;
using scenes::read_settings;
using scenes::Strategy;
using scenes::TableReader;
using scenes::texts;

constexpr std::array measure_names{
    Named{Measure::run, "run"},       Named{Measure::step, "step"},
    Named{Measure::model, "model"},   Named{Measure::option, "option"},
    Named{Measure::result, "result"},
};

constexpr double own_area_error = 0.01; ///< unless a case says otherwise
constexpr int most_threads = 1024;
constexpr int most_submeshes = 65536;
constexpr int most_seed = 1'000'000'000;

/// The keys of a case that do not depend on its scenes.
struct Case {
    const CaseReader* reader = nullptr;
    std::string name{};
    Measure measure = Measure::run;
    std::vector<CaseSize> sizes{};
    std::vector<Strategy> strategies{};
    std::vector<std::uint32_t> threads{};
    std::vector<int> between_us{};
};

void check_strategy(const CaseReader& reader, Measure measure, Strategy strategy) {
    const auto refuse = [&](const char* allowed) {
        reader.refuse("strategies",
                      "measure = \"" + std::string(name_in(measure_names, measure)) +
                          "\" does not take " + scenes::to_string(strategy),
                      allowed);
    };
    if (measure == Measure::run && strategy == Strategy::reference) {
        refuse("any other, or measure = \"step\"");
    }
    if (measure == Measure::model &&
        (!scenes::is_parallel(strategy) || strategy == Strategy::copy)) {
        refuse("those that divide the mesh in place: fixed, counting, active, blocks, cells");
    }
}

std::vector<Strategy> read_strategies(const CaseReader& reader, Measure measure) {
    if (!reader.has("strategies")) {
        return measure == Measure::model    ? std::vector{Strategy::cells}
               : measure == Measure::result ? std::vector{Strategy::sequential}
                                            : std::vector{Strategy::sequential, Strategy::cells};
    }
    std::vector<Strategy> strategies;
    for (const std::string& name : texts(reader, "strategies")) {
        strategies.push_back(at_key(reader.of("strategies"), "strategies",
                                    [&] { return scenes::parse_strategy(name); }));
        check_strategy(reader, measure, strategies.back());
    }
    return strategies;
}

std::vector<std::uint32_t> read_threads(const CaseReader& reader) {
    if (!reader.has("threads") || reader.is_text("threads", "cores")) {
        return thread_counts();
    }
    if (reader.is_text("threads")) {
        reader.refuse("threads", "bad value", "whole numbers, or \"cores\"");
    }
    std::vector<std::uint32_t> counts;
    for (const int count : integers(reader, "threads", 1, most_threads)) {
        counts.push_back(static_cast<std::uint32_t>(count));
    }
    return counts;
}

// 0: chosen during the run.
std::uint32_t submeshes_of(const Case& c, Strategy strategy, std::uint32_t threads) {
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
        reader.of("submeshes").integer("submeshes", 1, most_submeshes));
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

// Everything that a start depends on, as text: doubles by their bits.
std::string key_of(const Workload& workload, const std::string& scene) {
    std::string key = scene;
    const auto add = [&](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        key += '/';
        if constexpr (std::is_same_v<Value, std::string>) {
            key += value;
        } else if constexpr (std::is_same_v<Value, double>) {
            key += std::to_string(std::bit_cast<std::uint64_t>(value));
        } else {
            key += std::to_string(value);
        }
    };
    for (const scenes::Key& one : scenes::parameter_keys()) {
        std::visit(add, one.value(workload.parameters));
    }
    add(static_cast<int>(workload.part));
    add(workload.around);
    add(workload.dt_over_h.value_or(-1));
    add(workload.area_error.value_or(-1));
    return key;
}

std::string name_of(const Case& c, const std::string& size, const Row& row, bool names_submeshes) {
    std::string name = c.name + (c.measure == Measure::run ? "_run" : "_step") +
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

void add_rows(const Case& c, const std::string& size, const scenes::Scene& scene,
              const std::shared_ptr<Start>& start, Suite& suite) {
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
                row.name = name_of(c, size, row, names_submeshes);
                at_key(c.reader->of("strategies"), "strategies", [&] {
                    scenes::check_usage(scene, start->setup, start->parameters,
                                        row.options(threads));
                });
                suite.rows.push_back(std::move(row));
            }
        }
    }
}

void add_comparison(const Case& c, const scenes::Scene& scene, scenes::Parameters without,
                    Suite& suite) {
    if (!c.reader->has("option")) {
        c.reader->refuse("option", "the option that is compared is missing",
                         "option = { key = value }");
    }
    Comparison comparison{.name = "option/" + c.name + '/' + scene.name,
                          .scene = scene,
                          .without = without,
                          .with = without,
                          .same_mesh = c.reader->of("same_mesh").flag_or(false, "same_mesh")};
    read_settings(*c.reader, "option", scene, comparison.with);
    suite.comparisons.push_back(std::move(comparison));
}

// What dsc_scene would refuse, before the first of many runs.
void check_results(const Case& c, const Workload& workload) {
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

void check_name(const CaseReader& reader, const std::string& name) {
    if (name.empty() || name.size() > 64 || !std::ranges::all_of(name, [](char ch) {
            return (ch >= 'a' && ch <= 'z') || (ch >= 'A' && ch <= 'Z') ||
                   (ch >= '0' && ch <= '9') || ch == '-' || ch == '_' || ch == '.';
        })) {
        reader.refuse("name", "bad value", "1 to 64 letters, digits, -, _ and .");
    }
}

// One for each scene; empty: that of the scene itself.
std::vector<std::string> read_names(const CaseReader& reader, std::size_t scenes) {
    std::vector<std::string> names(scenes);
    if (!reader.has("name")) {
        return names;
    }
    const std::vector<std::string> given = texts(reader, "name");
    if (given.size() != 1 && given.size() != scenes) {
        reader.refuse("name", "not as many names as scenes",
                      "one, or " + std::to_string(scenes) + " of them");
    }
    for (std::size_t i = 0; i < scenes; ++i) {
        names[i] = given.size() == 1 ? given.front() : given[i];
        check_name(reader, names[i]);
    }
    return names;
}

Measure read_measure(const CaseReader& reader) {
    if (!reader.has("measure")) {
        return Measure::run;
    }
    const auto measure = value_in(measure_names, reader.of("measure").text("measure"));
    if (!measure) {
        reader.refuse("measure", "unknown measure", names_in(measure_names));
    }
    return *measure;
}

std::vector<std::string> keys_of(Measure measure) {
    std::vector<std::string> keys{"name", "scene", "measure", "triangles", "h", "set"};
    std::ranges::copy(scenes::case_keys_of_verify(), std::back_inserter(keys));
    const auto add = [&](std::initializer_list<const char*> more) {
        keys.insert(keys.end(), more.begin(), more.end());
    };
    if (measure == Measure::option) {
        add({"option", "same_mesh"});
    } else if (measure == Measure::result) {
        add({"strategies", "threads", "submeshes", "dt_over_h", "seeds"});
    } else {
        add({"strategies", "threads", "submeshes", "dt_over_h", "area_error"});
        add({measure == Measure::run ? "between_us" : "at"});
    }
    return keys;
}

void read_rows(const CaseReader& reader, Suite& suite) {
    Case c{.reader = &reader, .measure = read_measure(reader)};
    c.sizes = scenes::read_sizes(reader);
    if (c.measure != Measure::option) {
        c.strategies = read_strategies(reader, c.measure);
        c.threads = read_threads(reader);
    }
    c.between_us = c.measure == Measure::run && reader.has("between_us")
                       ? integers(reader, "between_us", 0, 1'000'000)
                       : std::vector{0};
    suite.has_results = suite.has_results || c.measure == Measure::result;
    if (c.measure == Measure::result && reader.has("seeds")) {
        (void)integers(reader, "seeds", 0, most_seed);
    }
    const std::vector<std::string> scenes = texts(reader, "scene");
    const std::vector<std::string> names = read_names(reader, scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const scenes::Scene scene = scenes::read_scene(reader, scenes[i]).scene;
        c.name = names[i].empty() ? scene.name : names[i];
        Workload workload{.scene = scene, .parameters = scene.defaults};
        read_settings(reader, "set", scene, workload.parameters);
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
                add_comparison(c, scene, workload.parameters, suite);
                continue;
            }
            if (c.measure == Measure::result) {
                check_results(c, workload);
                continue;
            }
            const auto start =
                start_of(workload, key_of(workload, scenes[i]), reader.where("scene"));
            add_rows(c,
                     size.name.empty() ? "h:" + scenes::shortest_digits(workload.parameters.h)
                                       : size.name,
                     scene, start, suite);
        }
    }
}

void read_case(const TableReader& whole, Suite& suite) {
    const std::vector<TableReader> rows = whole.tables("rows");
    if (rows.empty()) {
        const CaseReader reader(whole, nullptr);
        whole.allow(keys_of(read_measure(reader)));
        read_rows(reader, suite);
        return;
    }
    std::vector<std::string> all{"rows"};
    for (const Named<Measure>& measure : measure_names) {
        const std::vector<std::string> keys = keys_of(measure.value);
        all.insert(all.end(), keys.begin(), keys.end());
    }
    whole.allow(all);
    for (const TableReader& row : rows) {
        const CaseReader reader(whole, &row);
        row.allow(keys_of(read_measure(reader)));
        read_rows(reader, suite);
    }
}

void check_names(const Suite& suite, const std::filesystem::path& path) {
    std::set<std::string> names;
    const auto check = [&](const std::string& name) {
        if (!names.insert(name).second) {
            throw InputError({.what = "two rows of one name",
                              .where = path.string(),
                              .value = "'" + name + "'",
                              .allowed = "another name = \"...\" in one of the cases"});
        }
    };
    std::ranges::for_each(suite.rows, check, &Row::name);
    std::ranges::for_each(suite.comparisons, check, &Comparison::name);
}

std::string read_text(const std::filesystem::path& path) {
    try {
        return scenes::read_text_file(path);
    } catch (const FileError& error) {
        throw InputError({.what = error.what(),
                          .where = "--suite",
                          .value = "'" + path.string() + "'",
                          .allowed = "a suite that can be read; bench/suites has some"});
    }
}

} // namespace

const std::vector<std::string>& also_names() {
    static const std::vector<std::string> names{"operation", "kernel", "flow"};
    return names;
}

scenes::RunOptions Row::options(std::uint32_t on_threads) const {
    scenes::RunOptions options;
    options.strategy = strategy;
    options.submeshing.submeshes = submeshes;
    options.submeshing.threads = on_threads;
    // A run takes as many threads as pay, as that of an application does.
    options.submeshing.always_all_threads = measure != Measure::run;
    return options;
}

Suite read_suite(const std::filesystem::path& path) {
    const toml::table table = scenes::parse_toml(read_text(path), path);
    const TableReader top(table, "", path);
    std::vector<std::string> allowed{"also", "case"};
    std::ranges::copy(scenes::keys_of_verify(), std::back_inserter(allowed));
    top.allow(allowed);
    Suite suite;
    for (const TableReader& reader : top.tables("case")) {
        read_case(reader, suite);
    }
    if (top.has("also")) {
        suite.also = top.texts("also");
        for (const std::string& name : suite.also) {
            if (std::ranges::find(also_names(), name) == also_names().end()) {
                top.refuse("also", "unknown rows", scenes::name_list(also_names()));
            }
        }
    }
    if (suite.rows.empty() && suite.comparisons.empty() && suite.also.empty() &&
        !suite.has_results) {
        throw InputError({.what = "an empty suite",
                          .where = path.string(),
                          .value = "no [[case]]",
                          .allowed = "at least one [[case]]"});
    }
    check_names(suite, path);
    return suite;
}

} // namespace dsc::bench
