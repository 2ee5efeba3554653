// SPDX-License-Identifier: MIT
// One measurement of a step, and the required result.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/passes/algorithm.h"
#include "reference/algorithm/dsc.h"
#include "scenes/run/run.h"
#include "steps/model.h"
#include "steps/suite.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>

namespace dsc::bench {

/// The cost of the timed steps, and their counts.
struct StepRun {
    int steps = 0;
    double wall_s = 0;
    double cpu_s = 0;               ///< of all threads
    double vertex_steps = 0;        ///< interface vertices, summed over the steps
    std::uint32_t threads_used = 1; ///< largest number used in a step
    double busy_s = 0;              ///< of all threads, without waiting; NaN if not measured
    double sections_s = 0;          ///< of these steps, in parallel sections
    OperationCounts operations;     ///< of the library's strategies
    std::uint64_t unreached = 0;    ///< warm-up included
    bool gave_up = false;
};

/// A simulation and its executor.
struct Prepared {
    std::unique_ptr<Simulation<double>> simulation;
    const Executor<double>& executor;

    [[nodiscard]] std::uint32_t threads_used() const; ///< by the last step
};
Prepared prepare(const Start& start, Complex<double>& complex, const Options<double>& choices,
                 scenes::Strategy strategy, const scenes::Submeshing& submeshing,
                 const Algorithm<double>* algorithm = nullptr);

/// Adds `sign` times the work of the executor's threads so far to `run`; its wall time is added
/// separately.
void add_work(StepRun& run, const Executor<double>& executor, double sign);

/// Continues from `start.step` with a copy of `start.complex`: warm-up, then the timed steps.
StepRun run_steps(const Start& start, Complex<double>& complex, const scenes::RunOptions& run);

/// The same steps, with the times of their tasks.
ModelRun profile_steps(const Start& start, Complex<double>& complex, const scenes::RunOptions& run);

/// Makes `steps` steps of the literal method after `first`, without a warm-up.
StepRun run_reference(const Start& start, reference::Complex& complex, int first, int steps);

/// The state of a mesh after `steps` steps of the scene.
struct Answer {
    std::uint64_t hash = 0;
    std::uint64_t triangles = 0;
    double min_quality = 0;
    double area_error_rel = 0; ///< relative to the exact shape; NaN if it is unknown
};

/// Measures the mesh. Throws InvariantError if the complex is not valid, a triangle is inverted, a
/// vertex did not arrive, or the error of the area exceeds `area_limit`.
Answer check_answer(const Start& start, const Complex<double>& complex, const StepRun& run,
                    int step, double area_limit);

/// The result of a row's strategy: computed on the first call, and cached for all rows that must be
/// bitwise identical.
const Answer& answer_of(const Row& row, const std::function<Answer()>& compute);

/// Sets the counters of all measured rows. `seconds`: of all steps of the run.
void count(benchmark::State& state, const Row& row, const StepRun& run, double seconds,
           const Answer& answer, double load);

} // namespace dsc::bench
