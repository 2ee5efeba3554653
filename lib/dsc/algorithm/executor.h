// SPDX-License-Identifier: MIT
// Runs the passes of an algorithm over a complex: in one piece (here), or in submeshes
// (dsc/parallel). An application may supply its own executor.
#pragma once

#include "dsc/algorithm/aim.h"
#include "dsc/algorithm/interface_sight.h"
#include "dsc/passes/algorithm.h"

namespace dsc {

/// The result of a movement.
struct MoveReport {
    std::uint32_t passes = 0;    ///< of movement and mesh update; the most that a submesh took
    std::uint64_t unreached = 0; ///< vertices that did not arrive
    std::uint64_t held = 0;      ///< vertices held because of a target that is not finite

    MoveReport& operator+=(const MoveReport& other);
};

/// For each step the driver calls begin_step; for each sub-step aim, perhaps aim_again, and move;
/// then end_step. After an exception it only calls end_step, and the complex must be valid then.
template <class Real>
class Executor {
public:
    virtual ~Executor() = default;
    Executor() = default;
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;
    Executor(Executor&&) = delete;
    Executor& operator=(Executor&&) = delete;

    /// Replaces all options by ones that have been checked, between two steps.
    virtual void set_options(const Options<Real>& options) = 0;
    /// Takes account of what the application did to the complex since the previous step: updates
    /// the interface and the stars to be visited. O(edits and interface vertices); O(mesh) after a
    /// `renumber`.
    virtual void absorb(std::span<const Edit> edits) = 0;
    /// Whether records of edits are to be kept for `take_edits`.
    virtual void keep_edits(bool keep) = 0;
    /// The records since the last call, in an order in which they can be replayed.
    [[nodiscard]] virtual std::vector<Edit> take_edits() = 0;

    /// Appends a pass to the upkeep, between two steps: what a stage has to see before anything
    /// moves.
    virtual void add_upkeep(const Pass<Real>& pass) = 0;

    /// Vertices that the next mesh update has to look at, because their edges or the targets of
    /// these may have to change. Only called if edges are not all of one length, or were not.
    virtual void resize(std::span<const std::uint32_t> list) { (void)list; }

    /// Called before the first sub-step of a step.
    virtual void begin_step() {}
    /// Interface upkeep; then velocities at `time` and targets at time + dt. `dt` is the step that
    /// the driver expects; it may change it once the velocities are known.
    virtual AimReport<Real> aim(const Flow<Real>& flow, Real time, Real dt) = 0;
    /// New targets for another dt, from the same positions and for the same flow.
    virtual Reach<Real> aim_again(const Flow<Real>& flow, Real time, Real dt) = 0;
    /// Movement and mesh update, until all vertices are at their targets or make no more progress.
    virtual MoveReport move() = 0;
    /// Tries those that did not arrive once more, after a stage has edited the complex, which may
    /// have set them free. `gone` are the vertices that it took off the interface, ascending.
    /// Returns how many have arrived now, or are no longer to be moved.
    [[nodiscard]] virtual std::uint64_t move_missed(std::span<const std::uint32_t> /*gone*/) {
        return 0;
    }
    /// Called after the last sub-step, also where something threw.
    virtual void end_step() {}

    /// The number of interface vertices.
    [[nodiscard]] virtual std::size_t interface_size() const = 0;
    /// Appends them, roughly in the order of the curve.
    virtual void append_interface(std::vector<std::uint32_t>& list) const = 0;
    /// The edits counted since the last call.
    [[nodiscard]] virtual OperationCounts take_counts() = 0;

    /// Between two steps: writes what the next one depends on, or reads it back into an executor
    /// that was made in the same way, after its complex has been read (base/archive.h). Without an
    /// override it throws InputError: a simulation by this executor has no checkpoints.
    virtual void archive(Archive& archive);
};

/// True once a vertex has missed its target three times in a row: something is in its way, and
/// further attempts would be in vain.
template <class Real>
bool is_in_contact(const VertexRecord<Real>& record) {
    return (record.flags & vertex_contact) == vertex_contact;
}

/// Empties `work.movers`: they did not arrive this time, which is noted for each vertex. Returns
/// their number, without those that have vanished. They are kept in `work.missed`.
template <class Real>
std::uint64_t give_up_movers(Work<Real>& work);

/// `Executor::move_missed` for `work.missed`, in a work that has the complex to itself.
/// `next_epoch` as in run_motion.
template <class Real>
[[nodiscard]] std::uint64_t move_missed_of(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                                           std::span<const std::uint32_t> gone,
                                           std::uint32_t& next_epoch);

/// Upkeep, velocities and targets for a work that has the complex to itself. `sight` is kept from
/// call to call, for flows that see the interface.
template <class Real>
AimReport<Real> aim_whole(Work<Real>& work, const std::vector<Pass<Real>>& upkeep,
                          InterfaceSight<Real>& sight, const Flow<Real>& flow, Real time, Real dt);
/// New targets for the same flow.
template <class Real>
Reach<Real> aim_whole_again(Work<Real>& work, InterfaceSight<Real>& sight, const Flow<Real>& flow,
                            Real time, Real dt);

/// Repeats the motion passes over `work.movers` until all have arrived except those in contact, for
/// at most `max_passes`, and at most `max_idle_passes` without any progress. `next_epoch` gives the
/// stamp of the next pass. Returns the number of passes run; vertices that did not arrive are left
/// in `work.movers`.
template <class Real>
std::uint32_t run_motion(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                         std::uint32_t& next_epoch);

/// The stamp after `last`, which it becomes. After the greatest one, in 2^32 passes, the vertices
/// lose theirs and it begins anew: O(mesh). For a work that has the complex to itself.
template <class Real>
std::uint32_t next_stamp(Complex<Real>& complex, std::uint32_t& last);

/// No vertex has a stamp any more: those of another run must not be mistaken for this one's.
/// O(mesh).
template <class Real>
void clear_stamps(Complex<Real>& complex);

/// Processes the edits of the application, for a work that has the complex to itself.
template <class Real>
void absorb_edits(Work<Real>& work, std::span<const Edit> edits);

/// Appends the records of a log to `edits`, and empties it.
void append_edits(EditLog& log, std::vector<Edit>& edits);

/// One work for the whole complex: the sequential DSC of the thesis.
template <class Real>
class SequentialExecutor final : public Executor<Real> {
public:
    /// Lists the interface and reads the options, which the simulation has checked. O(mesh).
    SequentialExecutor(Complex<Real>& complex, const Options<Real>& options,
                       Algorithm<Real> algorithm);

    void set_options(const Options<Real>& options) override;
    void absorb(std::span<const Edit> edits) override { absorb_edits(work_, edits); }
    void keep_edits(bool keep) override { work_.log.readers = keep ? 1 : 0; }
    [[nodiscard]] std::vector<Edit> take_edits() override;
    void add_upkeep(const Pass<Real>& pass) override { algorithm_.upkeep.push_back(pass); }
    void resize(std::span<const std::uint32_t> list) override {
        work_.resized.insert(work_.resized.end(), list.begin(), list.end());
    }
    void begin_step() override;
    AimReport<Real> aim(const Flow<Real>& flow, Real time, Real dt) override;
    Reach<Real> aim_again(const Flow<Real>& flow, Real time, Real dt) override;
    MoveReport move() override;
    [[nodiscard]] std::uint64_t move_missed(std::span<const std::uint32_t> gone) override {
        return move_missed_of(work_, algorithm_.motion, gone, epoch_);
    }
    void end_step() override;
    [[nodiscard]] std::size_t interface_size() const override { return work_.interface.size(); }
    void append_interface(std::vector<std::uint32_t>& list) const override;
    [[nodiscard]] OperationCounts take_counts() override;
    void archive(Archive& archive) override;

private:
    Options<Real> options_;
    Algorithm<Real> algorithm_;
    Work<Real> work_;
    InterfaceSight<Real> sight_;
    std::uint32_t epoch_ = 0;
    std::uint64_t steps_ = 0; ///< steps begun so far
};

} // namespace dsc
