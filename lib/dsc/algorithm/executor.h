// SPDX-License-Identifier: MIT
// Runs the passes of an algorithm over a complex: in one piece (here), or in submeshes first
// (dsc/parallel). An application may derive its own executor, which can use the parts of a
// sub-step.
#pragma once

#include "dsc/algorithm/sub_step.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

#include <memory>
#include <span>
#include <vector>

namespace dsc {

template <class Real>
class InterfaceSight;

/// Runs the passes over the whole complex, on the calling thread: the sequential DSC of the thesis.
/// A derived class may run submeshes first; the whole then does what all of them deferred.
///
/// For each step the driver calls begin_step; for each sub-step compute_targets, perhaps
/// recompute_targets, and move, and where stages have edited the complex move_missed; then
/// end_step. After an exception it only calls end_step, and the complex must be valid then.
template <class Real>
class Executor : public Unmovable {
public:
    /// Lists the interface and keeps the options, which the simulation has checked. O(mesh).
    Executor(Complex<Real>& complex, const Options<Real>& options, Algorithm<Real> algorithm);
    virtual ~Executor();

    /// The complex passed to the constructor.
    [[nodiscard]] const Complex<Real>& complex() const { return complex_; }

    // Between two steps.
    /// Replaces all options by checked ones. O(mesh) if the advected phases change.
    void set_options(const Options<Real>& options);
    /// Appends a pass to the remeshing, with which a stage can observe stars before anything moves.
    void add_remeshing(const Pass<Real>& pass);
    /// Whether records of edits are kept from now on, for `take_edits`.
    void keep_edits(bool keep);
    /// As `Simulation::watch_quality`.
    void watch_quality(double quality);
    /// Adds vertices for the next mesh update to visit because their edges, or the targets of
    /// these, may have to change.
    void resize(std::span<const std::uint32_t> list);

    /// Takes account of edits that the executor did not make: those of the application between two
    /// steps, and of a stage between two sub-steps. Updates the interface and the stars to be
    /// visited. O(edits and interface vertices); O(mesh) after a `renumber`.
    void absorb(std::span<const Edit> edits);

    // In a step.
    /// Called before the first sub-step.
    virtual void begin_step();
    /// Interface remeshing, unless it was done for the same `time` and `dt` and the flow threw
    /// after it; then velocities at `time` and targets at time + dt. `dt` is the step that the
    /// driver expects; it may change it once the velocities are known.
    virtual TargetReport<Real> compute_targets(const Flow<Real>& flow, Real time, Real dt);
    /// Finds new targets for another dt, from the same positions and for the same flow.
    virtual Reach<Real> recompute_targets(const Flow<Real>& flow, Real time, Real dt);
    /// Movement and mesh update, until all vertices are at their targets or make no more progress.
    virtual MoveReport move();
    /// Moves the vertices that did not arrive once more, after a stage has edited the complex,
    /// which may have unblocked them. `gone` are those whose targets are void, ascending. Returns
    /// how many have arrived now, or are no longer to be moved.
    [[nodiscard]] std::uint64_t move_missed(std::span<const std::uint32_t> gone);
    /// The vertices that did not arrive, between `move` and the next step.
    [[nodiscard]] std::span<const MovingVertex<Real>> missed() const {
        return whole_.moving_vertices;
    }
    /// The threads of the step, for serial work that can be shared.
    [[nodiscard]] const InShares& in_shares() const { return in_shares_; }
    /// Called after the last sub-step, also after an exception.
    virtual void end_step();

    // Afterwards.
    /// The number of interface vertices.
    [[nodiscard]] std::size_t interface_size() const;
    /// Appends the interface vertices, roughly in the order of the curve.
    void append_interface(std::vector<std::uint32_t>& list) const;
    /// The records of edits since the last call, in an order in which they can be replayed; valid
    /// until the next call.
    [[nodiscard]] std::span<const Edit> take_edits();
    /// As `Simulation::take_poor`.
    [[nodiscard]] std::span<const std::uint32_t> take_poor();
    /// The edits counted since the last call.
    [[nodiscard]] OperationCounts take_counts();

    /// Between two steps: writes what the next one depends on, or reads it back into an executor
    /// that was made in the same way, after its complex has been read (base/archive.h).
    virtual void archive(Archive& archive);

protected:
    /// The progress of a sub-step.
    enum class Progress : std::uint8_t {
        none,        ///< it has ended, or has not begun
        under_way,   ///< lists may not match the mesh
        has_targets, ///< remeshing is done and targets are known, nothing moves yet
    };

    /// The work whose list has the interface vertex.
    virtual Work<Real>& home_of(std::uint32_t /*vertex*/) { return whole_; }

    // Parts of a step.
    /// Interface remeshing in the whole. Nothing is deferred there.
    void keep_up_whole();
    /// Collects the moving vertices of the whole, before any vertex moves. Returns how many are
    /// held.
    std::uint64_t begin_movement();
    /// Movement and mesh update in the whole: its moving vertices, and the stars that have to be
    /// visited.
    MoveReport move_whole();
    /// Call when all vertices have moved: collects edits and updates lists.
    void end_movement();
    /// Call between the sections of a sub-step. The submeshes of a section do not edit what others
    /// own, so their edits can be replayed submesh by submesh.
    void collect_edits();
    /// Applies the changes of the interface that passes noted to the lists of other works.
    void collect_changes();
    /// Updates the lists for vertices (ascending) that may have joined or left the interface.
    void change_interface(std::span<const std::uint32_t> changed);
    /// Rebuilds the lists of the interface. O(mesh).
    void list_interface();
    /// A stamp that no vertex has.
    [[nodiscard]] std::uint32_t new_stamp();

    Complex<Real>& complex_;         ///< of the simulation
    Options<Real> options_;          ///< of the next step
    Algorithm<Real> algorithm_;      ///< the passes
    Work<Real> whole_;               ///< the whole, or what the submeshes deferred
    std::vector<Work<Real>*> works_; ///< those of the submeshes, if any, then the whole
    std::uint32_t epoch_ = 0;        ///< the last stamp
    std::uint64_t steps_ = 0;        ///< begun so far
    /// At the end of a step `none`, unless it gave up or something threw.
    Progress progress_ = Progress::none;
    /// Whether the whole mesh has been remeshed for the time and dt in `whole_`, and nothing has
    /// changed since.
    bool is_kept_up_ = false;
    InShares in_shares_ = one_by_one;             ///< unless a derived class has threads
    std::unique_ptr<InterfaceSight<Real>> sight_; ///< targets of the whole interface at once

private:
    std::vector<Edit> edits_;               ///< by section, then in the order of `works_`
    std::vector<Edit> taken_;               ///< those of the last `take_edits`; keeps its memory
    std::vector<std::uint32_t> poor_;       ///< of the sections so far
    std::vector<std::uint32_t> taken_poor_; ///< those of the last `take_poor`
};

} // namespace dsc
