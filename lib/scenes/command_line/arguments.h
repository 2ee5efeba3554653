// SPDX-License-Identifier: MIT
// What `dsc_scene run` was asked for, and the signals that end a run early.
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

/// No file that the run writes may be another that it writes or reads; but it may go on in its own
/// checkpoint. `files` are those that the scene names. Throws InputError.
void check_files(const Arguments& arguments, const RunOrigin& origin,
                 const std::vector<std::string>& files);

/// When checkpoints are written, and what they say of the run.
[[nodiscard]] CheckpointPlan checkpoint_plan(const Arguments& arguments, const RunOrigin& origin);

/// After which step a run was interrupted, and how it goes on, on stderr.
void tell_interruption(const std::string& program, const Arguments& arguments, int steps);

/// Set by SIGINT, SIGTERM and SIGHUP, once they are heeded.
extern std::atomic<bool> interrupted;

/// From now on a signal sets the flag; a file that may not grow is an error like a full disk.
void heed_signals();

} // namespace dsc::scenes
