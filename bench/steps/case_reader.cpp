// SPDX-License-Identifier: MIT
#include "case_reader.h"

#include "scenes/catalogue/catalogue.h"
#include "scenes/file/scene_file.h"

namespace dsc::bench {

using scenes::TableReader;

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

std::vector<double> numbers(const CaseReader& reader, const std::string& key,
                            scenes::Bounds bounds) {
    return one_or_more(
        reader, key, [&](const TableReader& table) { return table.number(key, bounds); },
        [&](const TableReader& table) { return table.numbers(key, bounds); });
}

scenes::Scene read_scene(const CaseReader& reader, const std::string& name) {
    const TableReader& table = reader.of("scene");
    return at_key(table, "scene", [&] {
        if (!scenes::is_scene_file(name)) {
            return scenes::find_scene(name);
        }
        const auto path = table.file().parent_path() / name;
        try {
            return scenes::read_scene_file(path).scene;
        } catch (const FileError& error) {
            throw InputError({.what = error.what(),
                              .where = "scene",
                              .value = "'" + name + "'",
                              .allowed = "a scene file whose path begins at the suite"});
        } catch (const InputError& error) { // the place in the scene file says more
            throw InputError({.what = error.where() + ": " + error.problem(),
                              .where = "scene",
                              .value = error.value(),
                              .allowed = error.allowed()});
        }
    });
}

void read_settings(const CaseReader& reader, const std::string& key, const scenes::Scene& scene,
                   scenes::Parameters& parameters) {
    if (!reader.has(key)) {
        return;
    }
    const TableReader table = reader.of(key).table(key);
    for (const std::string& name : table.keys()) {
        if (name == "h") {
            table.refuse(name, "a size among settings", "h = [...] in the [[case]] itself");
        }
        at_key(table, name,
               [&] { scenes::set_parameter(parameters, scene.keys, name, table.setting(name)); });
    }
}

} // namespace dsc::bench
