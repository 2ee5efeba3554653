// SPDX-License-Identifier: MIT
#include "scenes/command_line/scene_source.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/file/text_file.h"
#include "scenes/name_list.h"

namespace dsc::scenes {

namespace {

// A file that cannot be read is bad usage here: its name may be a scene's with an error in it.
template <class Read>
auto read_or_refuse(const std::string& name, const std::vector<Scene>& scenes, Read read) {
    try {
        return read();
    } catch (const FileError& error) {
        throw InputError({.what = error.what(),
                          .where = "run",
                          .value = "'" + name + "'",
                          .allowed = "a scene file that can be read, or one of " +
                                     name_list(scenes, &Scene::name)});
    }
}

} // namespace

std::string text_of_scene(const std::string& name, const std::vector<Scene>& scenes) {
    if (!is_scene_file(name)) {
        (void)find_scene(name, scenes);
        return {};
    }
    return read_or_refuse(name, scenes, [&] { return read_text_file(name); });
}

SceneFile scene_of(const RunOrigin& origin, const std::vector<Scene>& scenes) {
    if (!is_scene_file(origin.scene)) {
        return {.scene = find_scene(origin.scene, scenes)};
    }
    return read_or_refuse(origin.scene, scenes,
                          [&] { return read_scene_text(origin.text, origin.scene, scenes); });
}

} // namespace dsc::scenes
