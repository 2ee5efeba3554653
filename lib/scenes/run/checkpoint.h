// SPDX-License-Identifier: MIT
// Checkpoints: a run in a file, from which it goes on to the same bits. The file knows what was
// asked for, so that nothing has to be said again.
#pragma once

#include "dsc/base/archive.h"
#include "replay/sealed_file.h"
#include "scenes/run/strategy.h"

#include <string>
#include <vector>

namespace dsc::scenes {

/// To be raised with every change of what a run writes.
inline const SealedKind checkpoint_kind{.name = "dsc-run", .version = 10};

/// What a run was asked for on the command line: enough to begin it again.
struct RunOrigin {
    std::string scene;                 ///< its name in the list, or the path of its file
    std::string text;                  ///< of that file; empty for a scene of the list
    std::vector<std::string> settings; ///< key=value
    Strategy strategy = Strategy::sequential;
    Submeshing submeshing;
    std::string commit; ///< of the program that wrote the file: another one may round differently
};

void archive(Archive& archive, RunOrigin& origin);

/// When checkpoints are written.
struct CheckpointPlan {
    std::string path; ///< empty: never
    int every = 0;    ///< steps between two of them; 0: only when the run ends or is interrupted
    RunOrigin origin;
};

struct Checkpoint {
    std::string path; ///< where it was read
    RunOrigin origin;
    std::string state; ///< of the run
};

/// Throws FileError; the file that was there before stays whole then.
void write_checkpoint(const CheckpointPlan& plan, const std::string& state);
/// Throws FileError where it cannot be read, is no checkpoint, is damaged or of another version.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

} // namespace dsc::scenes
