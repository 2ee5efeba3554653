// SPDX-License-Identifier: MIT
#include "scenes/command_line/arguments.h"

#include "scenes/file/scene_file.h"
#include "scenes/file/text_file.h"

#include <csignal>
#include <filesystem>
#include <iostream>

namespace dsc::scenes {

void check_files(const Arguments& arguments, const RunOrigin& origin,
                 const std::vector<std::string>& files) {
    std::vector<NamedFile> outputs;
    for (const auto& [path, option] : {std::pair(&arguments.json, "--json"),
                                       {&arguments.events, "--events"},
                                       {&arguments.series, "--series"},
                                       {&arguments.edits, "--edits"},
                                       {&arguments.checkpoint, "--checkpoint"}}) {
        if (*path) {
            outputs.push_back({option, **path});
        }
    }
    std::vector<NamedFile> others;
    if (is_scene_file(origin.scene)) {
        others.push_back({"the scene", origin.scene});
    }
    for (const std::string& file : files) {
        others.push_back({"a file of the scene", file});
    }
    if (const std::filesystem::path folder(arguments.run.frames.folder); !folder.empty()) {
        others.push_back({"--frames", (folder / "").parent_path().string()});
    }
    std::error_code error; // ignored: the checkpoint may not exist
    if (arguments.resume &&
        !(arguments.checkpoint &&
          std::filesystem::equivalent(*arguments.resume, *arguments.checkpoint, error))) {
        others.push_back({"--resume", *arguments.resume});
    }
    check_outputs(outputs, others);
}

CheckpointPlan checkpoint_plan(const Arguments& arguments, const RunOrigin& origin) {
    CheckpointPlan plan{.path = arguments.checkpoint.value_or(""),
                        .every = arguments.every.value_or(0),
                        .origin = origin};
    if (is_scene_file(origin.scene)) { // absolute, so that it is found from any folder
        plan.origin.scene = std::filesystem::absolute(origin.scene).string();
    }
    return plan;
}

void tell_interruption(const std::string& program, const Arguments& arguments, int steps) {
    std::cerr << program << ": interrupted after step " << steps;
    if (arguments.checkpoint) {
        std::cerr << "; continue with: " << program << " run --resume " << *arguments.checkpoint;
    }
    std::cerr << '\n';
}

std::atomic<bool> interrupted{false};

namespace {

// A second signal ends the program at once, except SIGHUP: a terminal that closes often sends it
// twice.
void on_interrupt(int number) {
    interrupted.store(true);
    if (number != SIGHUP) {
        std::signal(number, SIG_DFL);
    }
}

} // namespace

// Signals that are already ignored, as under nohup, stay ignored.
void heed_signals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        if (std::signal(number, on_interrupt) == SIG_IGN) {
            std::signal(number, SIG_IGN);
        }
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace dsc::scenes
