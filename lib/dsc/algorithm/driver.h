// SPDX-License-Identifier: MIT
// One time step [5.6, 8.10]. The sub-step is the outermost loop: no vertex is asked to travel more
// than a part of an edge length at a time, and all passes end before the next sub-step begins.
#pragma once

#include "dsc/algorithm/algorithm.h"
#include "dsc/motion/integrator.h"

#include <memory>

namespace dsc {

enum class GiveUp : std::uint8_t {
    none,
    too_many_sub_steps, ///< the velocity asks for more than `max_sub_steps`
};

/// What one step did.
struct StepReport {
    OperationCounts operations;
    std::uint32_t sub_steps = 0;
    std::uint32_t passes = 0;
    std::uint64_t unreached =
        0;                  ///< vertices that did not arrive, summed over sub-steps; with `held`
    std::uint64_t held = 0; ///< of these: held for a velocity that was not finite
    GiveUp gave_up = GiveUp::none;
    std::uint32_t interface_vertices = 0; ///< at the end of the step
};

/// Runs the passes of an algorithm over the whole complex: in one piece, or in submeshes.
template <class Real>
class Executor {
public:
    virtual ~Executor() = default;
    Executor() = default;
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;
    Executor(Executor&&) = delete;
    Executor& operator=(Executor&&) = delete;

    virtual void begin_step() {}
    virtual void run_upkeep() = 0;
    /// Runs the motion passes once over `movers()`; what has not arrived stays there. Returns how
    /// many vertices got any further.
    virtual std::size_t run_motion() = 0;
    virtual void end_step() {}
    /// A piece of [0, n): its number, begin and end.
    using PieceFunction = std::function<void(std::size_t, std::size_t, std::size_t)>;
    /// Calls run for all pieces of [0, n); the pieces do not depend on threads.
    virtual void for_pieces(std::size_t n, const PieceFunction& run) = 0;
    [[nodiscard]] virtual std::size_t piece_count() const = 0;

    [[nodiscard]] virtual const std::vector<std::uint32_t>& interface() const = 0;
    [[nodiscard]] virtual std::vector<Mover<Real>>& movers() = 0;
    [[nodiscard]] virtual OperationCounts take_counts() = 0;
};

/// One work for the whole complex: the thesis's sequential DSC.
template <class Real>
class SequentialExecutor final : public Executor<Real> {
public:
    SequentialExecutor(Complex<Real>& complex, const Options<Real>& options,
                       Algorithm<Real> algorithm);

    void run_upkeep() override;
    std::size_t run_motion() override;
    void for_pieces(std::size_t n, const typename Executor<Real>::PieceFunction& run) override {
        run(0, 0, n);
    }
    [[nodiscard]] std::size_t piece_count() const override { return 1; }
    [[nodiscard]] const std::vector<std::uint32_t>& interface() const override {
        return work_.interface;
    }
    [[nodiscard]] std::vector<Mover<Real>>& movers() override { return work_.movers; }
    [[nodiscard]] OperationCounts take_counts() override;

private:
    Algorithm<Real> algorithm_;
    Work<Real> work_;
    std::uint32_t epoch_ = 0;
};

/// A complex under way. Keeps references to the complex and the options; not thread-safe itself.
template <class Real>
class Simulation {
public:
    /// Sequential, with the default algorithm. Throws InputError where an option is out of range.
    Simulation(Complex<Real>& complex, const Options<Real>& options);
    /// With an algorithm or an executor of one's own.
    Simulation(Complex<Real>& complex, const Options<Real>& options,
               std::unique_ptr<Executor<Real>> executor);

    /// Moves the interface from `time` to `time + dt`. O(interface vertices and what changes about
    /// them), never O(mesh). Throws InputError where dt is negative or not finite.
    StepReport step(const Velocity<Real>& velocity, Real time, Real dt);

    [[nodiscard]] const std::vector<std::uint32_t>& interface() const {
        return executor_->interface();
    }

private:
    bool sub_step(const Velocity<Real>& velocity, Real& time, Real& remaining, StepReport& report);
    Real evaluate(const Velocity<Real>& velocity, Real time, StepReport& report);
    void move_all(StepReport& report);

    Complex<Real>& complex_;
    const Options<Real>& options_;
    std::unique_ptr<Executor<Real>> executor_;
    std::vector<Point<Real>> positions_;
    std::vector<Point<Real>> targets_;
    std::vector<IntegratorScratch<Real>> scratch_;
    std::vector<Point<Real>> first_;
    std::vector<std::uint8_t> held_;
};

} // namespace dsc
