// SPDX-License-Identifier: MIT
#include "scenes/command_line/space_program.h"

#include "scenes/command_line/command_line.h"
#include "scenes/file/text_file.h"
#include "scenes/space/run.h"

#include <filesystem>

namespace dsc::scenes {

int run_in_space(const space::Scene& scene, const Arguments& arguments) {
    if (arguments.strategy || arguments.threads || arguments.events || arguments.series ||
        arguments.edits || arguments.pictures || arguments.checkpoint || arguments.run.stop_after) {
        throw InputError({.what = "not for scenes in three dimensions",
                          .where = "run " + scene.name,
                          .value = "another option",
                          .allowed = "--set, --json, --frames, --every and --at"});
    }
    FramePlan frames = arguments.run.frames;
    frames.every = arguments.every.value_or(0);
    if (arguments.json) {
        std::vector<NamedFile> others;
        if (const std::filesystem::path folder(frames.folder); !folder.empty()) {
            others.push_back({"--frames", (folder / "").parent_path().string()});
        }
        check_outputs({{"--json", *arguments.json}}, others);
    }
    const Parameters parameters = with_settings(scene, arguments.settings);
    heed_signals();
    const space::RunResult result = space::run_scene(scene, parameters, frames, interrupted);
    space::print_summary(result);
    if (arguments.json) {
        write_file(*arguments.json, space::to_json(result));
    }
    return result.holds() && !result.interrupted ? 0 : 1;
}

} // namespace dsc::scenes
