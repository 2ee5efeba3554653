// SPDX-License-Identifier: MIT
// Looks over a simulation's shoulder. Nothing that it reports is taken from the library's word: the
// targets are integrated anew, the interface is derived anew from the phases, and the sign of every
// triangle is asked of the exact predicate after every step.
#pragma once

#include "scene.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"

#include <functional>
#include <memory>

namespace dsc::hard {

/// Sees for itself where the vertices are before and after each movement.
template <class Real>
class WatchingStage;

struct WatchOptions {
    Rectangle domain;
    int thorough_every = 1; ///< steps between two calls of `validate`; signs are asked every step
};

/// A simulation that is watched; all that is seen goes into the result.
template <class Real>
class Watch {
public:
    /// `executor`: what runs the steps; none: the sequential one.
    Watch(Complex<Real>& complex, const Options<Real>& options, const WatchOptions& watch,
          HardResult& result, std::unique_ptr<Executor<Real>> executor = nullptr);

    /// One step; false once the step gave up or something is broken beyond going on.
    bool step(const Velocity<Real>& velocity, double time, double dt);
    /// `count` steps of dt from `time` on, times multiplied and not summed. False as `step`.
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

/// A shape in a flow, and what it has to be at the end.
struct Carried {
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
    int thorough_every = 50; ///< as of a watch
};

/// Runs it, with no vertex left behind. `more`: what else is measured of the complex at the end.
[[nodiscard]] HardResult
carry(const Carried& advected,
      const std::function<void(const Complex<double>&, HardResult&)>& more = nullptr);

/// Notes the error against the exact shape, the worst of several; more than is allowed fails.
void note_error(HardResult& result, double error, double allowed);

/// The faults that no hard case may have: triangles inverted, vertices lost without being counted.
/// `reachable`: no vertex may be left behind at all. `too_far`: a step may give up.
enum class Targets { reachable, may_be_missed, too_far };
void expect_sound(HardResult& result, Targets targets);

} // namespace dsc::hard
