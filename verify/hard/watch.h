// SPDX-License-Identifier: MIT
// Looks over a simulation's shoulder. Nothing that it reports is taken from the library's word: the
// targets are integrated anew, the interface is derived anew from the phases, and the sign of every
// triangle is asked of the exact predicate after every step.
#pragma once

#include "result.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"

#include <memory>
#include <utility>

namespace dsc::hard {

/// What one sub-step was seen to do.
struct Sighting {
    std::uint64_t missed = 0;      ///< vertices not at the target that was computed here
    std::uint64_t uncounted = 0;   ///< missed beyond the library's count
    std::uint64_t overcounted = 0; ///< the library's count beyond the missed
};

/// An executor that hands everything on to another one, and sees for itself where the vertices are
/// before and after each movement. RK4 and functions of positions and time only.
template <class Real>
class WatchingExecutor final : public Executor<Real> {
public:
    /// Whatever an executor says of targets that are found anew: it is handed on.
    using Again = decltype(std::declval<Executor<Real>&>().aim_again(
        std::declval<const Flow<Real>&>(), Real(0), Real(0)));

    /// `domain`: vertices on its sides are expected to slide, corners to stay. `sighting` takes the
    /// sums.
    WatchingExecutor(const Complex<Real>& complex, const Rectangle& domain,
                     std::unique_ptr<Executor<Real>> inner, Sighting& sighting);

    void set_options(const Options<Real>& options) override { inner_->set_options(options); }
    void absorb(std::span<const Edit> edits) override { inner_->absorb(edits); }
    void keep_edits(bool keep) override { inner_->keep_edits(keep); }
    [[nodiscard]] std::vector<Edit> take_edits() override { return inner_->take_edits(); }
    void add_upkeep(const Pass<Real>& pass) override { inner_->add_upkeep(pass); }
    void begin_step() override { inner_->begin_step(); }
    AimReport<Real> aim(const Flow<Real>& flow, Real time, Real dt) override;
    Again aim_again(const Flow<Real>& flow, Real time, Real dt) override;
    MoveReport move() override;
    void end_step() override { inner_->end_step(); }
    [[nodiscard]] std::size_t interface_size() const override { return inner_->interface_size(); }
    void append_interface(std::vector<std::uint32_t>& list) const override {
        inner_->append_interface(list);
    }
    [[nodiscard]] OperationCounts take_counts() override { return inner_->take_counts(); }

private:
    void find_targets();
    [[nodiscard]] Point<double> on_boundary(const Point<double>& from,
                                            const Point<double>& to) const;

    const Complex<Real>& complex_;
    Rectangle domain_;
    std::unique_ptr<Executor<Real>> inner_;
    Sighting& sighting_;
    const Velocity<Real>* velocity_ = nullptr;
    Real time_ = 0;
    Real dt_ = 0;
    std::uint64_t held_ = 0; ///< by the library's count, while it aimed
    std::vector<std::uint32_t> list_;
    std::vector<Point<Real>> before_;
    std::vector<Point<double>> targets_;
};

struct WatchOptions {
    Rectangle domain;
    int thorough_every = 1; ///< steps between two calls of `validate`; signs are asked every step
};

/// A simulation that is watched; all that is seen goes into the result.
template <class Real>
class Watch {
public:
    /// `inner`: the executor to watch; none: the sequential one.
    Watch(Complex<Real>& complex, const Options<Real>& options, const WatchOptions& watch,
          HardResult& result, std::unique_ptr<Executor<Real>> inner = nullptr);

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
    Sighting sighting_;
    Simulation<Real> simulation_;
    StepReport last_;
    bool sound_ = true;
};

/// The faults that no hard case may have: triangles inverted, vertices lost without being counted.
/// `reachable`: no vertex may be left behind at all, and no step may give up.
enum class Targets { reachable, may_be_missed };
void expect_sound(HardResult& result, Targets targets);

} // namespace dsc::hard
