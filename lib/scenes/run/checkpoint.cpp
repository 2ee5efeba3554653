// SPDX-License-Identifier: MIT
#include "scenes/run/checkpoint.h"

#include "replay/sealed_file.h"

namespace dsc::scenes {

namespace {

/// To be raised with every change of what a run writes.
const SealedKind checkpoint_kind{.name = "dsc-run", .version = 8};

} // namespace

void archive(Archive& archive, RunOrigin& origin) {
    archive(origin.scene, origin.text, origin.settings);
    archive.choice(origin.strategy, static_cast<std::uint32_t>(strategies().size()));
    archive(origin.submeshing.threads, origin.submeshing.submeshes, origin.submeshing.degrees,
            origin.submeshing.follow_shape, origin.submeshing.always_all_threads, origin.commit);
}

void write_checkpoint(const CheckpointPlan& plan, const std::string& state) {
    Archive archive;
    RunOrigin origin = plan.origin;
    std::string copy = state;
    archive(origin, copy);
    write_sealed(plan.path, checkpoint_kind, archive.bytes());
}

Checkpoint read_checkpoint(const std::string& path) {
    Archive archive(read_sealed(path, checkpoint_kind), path);
    Checkpoint checkpoint{.path = path, .origin = {}, .state = {}};
    archive(checkpoint.origin, checkpoint.state);
    archive.expect_end();
    return checkpoint;
}

} // namespace dsc::scenes
