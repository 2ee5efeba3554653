// SPDX-License-Identifier: MIT
#include "steps/suite.h"

#include "steps/context.h"
#include "steps/rows.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "scenes/file/case_reader.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/text_file.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace dsc::bench {

namespace {

using scenes::at_key;
using scenes::CaseReader;
using scenes::integers;
using scenes::Strategy;
using scenes::TableReader;
using scenes::texts;

constexpr std::array measure_names{
    Named{Measure::run, "run"},       Named{Measure::step, "step"},
    Named{Measure::model, "model"},   Named{Measure::option, "option"},
    Named{Measure::result, "result"},
};

constexpr int max_threads = 1024;
constexpr int max_seed = 1'000'000'000;

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
    for (const int count : integers(reader, "threads", 1, max_threads)) {
        counts.push_back(static_cast<std::uint32_t>(count));
    }
    return counts;
}

void check_name(const CaseReader& reader, const std::string& name) {
    if (name.empty() || name.size() > 64 || !std::ranges::all_of(name, [](char ch) {
            return (ch >= 'a' && ch <= 'z') || (ch >= 'A' && ch <= 'Z') ||
                   (ch >= '0' && ch <= '9') || ch == '-' || ch == '_' || ch == '.';
        })) {
        reader.refuse("name", "bad value", "1 to 64 letters, digits, -, _ and .");
    }
}

// One name for each scene; empty: the scene's own name.
std::vector<std::string> read_names(const CaseReader& reader, std::size_t scenes) {
    std::vector<std::string> names(scenes);
    if (!reader.has("name")) {
        return names;
    }
    const std::vector<std::string> given = texts(reader, "name");
    if (given.size() != 1 && given.size() != scenes) {
        reader.refuse("name", "the number of names differs from that of scenes",
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
    const std::vector<std::string> given = texts(reader, "measure");
    if (given.size() != 1) {
        reader.refuse("measure", "a case has one measure",
                      "one of " + names_in(measure_names) +
                          "; rows = [{ measure = \"step\" }, ...] for several");
    }
    const auto measure = value_in(measure_names, given.front());
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
        add({"strategies", "threads", "submeshes", "dt_over_h", "area_error", "vertex_error",
             "stop_after"});
        add({measure == Measure::run ? "between_us" : "at"});
    }
    return keys;
}

// Reads the keys that do not depend on the scenes.
SuiteCase read_keys(const CaseReader& reader) {
    SuiteCase c{
        .reader = &reader, .scenes = texts(reader, "scene"), .measure = read_measure(reader)};
    c.names = read_names(reader, c.scenes.size());
    c.sizes = scenes::read_sizes(reader);
    if (c.measure != Measure::option) {
        c.strategies = read_strategies(reader, c.measure);
        c.threads = read_threads(reader);
    }
    c.between_us = c.measure == Measure::run && reader.has("between_us")
                       ? integers(reader, "between_us", 0, 1'000'000)
                       : std::vector{0};
    if (c.measure == Measure::result && reader.has("seeds")) {
        (void)integers(reader, "seeds", 0, max_seed);
    }
    return c;
}

void read_case(const TableReader& whole, Suite& suite) {
    const std::vector<TableReader> rows = whole.tables("rows");
    if (rows.empty()) {
        const CaseReader reader(whole, nullptr);
        whole.allow(keys_of(read_measure(reader)));
        add_rows(read_keys(reader), suite);
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
        add_rows(read_keys(reader), suite);
    }
}

void check_names(const Suite& suite, const std::filesystem::path& path) {
    std::set<std::string> names;
    const auto check = [&](const std::string& name) {
        if (!names.insert(name).second) {
            throw InputError({.what = "two rows have the same name",
                              .where = path.string(),
                              .value = "'" + name + "'",
                              .allowed = "another name = \"...\" in one of the cases"});
        }
    };
    std::ranges::for_each(suite.rows, check, &Row::name);
    std::ranges::for_each(suite.space_rows, check, &SpaceRow::name);
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
    static const std::vector<std::string> names{"operation", "kernel", "flow", "space"};
    return names;
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
    if (suite.rows.empty() && suite.space_rows.empty() && suite.comparisons.empty() &&
        suite.also.empty() && !suite.has_results) {
        throw InputError({.what = "an empty suite",
                          .where = path.string(),
                          .value = "no [[case]]",
                          .allowed = "at least one [[case]]"});
    }
    check_names(suite, path);
    return suite;
}

} // namespace dsc::bench
