// SPDX-License-Identifier: MIT
// The arguments of `dsc_scene run`, and the signals that end a run early.
#pragma once

#include "scenes/keys.h"
#include "scenes/run/run.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dsc::scenes {

struct Arguments {
    std::optional<std::string> scene;
    std::vector<std::string> settings;
    std::optional<std::string> strategy;
    RunOptions run;
    std::optional<std::uint32_t> threads;
    std::optional<std::string> events;
    std::optional<std::string> json;
    std::optional<std::string> series;
    std::optional<std::string> edits;
    std::optional<std::string> pictures;
    std::optional<std::string> checkpoint;
    std::optional<std::string> resume;
    std::optional<int> every;
};

template <class AnyScene>
[[nodiscard]] Parameters with_settings(const AnyScene& scene,
                                       const std::vector<std::string>& settings) {
    Parameters parameters = scene.defaults;
    for (const std::string& setting : settings) {
        apply_setting(parameters, scene.keys, setting);
    }
    return parameters;
}

/// Throws InputError if the run would write a file twice, or one that it reads; only the checkpoint
/// may be the one that is resumed. `files` are those that the scene names.
void check_files(const Arguments& arguments, const RunOrigin& origin,
                 const std::vector<std::string>& files);

/// The times of checkpoints and the description of the run in them.
[[nodiscard]] CheckpointPlan checkpoint_plan(const Arguments& arguments, const RunOrigin& origin);

/// Prints to stderr after which step a run was interrupted, and how to continue it.
void tell_interruption(const std::string& program, const Arguments& arguments, int steps);

/// Set by SIGINT, SIGTERM and SIGHUP after `heed_signals`.
extern std::atomic<bool> interrupted;

/// Lets these signals set the flag, and turns a file size limit into a write error, like a full
/// disk.
void heed_signals();

} // namespace dsc::scenes
