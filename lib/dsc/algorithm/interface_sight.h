// SPDX-License-Identifier: MIT
// Adapts a flow that sees the interface to code that expects a function of positions and time. The
// function takes all interface vertices at once, so that they are all at the same stage.
#pragma once

#include "dsc/algorithm/aim.h"
#include "dsc/algorithm/interface_graph.h"
#include "dsc/passes/work.h"

#include <functional>
#include <span>
#include <vector>

namespace dsc {

/// Calls `run` for ranges 0, 1, ..., at once or one after the other, and returns when all are done.
using RunRanges = std::function<void(const std::function<void(std::size_t range)>& run)>;

/// Must not be moved while a velocity from it is in use. Reuses its memory.
template <class Real>
class InterfaceSight {
public:
    /// Reads `work.interface`, which must be the whole interface and is divided into ranges that
    /// end at `ends`. O(its stars), shared among the ranges.
    void look(Work<Real>& work, std::span<const std::size_t> ends, RunRanges run_ranges);
    /// The same in one range, on the calling thread.
    void look(Work<Real>& work);

    /// The flow as a function of the positions of all of `work.interface`, in that order: for
    /// `find_velocities` and `find_targets` of the work that was read. Valid until the next look,
    /// and while `flow` exists. Locked and held vertices, and those whose stage is not finite, are
    /// seen at their present positions: a failure at one vertex must not affect its neighbours.
    [[nodiscard]] Velocity<Real> velocity(const InterfaceFlow<Real>& flow);

    /// Aims the work that was read by a flow that sees the interface: velocities at `time`, and
    /// targets at time + dt.
    AimReport<Real> aim(const Flow<Real>& flow, Real time, Real dt);
    /// New targets of the same flow for another dt. A vertex that is held stays held.
    Reach<Real> aim_again(const Flow<Real>& flow, Real time, Real dt);

private:
    Reach<Real> displace(const InterfaceMotion<Real>& motion, Real time, Real dt);
    void evaluate(std::span<const Point<Real>> positions, Real time,
                  std::span<Point<Real>> velocities);
    [[nodiscard]] std::size_t begin_of(std::size_t range) const {
        return range == 0 ? 0 : ends_[range - 1];
    }
    [[nodiscard]] bool stays(std::size_t i) const;

    InterfaceGraph<Real> graph_;
    Work<Real>* work_ = nullptr;
    std::vector<std::size_t> ends_;
    RunRanges run_ranges_;
    const InterfaceFlow<Real>* flow_ = nullptr;
    std::vector<Point<Real>> stage_;
};

} // namespace dsc
