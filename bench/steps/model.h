// SPDX-License-Identifier: MIT
// A model of a step with more threads than the machine has; wherever its results appear they are
// labelled as modelled. The tasks of a measured run are scheduled on n workers by the rules of
// dsc/parallel/in_place/schedule.h; serial parts and the measured cost of a section's start and end
// are added. Disturbances of this machine stay in the times of the tasks, as they do in the times
// of the steps with which the model is compared. With the shortest of several times of each task,
// the model was 8 to 11 % faster than the same steps on one thread.
//
// For more than one worker the times are those of runs in which all cores of this machine were at
// work, so that what they share, caches and memory, has slowed them down as it does here: each of n
// workers is as fast as each of these cores. A machine whose memory serves n cores worse than this
// one serves its own is slower; `measure_bandwidth` says how well it does.
#pragma once

#include "dsc/parallel/parallel.h"
#include "dsc/parallel/submesh_view.h"

#include <cstdint>
#include <vector>

namespace dsc::bench {

/// A parallel section: its tasks, which of them wait for which, and how long each takes.
struct Section {
    TaskGraph tasks;
    std::vector<double> seconds; ///< by task
    double wall = 0;             ///< seconds that the section took as it was measured
};

/// The time from the first task's begin to the last one's end on so many workers, in seconds.
/// O(tasks^3 * workers) at worst.
[[nodiscard]] double makespan(const Section& section, std::uint32_t workers, Assignment assignment);

/// One sub-step, with its measured times.
struct ModelSubStep {
    double serial = 0; ///< seconds
    Section targets;
    Section move;
};

/// Where the time of a run went, in seconds: sums over all sub-steps and submeshes.
struct ModelAccount {
    double set_up = 0;    ///< serial: cuts, lists and ids
    double hand_over = 0; ///< serial: vertices that left their submesh
    double clean_up = 0;  ///< serial: what all colours left
    double wall = 0;      ///< of the parallel sections
    double tasks = 0;     ///< all of them
    double targets = 0;   ///< of these: remeshing, velocities and targets
    double later = 0;     ///< of these: the colours after the first
    // Passes in the submeshes of the first colour.
    double remeshing = 0;
    double movement = 0;
    double mesh_update = 0;
};

/// All timed steps of a run, with their account of times.
struct ModelRun {
    std::vector<std::vector<ModelSubStep>> steps;
    std::vector<double> serial_outside; ///< by step, seconds
    ModelAccount account;
};

/// Keeps the account of one step. `wall`: the whole step, in seconds.
void add_step(ModelRun& run, const SubmeshView& submeshes, double wall);

struct ModelTimes {
    double seconds = 0;      ///< of all steps
    double serial_share = 0; ///< serial parts over all work
    double busy_share = 0;   ///< of the workers' time in parallel sections, with tasks
    double serial = 0;       ///< seconds that one worker takes for the serial parts...
    double tasks = 0;        ///< ...and for all tasks
    double starts = 0;       ///< seconds of starting and joining threads
};

/// `start_s`: what starting and ending a section costs two threads; a tree of more costs that for
/// each level.
[[nodiscard]] ModelTimes model(const ModelRun& run, std::uint32_t workers, double start_s);

/// The median; of an even number of values the upper one in the middle. There must be a value.
[[nodiscard]] double median(std::vector<double> values);

/// What a section took longer than its tasks on so many workers, the median: waking the workers,
/// and fetching what another core has written. In seconds, for two threads as in `model`. `run`:
/// measured with so many threads.
[[nodiscard]] double measured_start(const ModelRun& run, std::uint32_t workers);

/// Bytes per second that so many threads read and write together, in arrays that are larger than
/// caches: the best of several passes of a = b + 3 c.
[[nodiscard]] double measure_bandwidth(std::uint32_t threads);

/// The cost of a parallel section without any work on so many threads: the median of many, in
/// seconds.
[[nodiscard]] double measure_fork_join(std::uint32_t threads);

} // namespace dsc::bench
