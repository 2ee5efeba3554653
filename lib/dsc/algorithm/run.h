// SPDX-License-Identifier: MIT
// Several steps on end, with a word to the application after each of them: for progress lines, for
// frames, and to stop early. Within a step `Simulation::interrupt_by` stops it.
#pragma once

#include "dsc/algorithm/simulation.h"

#include <functional>

namespace dsc {

/// Steps of equal length.
struct RunPlan {
    double begin = 0; ///< time of the first step
    double dt = 0;    ///< of each step
    int steps = 0;    ///< how many
};

/// What is known after a step.
struct Progress {
    int step = 0;             ///< 1 for the first
    int steps = 0;            ///< of the plan
    double time = 0;          ///< at its end
    const StepReport& report; ///< of the step; valid during the call
};

/// Called after each step, by the thread that runs them; false: no more steps.
using ProgressFunction = std::function<bool(const Progress& progress)>;

/// Sums over the steps of a run.
struct RunReport {
    int steps = 0;                 ///< done
    OperationCounts operations;    ///< of all steps
    std::uint64_t sub_steps = 0;   ///< of all steps
    std::uint64_t unreached = 0;   ///< of all steps: see `StepReport`
    std::uint64_t held = 0;        ///< of all steps: see `StepReport`
    GiveUp gave_up = GiveUp::none; ///< of the last step
    double reached = 0;            ///< time at the end
};

/// Runs the steps, until one gives up, the function returns false, or all are done. `flow` is
/// anything that `Simulation::step` takes. The time of a step is multiplied, not summed, so that
/// the last one ends where the plan ends. What the flow or the function throws comes out, and
/// leaves a valid complex.
template <class Real, class AnyFlow>
RunReport run(Simulation<Real>& simulation, const AnyFlow& flow, const RunPlan& plan,
              const ProgressFunction& tell = {}) {
    RunReport sum;
    sum.reached = plan.begin;
    for (int step = 1; step <= plan.steps && sum.gave_up == GiveUp::none; ++step) {
        const double time = plan.begin + (step - 1) * plan.dt;
        const StepReport report =
            simulation.step(flow, static_cast<Real>(time), static_cast<Real>(plan.dt));
        ++sum.steps;
        sum.operations += report.operations;
        sum.sub_steps += report.sub_steps;
        sum.unreached += report.unreached;
        sum.held += report.held;
        sum.gave_up = report.gave_up;
        sum.reached = report.gave_up == GiveUp::none ? plan.begin + step * plan.dt : report.reached;
        if (tell && !tell({step, plan.steps, sum.reached, report})) {
            break;
        }
    }
    return sum;
}

} // namespace dsc
