// SPDX-License-Identifier: MIT
// Checks a simulation independently of the library's own reports: it integrates the targets again,
// derives the interface from the phases, and computes the sign of every triangle by the exact
// predicate after every step.
#pragma once

#include "scene.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"

#include <functional>
#include <memory>

namespace dsc::hard {

/// Records the positions of the vertices before and after each movement.
template <class Real>
class WatchingStage;

struct WatchOptions {
    Rectangle domain;
    int thorough_every =
        1; ///< steps between two calls of `validate`; signs are checked in every step
};

/// A watched simulation; its findings are added to the result.
template <class Real>
class Watch {
public:
    /// `executor` runs the steps; null: the sequential one.
    Watch(Complex<Real>& complex, const Options<Real>& options, const WatchOptions& watch,
          HardResult& result, std::unique_ptr<Executor<Real>> executor = nullptr);

    /// Makes one step. Returns false if the step gave up, or if an error makes further steps
    /// pointless.
    bool step(const Velocity<Real>& velocity, double time, double dt);
    /// Makes `count` steps of dt from `time` on; times are multiplied, not summed. Returns false as
    /// `step`.
    bool run(const Velocity<Real>& velocity, double time, double dt, std::uint64_t count);

    [[nodiscard]] const StepReport& last() const { return last_; }

private:
    void look();

    Complex<Real>& complex_;
    const Options<Real>& options_;
    WatchOptions watch_;
    HardResult& result_;
    std::shared_ptr<WatchingStage<Real>> stage_;
    Simulation<Real> simulation_;
    StepReport last_;
    bool sound_ = true;
};

/// A shape in a flow, and its exact shape at the end.
struct Advected {
    std::string asked;
    std::vector<scenes::Outline> outlines;
    double h;
    Velocity<double> flow;
    double dt;
    std::uint64_t steps;
    std::vector<scenes::Outline> exact;
    double allowed; ///< of `shape_error`
    std::string happened{};
    Rectangle domain = unit_square;
    int thorough_every = 50; ///< as in WatchOptions
};

/// Runs it; all vertices must arrive. `more`: additional measures of the complex at the end.
[[nodiscard]] HardResult
advect(const Advected& advected,
       const std::function<void(const Complex<double>&, HardResult&)>& more = nullptr);

/// Records the error from the exact shape, the worst of several; fails if it is larger than
/// allowed.
void note_error(HardResult& result, double error, double allowed);

/// Checks the errors that no hard case may have: inverted triangles, and missed vertices that are
/// not counted. `reachable`: all vertices must arrive. `too_far`: a step may give up.
enum class Targets { reachable, may_be_missed, too_far };
void expect_sound(HardResult& result, Targets targets);

} // namespace dsc::hard
