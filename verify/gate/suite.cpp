// SPDX-License-Identifier: MIT
#include "suite.h"

#include "dsc/base/error.h"
#include "scenes/file/case_reader.h"
#include "scenes/file/text_file.h"
#include "scenes/run/fluid_run.h"
#include "scenes/run/run.h"
#include "scenes/space/scene_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace dsc::gate {

namespace {

using scenes::at_key;
using scenes::CaseReader;
using scenes::CaseSize;
using scenes::Strategy;
using scenes::TableReader;

// Turns a FileError into an InputError: a suite that cannot be read is bad usage.
template <class Read>
auto readable(const std::string& path, Read read) {
    try {
        return read();
    } catch (const FileError& error) {
        throw InputError({.what = error.what(),
                          .where = "run",
                          .value = "'" + path + "'",
                          .allowed = "a suite or a scene file that can be read"});
    }
}

std::string read_text(const std::string& path) {
    return readable(path, [&] { return scenes::read_text_file(path); });
}

/// The entries that hold for all cases of a suite.
struct Common {
    std::optional<TableReader> limits;
    std::optional<TableReader> defaults;
    std::vector<std::string> required; ///< checks
    bool needs_limits = true;
};

void check_known(const TableReader& limits) {
    for (const std::string& name : limits.keys()) {
        at_key(limits, name, [&] { (void)find_check(name); });
    }
}

void read_limits(const TableReader& limits, const Common& common, bool is_own, Case& c) {
    check_known(limits);
    for (const auto& check : all_checks()) {
        if (!limits.has(check->name) ||
            std::ranges::any_of(c.held, [&](const Held& held) { return held.check == check; })) {
            continue;
        }
        Limit limit = read_limit(limits, common.defaults, *check);
        limit.is_own = is_own;
        const std::string reason = why_not(*check, c);
        if (!reason.empty()) {
            limits.refuse(check->name,
                          "the run does not measure the figure of this limit in case " + c.name +
                              ", " + reason,
                          "figures that the run measures");
        }
        c.held.push_back({check, limit});
    }
}

void read_held(const CaseReader& reader, const Common& common, Case& c) {
    if (reader.has("limits")) {
        read_limits(reader.of("limits").table("limits"), common, true, c);
    }
    if (common.limits) {
        read_limits(*common.limits, common, false, c);
    }
    for (const std::string& name : common.required) {
        if (std::ranges::any_of(c.held,
                                [&](const Held& held) { return held.check->name == name; })) {
            continue;
        }
        if (common.needs_limits) {
            reader.refuse("scene", "a limit is missing, " + name + " of case " + c.name,
                          "one for each check of every_case_has");
        }
        c.missing.push_back(name);
    }
    if (c.held.empty() && common.needs_limits) {
        reader.refuse("scene", "the case has no limits",
                      "[case.limits], such as `dsc_verify propose --update` writes");
    }
}

void read_strategies(const CaseReader& reader, Case& c) {
    c.strategies = scenes::parallel_strategies();
    if (reader.has("strategies")) {
        c.strategies.clear();
        for (const std::string& name : texts(reader, "strategies")) {
            const Strategy strategy = at_key(reader.of("strategies"), "strategies",
                                             [&] { return scenes::parse_strategy(name); });
            if (scenes::is_parallel(strategy)) { // other strategies serve for comparison anyway
                c.strategies.push_back(strategy);
            }
        }
    }
    if (reader.has("threads") && !reader.is_text("threads")) {
        for (const int count : integers(reader, "threads", 1, 1024)) {
            c.threads.push_back(static_cast<std::uint32_t>(count));
        }
    }
}

// The case of a scene in three dimensions, still without limits.
Case case_in_space(const scenes::space::SceneFile& file, const std::string& path) {
    Case c{.name = file.scene.name, .file = {}};
    c.space = std::make_shared<const scenes::space::Scene>(file.scene);
    c.path = path;
    c.file.scene.name = file.scene.name;
    c.file.scene.defaults = file.scene.defaults;
    c.file.scene.keys = file.scene.keys;
    c.file.limits = file.limits;
    c.parameters = file.scene.defaults;
    return c;
}

// Refuses parameters that dsc_scene would refuse, before any run starts.
void check_usage(const CaseReader& reader, const Case& c) {
    if (c.space) {
        at_key(reader.of("scene"), "scene", [&] { (void)c.space->prepare(c.parameters); });
        return;
    }
    const scenes::Scene& scene = c.file.scene;
    at_key(reader.of("scene"), "scene", [&] {
        const scenes::Setup setup = scene.prepare(c.parameters);
        for (const Held& held : c.held) {
            for (const Configuration& run : configurations_of(*held.check, c)) {
                scenes::check_usage(scene, setup, c.parameters, run.options());
            }
        }
    });
}

// `table` is the index of the [[case]]; none for one of its rows. A case keeps it only if no other
// case comes from the same [[case]].
void read_rows(const CaseReader& reader, const Common& common, std::optional<std::size_t> table,
               Cases& cases) {
    const std::vector<std::string> scenes = texts(reader, "scene");
    const std::vector<CaseSize> sizes = scenes::read_sizes(reader);
    for (const std::string& scene : scenes) {
        const auto* const found = scenes::space::find_scene(scene);
        Case c = found != nullptr ? case_in_space({.scene = *found}, "")
                                  : Case{.name = {}, .file = scenes::read_scene(reader, scene)};
        if (scenes::is_scene_file(scene)) {
            c.path = (reader.of("scene").file().parent_path() / scene).string();
        }
        const std::string name =
            reader.has("name") ? reader.of("name").text("name") : c.file.scene.name;
        c.parameters = c.file.scene.defaults;
        scenes::read_settings(reader, "set", c.file.scene.keys, c.parameters);
        if (!c.space) {
            read_strategies(reader, c);
        }
        if (reader.has("starts")) {
            c.starts = reader.of("starts").integer("starts", 1, 1000);
        }
        for (const CaseSize& size : sizes) {
            Case sized = c;
            sized.parameters.h = size.h > 0 ? size.h : sized.parameters.h;
            sized.name = name + (sizes.size() > 1 ? " h:" + to_text(sized.parameters.h) : "");
            if (reader.has("dt_over_h")) {
                sized.parameters.dt =
                    sized.parameters.h * reader.of("dt_over_h").number("dt_over_h", {1e-6, 1e3});
            }
            if (scenes.size() == 1 && sizes.size() == 1) {
                sized.table = table;
            }
            read_held(reader, common, sized);
            const auto made = std::make_shared<const Case>(std::move(sized));
            check_usage(reader, *made);
            cases.push_back(made);
        }
    }
}

void read_case(const TableReader& whole, std::size_t number, const Common& common, Cases& cases) {
    std::vector<std::string> keys{"name",       "scene",   "h",         "triangles", "set",
                                  "strategies", "threads", "dt_over_h", "rows"};
    std::ranges::copy(scenes::case_keys_of_verify(), std::back_inserter(keys));
    std::ranges::copy(scenes::case_keys_of_bench(), std::back_inserter(keys));
    whole.allow(keys);
    const std::vector<TableReader> rows = whole.tables("rows");
    if (rows.empty()) {
        read_rows(CaseReader(whole, nullptr), common, number, cases);
    }
    for (const TableReader& row : rows) {
        row.allow(keys);
        read_rows(CaseReader(whole, &row), common, std::nullopt, cases);
    }
}

std::optional<TableReader> table_of(const TableReader& top, const std::string& key) {
    return top.has(key) ? std::optional(top.table(key)) : std::nullopt;
}

// The only figure that takes a mesh to know whether a run has it.
void check_circularity(const Case& c) {
    const auto limit = std::ranges::find_if(c.file.limits, [](const scenes::FigureLimit& one) {
        return one.figure.starts_with("circularity");
    });
    if (limit != c.file.limits.end() &&
        !scenes::has_circularity(c.file.scene.prepare(c.parameters), c.parameters)) {
        throw InputError(
            {.what = "the run does not measure the figure of this limit",
             .where = limit->where,
             .value = limit->figure + ": the measured phase reaches a side of the domain",
             .allowed = "figures that the run measures"});
    }
}

} // namespace

Cases read_suite_text(const std::string& text, const std::filesystem::path& path,
                      bool needs_limits) {
    const toml::table table = scenes::parse_toml(text, path);
    const TableReader top(table, "", path);
    std::vector<std::string> keys{"case", "also"};
    std::ranges::copy(scenes::keys_of_verify(), std::back_inserter(keys));
    top.allow(keys);
    Common common{.limits = table_of(top, "limits"),
                  .defaults = table_of(top, "defaults"),
                  .required = {},
                  .needs_limits = needs_limits};
    if (common.defaults) {
        check_known(*common.defaults);
    }
    if (top.has("every_case_has")) {
        common.required = top.texts("every_case_has");
        for (const std::string& name : common.required) {
            at_key(top, "every_case_has", [&] { (void)find_check(name); });
        }
    }
    Cases cases;
    std::size_t number = 0;
    for (const TableReader& reader : top.tables("case")) {
        read_case(reader, number++, common, cases);
    }
    if (cases.empty()) {
        throw InputError({.what = "an empty suite",
                          .where = path.string(),
                          .value = "no [[case]]",
                          .allowed = "at least one [[case]]"});
    }
    check_names(cases);
    return cases;
}

Cases read_suite(const std::filesystem::path& path) {
    return read_suite_text(read_text(path), path);
}

Case case_of_scene(const std::string& scene) {
    if (const auto* const found = scenes::space::find_scene(scene)) {
        return case_in_space({.scene = *found}, "");
    }
    if (scenes::is_scene_file(scene)) {
        const std::string text = read_text(scene);
        if (scenes::space::is_in_space(text, scene)) {
            return readable(scene, [&] {
                return case_in_space(scenes::space::read_scene_text(text, scene), scene);
            });
        }
    }
    Case c{.name = {}, .file = {}};
    if (scenes::is_scene_file(scene)) {
        c.file = readable(scene, [&] { return scenes::read_scene_file(scene); });
        c.path = scene;
    } else {
        c.file.scene = scenes::find_scene(scene);
    }
    c.name = c.file.scene.name;
    c.parameters = c.file.scene.defaults;
    c.strategies = scenes::parallel_strategies();
    return c;
}

Case case_of_file(const std::string& path) {
    Case c = case_of_scene(path);
    check_circularity(c);
    for (const scenes::FigureLimit& limit : c.file.limits) {
        const auto add = [&](const std::string& suffix, double value, bool at_least) {
            c.held.push_back({(c.space ? check_in_space : check_of_figure)(
                                  limit.figure, "limits." + limit.figure + suffix, at_least),
                              {.value = value, .where = limit.where}});
        };
        const bool has_both = std::isfinite(limit.min) && std::isfinite(limit.max);
        if (std::isfinite(limit.min)) {
            add(".min", limit.min, true);
        }
        if (std::isfinite(limit.max)) {
            add(has_both ? ".max" : "", limit.max, false);
        }
    }
    if (c.held.empty()) {
        throw InputError({.what = "the scene has no limits",
                          .where = path,
                          .value = "no [limits]",
                          .allowed = "[limits] in the file, or --limits SUITE"});
    }
    return c;
}

bool is_suite(const std::string& path) {
    const toml::table table = scenes::parse_toml(read_text(path), path);
    return table.contains("case");
}

void check_names(const Cases& cases) {
    std::set<std::pair<std::string, std::string>> names;
    for (const auto& c : cases) {
        for (const Held& held : c->held) {
            if (!names.insert({held.check->name, c->name}).second) {
                throw InputError({.what = "two limits have the same name",
                                  .where = held.limit.where,
                                  .value = held.check->name + ", " + c->name,
                                  .allowed = "a `name` of its own for each case"});
            }
        }
    }
}

} // namespace dsc::gate
