// SPDX-License-Identifier: MIT
// Stages of a simulation.
//
// Serial work between two sub-steps, in the whole complex: changes of topology, an implicit solve,
// remeshing by a criterion of the application. A stage may add a pass, which runs in the submeshes
// at the end of the remeshing and stores data for the stage in an attribute: attributes follow
// operations, renumbering, copies and checkpoints automatically.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"

#include <cstdint>
#include <optional>
#include <span>

namespace dsc {

template <class Real>
class Simulation;

/// The arguments of a stage.
template <class Real>
struct Between {
    Complex<Real>& complex;                   ///< edits are noted in its journal
    std::span<const std::uint32_t> interface; ///< the vertices that the flow moves, in any order
    Real edge_length;                         ///< of the options
    Real time;                                ///< at the end of the sub-step
    Real dt;                                  ///< the duration of the sub-step
    std::uint64_t unreached;                  ///< vertices that did not arrive in it
    /// Those that are still to be moved, with their targets.
    std::span<const MovingVertex<Real>> missed;
    const InShares& in_shares; ///< the threads of the step, for parallel reading
};

/// A stage of a simulation. Runs on the thread that calls `Simulation::step`, which rethrows its
/// exceptions; the complex must be valid then. A stage that has to read the edits of the sub-step
/// adds a listener, which is called before the stage runs.
template <class Real>
class Stage : public Unmovable {
public:
    virtual ~Stage() = default;

    /// Throws InputError if the stage does not suit the complex or these options. Called before
    /// `begin`, for all stages of a simulation before anything changes.
    virtual void check(const Complex<Real>& complex, const Options<Real>& options) const {
        (void)complex, (void)options;
    }
    /// Called when the stage is added, whenever the options have changed, and after the application
    /// has renumbered or replaced the complex: its attributes may have changed.
    virtual void begin(Complex<Real>& complex, const Options<Real>& options) {
        (void)complex, (void)options;
    }
    /// The last pass of the remeshing, once a sub-step. Called when the stage is added.
    [[nodiscard]] virtual std::optional<Pass<Real>> pass() { return {}; }
    /// Called after each sub-step. Edits are absorbed after the call, and reported to the
    /// listeners; vertices that did not arrive in the sub-step are then moved again.
    virtual void run(const Between<Real>& between) = 0;
    /// Called after `run` in the same sub-step, up to three times, as long as stages edit the
    /// complex and vertices are still blocked: they may have come close to what blocks them only
    /// now.
    virtual void run_again(const Between<Real>& between) { (void)between; }
    /// Called after the edits are absorbed, for listeners of the stage's own.
    virtual void tell() {}
    /// Writes what the stage keeps from one step to the next, or reads it back; see
    /// `Simulation::archive`. Attributes of the complex are archived with the complex.
    virtual void archive(Archive& archive) { (void)archive; }

private:
    friend class Simulation<Real>;
    bool has_simulation_ = false;
};

} // namespace dsc
