// SPDX-License-Identifier: MIT
// Checkpoints: the state of a run in a file, from which it continues bitwise identically. The file
// also has the scene and its settings, which need not be given again.
#pragma once

#include "dsc/base/archive.h"
#include "replay/sealed_file.h"
#include "scenes/run/strategy.h"

#include <string>
#include <vector>

namespace dsc::scenes {

/// Raise the version with every change of the format.
inline const SealedKind checkpoint_kind{.name = "dsc-run", .version = 13};

/// The command line of a run: enough to start it again.
struct RunOrigin {
    std::string scene;                 ///< its name in the list, or the path of its file
    std::string text;                  ///< text of that file; empty for a scene of the list
    std::vector<std::string> settings; ///< key=value
    Strategy strategy = Strategy::sequential;
    Submeshing submeshing;
    std::string commit; ///< commit of the program that wrote the file; others may round differently
};

void archive(Archive& archive, RunOrigin& origin);

/// When checkpoints are written.
struct CheckpointPlan {
    std::string path; ///< empty: never
    int every = 0;    ///< steps between checkpoints; 0: only at the end or an interruption
    RunOrigin origin;
};

struct Checkpoint {
    std::string path; ///< where it was read
    RunOrigin origin;
    std::string state; ///< of the run
};

/// Throws FileError; a previous file then stays intact.
void write_checkpoint(const CheckpointPlan& plan, const std::string& state);
/// Throws FileError if the file cannot be read, is not a checkpoint, is damaged or has another
/// version.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

} // namespace dsc::scenes
