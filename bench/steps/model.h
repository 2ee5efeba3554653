// SPDX-License-Identifier: MIT
// A model of a step with more threads than the machine has; its results are always labelled as
// modelled. The tasks of a measured run are scheduled on n workers by the rules of
// dsc/parallel/in_place/schedule.h; serial parts and the measured cost of a section's start and end
// are added. The times of the tasks include disturbances of the machine, as do the times of the
// steps with which the model is compared. With the shortest of several times of each task, the
// model was 8 to 11 % faster than the same steps on one thread.
//
// For more than one worker the times are those of runs with all cores of this machine busy, so they
// include the slowdown by shared caches and memory: each of n workers is as fast as each of these
// cores. A machine with less memory bandwidth per core is slower; see `measure_bandwidth`.
#pragma once

#include "dsc/parallel/parallel.h"
#include "dsc/parallel/submesh_view.h"

#include <cstdint>
#include <vector>

namespace dsc::bench {

/// A parallel section: its tasks, their dependencies, and their times.
struct Section {
    TaskGraph tasks;
    std::vector<double> seconds; ///< by task
    double wall = 0;             ///< measured seconds of the section
};

/// The seconds from the start of the first task to the end of the last one on this number of
/// workers. O(tasks^3 * workers) at worst.
[[nodiscard]] double makespan(const Section& section, std::uint32_t workers, Assignment assignment);

/// The depth of a tree of threads that wake each other.
[[nodiscard]] double levels(std::uint32_t workers);

/// One sub-step, with its measured times.
struct ModelSubStep {
    double serial = 0; ///< seconds
    Section targets;
    Section move;
};

/// The parts of the time of a run, in seconds: sums over all sub-steps and submeshes.
struct ModelAccount {
    double set_up = 0;    ///< serial: cuts, lists and ids at the start
    double hand_over = 0; ///< serial: vertices that left their submesh
    double clean_up = 0;  ///< serial: work deferred by all colours
    double wall = 0;      ///< of the parallel sections
    double tasks = 0;     ///< all of them
    double targets = 0;   ///< of these: remeshing, velocities and targets
    double later = 0;     ///< of these: the colours after the first
    // The passes in submeshes of the first colour.
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

/// Adds the times of one step. `wall`: seconds of the whole step.
void add_step(ModelRun& run, const SubmeshView& submeshes, double wall);

struct ModelTimes {
    double seconds = 0;      ///< of all steps
    double serial_share = 0; ///< serial parts over all work
    double busy_share = 0;   ///< fraction of the workers' time in parallel sections spent on tasks
    double serial = 0;       ///< seconds that one worker takes for the serial parts...
    double tasks = 0;        ///< ...and for all tasks
    double starts = 0;       ///< seconds of starting and joining threads
};

/// `start_s`: the cost of starting and ending a section with two threads; a tree of more threads
/// costs this for each level.
[[nodiscard]] ModelTimes model(const ModelRun& run, std::uint32_t workers, double start_s);

/// The median; the upper median for an even number of values. There must be at least one value.
[[nodiscard]] double median(std::vector<double> values);

/// The median of the time by which a section took longer than its tasks on `workers` workers:
/// waking the workers, and fetching data written by other cores. In seconds, for two threads as in
/// `model`. `run` must be measured with this number of threads.
[[nodiscard]] double measured_start(const ModelRun& run, std::uint32_t workers);

/// The total bytes per second read and written by this number of threads in arrays larger than the
/// caches: the best of several passes of a = b + 3 c.
[[nodiscard]] double measure_bandwidth(std::uint32_t threads);

/// The cost of an empty parallel section on this number of threads: the median of many, in seconds.
[[nodiscard]] double measure_fork_join(std::uint32_t threads);

} // namespace dsc::bench
