// SPDX-License-Identifier: MIT
#include "steps/space/rows.h"

#include "steps/context.h"

#include "dsc/base/error.h"
#include "scenes/file/text_file.h"
#include "scenes/space/run.h"

#include <algorithm>
#include <bit>
#include <filesystem>

namespace dsc::bench {

namespace {

using scenes::at_key;
using scenes::CaseReader;
using scenes::Strategy;
namespace space = scenes::space;

std::uint32_t submeshes_of(const CaseReader& reader, std::uint32_t threads) {
    if (!reader.has("submeshes")) {
        return 0;
    }
    const std::uint32_t limit = dsc3::submesh_limit;
    if (reader.is_text("submeshes", "threads")) {
        return std::min(limit, std::bit_ceil(threads));
    }
    if (reader.is_text("submeshes", "cores")) {
        return std::min(limit, std::bit_ceil(core_count()));
    }
    if (reader.is_text("submeshes")) {
        reader.refuse("submeshes", "bad value", "a power of two, \"threads\" or \"cores\"");
    }
    const auto submeshes = static_cast<std::uint32_t>(
        reader.of("submeshes").integer("submeshes", 1, static_cast<int>(limit)));
    if (!std::has_single_bit(submeshes)) {
        reader.refuse("submeshes", "bad value", "a power of two, \"threads\" or \"cores\"");
    }
    return submeshes;
}

void check_keys(const CaseReader& reader, const SuiteCase& c) {
    if (c.measure != Measure::run && c.measure != Measure::model) {
        reader.refuse("measure", "not available in three dimensions", "run, model");
    }
    for (const char* key : {"triangles", "dt_over_h", "area_error", "between_us", "at"}) {
        if (reader.has(key)) {
            reader.refuse(key, "not available in three dimensions",
                          "name, h, set, strategies, threads, submeshes, vertex_error, "
                          "stop_after");
        }
    }
}

std::string name_of(const SpaceRow& row, const std::string& of, bool names_submeshes) {
    std::string name =
        of + "_run/strategy:" + scenes::to_string(row.strategy) + "/h:" + to_text(row.parameters.h);
    if (row.strategy != Strategy::sequential) {
        name += names_submeshes ? "/submeshes:" + std::to_string(row.submeshes) : "";
        name += "/threads:" + std::to_string(row.threads);
    }
    name += row.stop_after > 0 ? "/stop_after:" + std::to_string(row.stop_after) : "";
    return row.is_modelled ? name + "/modelled:1" : name;
}

} // namespace

std::optional<space::SceneFile> find_in_space(const CaseReader& reader, const std::string& scene) {
    if (const space::Scene* const found = space::find_scene(scene)) {
        return space::SceneFile{.scene = *found};
    }
    if (!scenes::is_scene_file(scene)) {
        return std::nullopt;
    }
    const std::filesystem::path path = reader.of("scene").file().parent_path() / scene;
    if (!std::filesystem::exists(path)) {
        return std::nullopt; // refused as a scene in the plane
    }
    const std::string text = scenes::read_text_file(path);
    return at_key(reader.of("scene"), "scene", [&]() -> std::optional<space::SceneFile> {
        return space::is_in_space(text, path) ? std::optional(space::read_scene_text(text, path))
                                              : std::nullopt;
    });
}

void add_rows_in_space(const SuiteCase& c, const space::SceneFile& file, const std::string& name,
                       Suite& suite) {
    const CaseReader& reader = *c.reader;
    check_keys(reader, c);
    const auto scene = std::make_shared<const space::Scene>(file.scene);
    SpaceRow row{.name = {}, .scene = scene, .parameters = scene->defaults};
    scenes::read_settings(reader, "set", scene->keys, row.parameters);
    if (reader.has("vertex_error")) {
        row.vertex_error = reader.of("vertex_error").number("vertex_error", {0, 1});
    }
    if (reader.has("stop_after")) {
        row.stop_after = reader.of("stop_after").integer("stop_after", 1, 1'000'000);
    }
    row.is_modelled = c.measure == Measure::model;
    for (const scenes::CaseSize& size : c.sizes) {
        row.parameters.h = size.h > 0 ? size.h : row.parameters.h;
        at_key(reader.of("scene"), "scene", [&] { (void)scene->prepare(row.parameters); });
        for (const Strategy strategy : c.strategies) {
            row.strategy = strategy;
            at_key(reader.of("strategies"), "strategies",
                   [&] { (void)space::parallel_of(strategy, {}); });
            for (const std::uint32_t threads :
                 strategy == Strategy::sequential ? std::vector<std::uint32_t>{1} : c.threads) {
                row.threads = threads;
                row.submeshes =
                    strategy == Strategy::sequential ? 0 : submeshes_of(reader, threads);
                row.name = name_of(row, name.empty() ? scene->name : name, reader.has("submeshes"));
                suite.space_rows.push_back(row);
            }
        }
    }
}

} // namespace dsc::bench
