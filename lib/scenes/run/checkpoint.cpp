// SPDX-License-Identifier: MIT
#include "scenes/run/checkpoint.h"

#include "scenes/run/run.h"
#include "scenes/run/standard_archive.h"

namespace dsc::scenes {

static void archive(Archive& archive, Figure& figure) { archive(figure.name, figure.value); }

void archive(Archive& archive, SeriesRow& row) {
    archive(row.step, row.time, row.triangles, row.interface_vertices, row.phases,
            row.interface_length, row.figures, row.operations, row.events, row.unreached,
            row.wall_s);
}

void archive(Archive& archive, RunResult& result) {
    archive(result.steps, result.gave_up, result.triangles_first, result.area_first,
            result.area_exact_first, result.half, result.min_quality_ever,
            result.quality_sampled_every, result.inverted, result.unreached, result.held,
            result.sub_steps, result.operations, result.events, result.area, result.series,
            result.cpu_s, result.wall_s);
}

void archive(Archive& archive, RunOrigin& origin) {
    archive(origin.scene, origin.text, origin.settings);
    archive.choice(origin.strategy, static_cast<std::uint32_t>(strategies().size()));
    archive(origin.submeshing.threads, origin.submeshing.submeshes,
            origin.submeshing.always_all_threads, origin.commit);
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
