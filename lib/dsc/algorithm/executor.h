// SPDX-License-Identifier: MIT
// Runs the passes of an algorithm over a complex: in one piece (here), or in submeshes
// (dsc/parallel). An application may bring an executor of its own.
#pragma once

#include "dsc/algorithm/aim.h"
#include "dsc/algorithm/interface_sight.h"
#include "dsc/passes/algorithm.h"

namespace dsc {

/// What a movement did.
struct MoveReport {
    std::uint32_t passes = 0;    ///< of movement and mesh update; the most that a submesh took
    std::uint64_t unreached = 0; ///< vertices that did not arrive
    std::uint64_t held = 0;      ///< vertices held for a target that is not finite

    MoveReport& operator+=(const MoveReport& other);
};

/// The driver calls, for each step: begin_step; for each sub-step aim, perhaps aim_again, move;
/// end_step. After an exception it calls end_step only, and the complex must be valid then.
template <class Real>
class Executor {
public:
    virtual ~Executor() = default;
    Executor() = default;
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;
    Executor(Executor&&) = delete;
    Executor& operator=(Executor&&) = delete;

    /// Takes options that have been checked, as a whole, between two steps.
    virtual void set_options(const Options<Real>& options) = 0;
    /// Takes up what the application did to the complex since the step before: its interface, and
    /// the stars to be looked at. O(edits and interface vertices); O(mesh) after a `renumber`.
    virtual void absorb(std::span<const Edit> edits) = 0;
    /// Whether records of edits are to be kept for `take_edits`.
    virtual void keep_edits(bool keep) = 0;
    /// The records since the last call, in an order in which they can be replayed.
    [[nodiscard]] virtual std::vector<Edit> take_edits() = 0;

    virtual void begin_step() {}
    /// Interface upkeep; then velocities at `time` and targets at time + dt. `dt` is what the
    /// driver expects to do; the velocities may make it change its mind.
    virtual AimReport<Real> aim(const Flow<Real>& flow, Real time, Real dt) = 0;
    /// New targets for another dt, from the same positions and for the same flow.
    virtual Reach<Real> aim_again(const Flow<Real>& flow, Real time, Real dt) = 0;
    /// Movement and mesh update, until all vertices are at their targets or do not get any further.
    virtual MoveReport move() = 0;
    virtual void end_step() {}

    /// How many vertices the interface has.
    [[nodiscard]] virtual std::size_t interface_size() const = 0;
    /// Appends them, about in the order of the curve.
    virtual void append_interface(std::vector<std::uint32_t>& list) const = 0;
    /// What was done since the last call.
    [[nodiscard]] virtual OperationCounts take_counts() = 0;
};

/// True once a vertex has missed its target three times on end: something is in its way, and to
/// try for long is to try in vain.
template <class Real>
bool is_in_contact(const VertexRecord<Real>& record) {
    return (record.flags & vertex_contact) == vertex_contact;
}

/// Empties `work.movers`: they did not arrive this time, which is noted with each. Returns how
/// many.
template <class Real>
std::uint64_t give_up_movers(Work<Real>& work);

/// Upkeep, velocities and targets by a work that has the complex for itself. `sight`: kept from
/// call to call, for flows that see the interface.
template <class Real>
AimReport<Real> aim_whole(Work<Real>& work, const std::vector<Pass<Real>>& upkeep,
                          InterfaceSight<Real>& sight, const Flow<Real>& flow, Real time, Real dt);
/// Other targets, for the same flow.
template <class Real>
Reach<Real> aim_whole_again(Work<Real>& work, InterfaceSight<Real>& sight, const Flow<Real>& flow,
                            Real time, Real dt);

/// Repeats the motion passes over `work.movers` until all have arrived but those in contact, for
/// `max_passes` at most, and no longer than `max_idle_passes` without any progress. `next_epoch`
/// gives the stamp of the next pass. Returns the passes run; who did not arrive is left in
/// `work.movers`.
template <class Real>
std::uint32_t run_motion(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                         std::uint32_t& next_epoch);

/// What a work that has the complex for itself does with the edits of the application.
template <class Real>
void absorb_edits(Work<Real>& work, std::span<const Edit> edits);

/// Appends the records of a log to `edits`, and empties it.
void append_edits(EditLog& log, std::vector<Edit>& edits);

/// One work for the whole complex: the thesis's sequential DSC.
template <class Real>
class SequentialExecutor final : public Executor<Real> {
public:
    SequentialExecutor(Complex<Real>& complex, const Options<Real>& options,
                       Algorithm<Real> algorithm);

    void set_options(const Options<Real>& options) override;
    void absorb(std::span<const Edit> edits) override { absorb_edits(work_, edits); }
    void keep_edits(bool keep) override { work_.log.readers = keep ? 1 : 0; }
    [[nodiscard]] std::vector<Edit> take_edits() override;
    void begin_step() override;
    AimReport<Real> aim(const Flow<Real>& flow, Real time, Real dt) override;
    Reach<Real> aim_again(const Flow<Real>& flow, Real time, Real dt) override;
    MoveReport move() override;
    void end_step() override;
    [[nodiscard]] std::size_t interface_size() const override { return work_.interface.size(); }
    void append_interface(std::vector<std::uint32_t>& list) const override;
    [[nodiscard]] OperationCounts take_counts() override;

private:
    Options<Real> options_;
    Algorithm<Real> algorithm_;
    Work<Real> work_;
    InterfaceSight<Real> sight_;
    std::uint32_t epoch_ = 0;
    std::uint64_t steps_ = 0; ///< begun
};

} // namespace dsc
