// SPDX-License-Identifier: MIT
#include "scenes/file/case_reader.h"

#include <cmath>

namespace dsc::scenes {

namespace {

// A list, or a single value that stands for a list of one.
template <class One, class Many>
auto one_or_more(const CaseReader& reader, const std::string& key, One one, Many many) {
    const TableReader& table = reader.of(key);
    auto list = table.is_list(key) ? many(table) : std::vector{one(table)};
    if (list.empty()) {
        reader.refuse(key, "an empty list", "at least one");
    }
    return list;
}

} // namespace

std::vector<std::string> keys_of_verify() { return {"limits", "defaults", "every_case_has"}; }

std::vector<std::string> case_keys_of_verify() { return {"limits", "starts"}; }

std::vector<std::string> case_keys_of_bench() {
    return {"measure", "submeshes", "area_error", "vertex_error", "between_us",
            "at",      "option",    "same_mesh",  "seeds",        "stop_after"};
}

std::vector<std::string> texts(const CaseReader& reader, const std::string& key) {
    return one_or_more(
        reader, key, [&](const TableReader& table) { return table.text(key); },
        [&](const TableReader& table) { return table.texts(key); });
}

std::vector<int> integers(const CaseReader& reader, const std::string& key, int low, int high) {
    return one_or_more(
        reader, key, [&](const TableReader& table) { return table.integer(key, low, high); },
        [&](const TableReader& table) { return table.integers(key, low, high); });
}

std::vector<double> numbers(const CaseReader& reader, const std::string& key, Bounds bounds) {
    return one_or_more(
        reader, key, [&](const TableReader& table) { return table.number(key, bounds); },
        [&](const TableReader& table) { return table.numbers(key, bounds); });
}

std::vector<CaseSize> read_sizes(const CaseReader& reader) {
    std::vector<CaseSize> sizes;
    if (reader.has("triangles") && reader.has("h")) {
        reader.refuse("h", "both h and triangles are given", "one of h and triangles");
    }
    if (reader.has("triangles")) {
        for (const int triangles : integers(reader, "triangles", 100, 20'000'000)) {
            // The edge length of this number of equilateral triangles in the unit square.
            sizes.push_back({"triangles:" + std::to_string(triangles),
                             std::sqrt(4 / (std::sqrt(3.0) * triangles))});
        }
    } else if (reader.has("h")) {
        for (const double h : numbers(reader, "h", {1e-40, 1e40})) {
            sizes.push_back({"", h});
        }
    } else {
        sizes.emplace_back();
    }
    return sizes;
}

SceneFile read_scene(const CaseReader& reader, const std::string& name) {
    const TableReader& table = reader.of("scene");
    return at_key(table, "scene", [&] {
        if (!is_scene_file(name)) {
            return SceneFile{.scene = find_scene(name)};
        }
        const auto path = table.file().parent_path() / name;
        try {
            return read_scene_file(path);
        } catch (const FileError& error) {
            throw InputError({.what = error.what(),
                              .where = "scene",
                              .value = "'" + name + "'",
                              .allowed = "a scene file, relative to the suite"});
        } catch (const InputError& error) { // its place in the scene file is more precise
            throw InputError({.what = error.where() + ": " + error.problem(),
                              .where = "scene",
                              .value = error.value(),
                              .allowed = error.allowed()});
        }
    });
}

void read_settings(const CaseReader& reader, const std::string& key,
                   const std::vector<std::string>& allowed, Parameters& parameters) {
    if (!reader.has(key)) {
        return;
    }
    const TableReader table = reader.of(key).table(key);
    for (const std::string& name : table.keys()) {
        if (name == "h") {
            table.refuse(name, "the edge length cannot be set here",
                         "h = [...] in the [[case]] itself");
        }
        at_key(table, name, [&] { set_parameter(parameters, allowed, name, table.setting(name)); });
    }
}

} // namespace dsc::scenes
