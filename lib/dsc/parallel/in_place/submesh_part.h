// SPDX-License-Identifier: MIT
// One submesh, as used by all files of the executor.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/interface_sight.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/passes/work.h"

namespace dsc {

/// One submesh: its work, its ids, and where the work that it deferred goes.
template <class Real>
struct SubmeshExecutor<Real>::Part {
    Part(Complex<Real>& complex, const Options<Real>& options) : work(complex, options) {}

    static constexpr std::size_t min_room = 48; // vertices

    Work<Real> work;
    IdPool* pool = nullptr;       // in the complex
    const Colour* next = nullptr; // the next colour; null if there is none
    std::size_t next_first = 0;   // number of its first part

    std::uint64_t examined = 0; // stars, since the last division
    TargetReport<Real> targets;
    MoveReport moved;
    double targets_s = 0; // seconds of the last sub-step, if times are measured
    double move_s = 0;

    // Reserves room for this many vertices of the interface, and for the moving vertices and stars
    // that come with them. Short lists of two submeshes next to each other on the heap would share
    // cache lines, and the threads would contend for them at each push. Only slightly more than
    // needed is reserved, because memory that is touched for the first time costs microseconds a
    // page.
    void make_room(std::size_t vertices) {
        const auto reserve = [vertices](auto&... lists) { (lists.reserve(vertices), ...); };
        reserve(work.interface, work.interface_next, work.moving_vertices, work.active,
                work.candidates, work.deferred.entries);
        reserve(work.trajectory.positions, work.trajectory.targets, work.trajectory.held,
                work.trajectory.scratch.first, work.trajectory.scratch.stage,
                work.trajectory.scratch.slope, work.trajectory.scratch.sum);
        reserve(pool->vertices, pool->triangles);
    }

    void drop_targets() {
        work.trajectory.positions.clear();
        work.trajectory.targets.clear();
        work.trajectory.held.clear();
        work.trajectory.scratch.first.clear();
    }
};

} // namespace dsc
