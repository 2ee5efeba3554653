// SPDX-License-Identifier: MIT
#include "scenes/command_line/space_program.h"

#include "scenes/file/text_file.h"
#include "scenes/space/run.h"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace dsc::scenes {

int run_in_space(const std::string& program, const space::SceneFile& file,
                 const Arguments& arguments, const RunOrigin& origin,
                 const std::optional<Checkpoint>& checkpoint) {
    const space::Scene& scene = file.scene;
    for (const auto& [is_given, option] : {std::pair(arguments.events.has_value(), "--events"),
                                           {arguments.series.has_value(), "--series"},
                                           {arguments.edits.has_value(), "--edits"},
                                           {arguments.pictures.has_value(), "--pictures"}}) {
        if (is_given) {
            throw InputError({.what = "not supported for scenes in three dimensions",
                              .where = "run " + scene.name,
                              .value = option,
                              .allowed =
                                  "--set, --threads, --submeshes, --json, --frames, --every, "
                                  "--at, --checkpoint, --resume and --stop-after"});
        }
    }
    check_files(arguments, origin, file.files);
    const Parameters parameters = with_settings(scene, origin.settings);
    space::RunOptions options;
    options.frames = arguments.run.frames;
    options.frames.every = arguments.every.value_or(0);
    options.checkpoint = checkpoint_plan(arguments, origin);
    options.resume = checkpoint ? &*checkpoint : nullptr;
    options.stop_after = arguments.run.stop_after;
    options.parallel = space::parallel_of(origin.strategy, origin.submeshing);
    options.interrupted = &interrupted;
    options.progress = isatty(STDERR_FILENO) != 0;
    heed_signals();
    const space::RunResult result = space::run_scene(scene, parameters, options);
    space::print_summary(result);
    if (arguments.json) {
        write_file(*arguments.json, space::to_json(result));
    }
    if (result.interrupted) {
        tell_interruption(program, arguments, result.steps);
    }
    return result.holds() && !result.interrupted ? 0 : 1;
}

} // namespace dsc::scenes
