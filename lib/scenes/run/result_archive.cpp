// SPDX-License-Identifier: MIT
#include "scenes/run/result_archive.h"

#include "dsc/base/error.h"

namespace dsc {

void archive(Archive& archive, Event& event) {
    archive.choice(event.kind, event_names.size());
    archive(event.time, event.x, event.y, event.lost, event.taken, event.area);
}

void archive(Archive& archive, AreaAccount& account) { archive(account.given_back, account.owed); }

} // namespace dsc

namespace dsc::scenes {

void archive(Archive& archive, Figure& figure) { archive(figure.name, figure.value); }

void archive(Archive& archive, SeriesRow& row) {
    archive(row.step, row.time, row.triangles, row.interface_vertices, row.phases,
            row.interface_length, row.figures, row.operations, row.events, row.unreached,
            row.wall_s);
}

void archive(Archive& archive, RunResult& result) {
    archive(result.steps, result.gave_up, result.triangles_first, result.interface_vertices_first,
            result.area_first, result.area_exact_first, result.half, result.min_quality_ever,
            result.quality_sampled_every, result.inverted, result.unreached, result.held,
            result.sub_steps, result.operations, result.events, result.area, result.series,
            result.cpu_s, result.wall_s, result.busy_s);
}

std::string identity_of(const RunResult& result, const Submeshing& submeshing) {
    std::string text = result.scene + text_of(result.parameters);
    text += " strategy=" + to_string(result.strategy);
    if (is_parallel(result.strategy)) {
        text += " submeshes=" + std::to_string(result.submeshes) +
                " angle=" + (submeshing.follow_shape ? "shape" : to_text(submeshing.degrees));
    }
    return text;
}

} // namespace dsc::scenes
