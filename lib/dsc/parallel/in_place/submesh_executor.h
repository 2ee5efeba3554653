// SPDX-License-Identifier: MIT
// Parallel DSC (thesis, sections 6 and 8.10) in place: the submeshes of the first colour run
// remeshing, movement and mesh update at the same time and defer what their boundaries prevent; a
// submesh of the next colour begins when the submeshes that it overlaps have ended; what all
// colours defer is done serially. The regions, the order within a submesh and the pools of ids do
// not depend on threads: the result is bitwise identical for any number of them.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/base/timer.h"
#include "dsc/parallel/in_place/schedule.h"
#include "dsc/parallel/parallel.h"
#include "dsc/parallel/partition/partition.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/parallel/threads/thread_choice.h"
#include "dsc/parallel/threads/thread_pool.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/work.h"

namespace dsc {

/// Runs a step in submeshes that lie in the complex itself. A partition of one submesh is the
/// whole: it runs as in the base class, on one thread.
template <class Real>
class SubmeshExecutor final : public Executor<Real> {
public:
    /// Divides the complex, lends its submeshes their ids and starts threads, so that the first
    /// step costs no more than the others: O(n). Throws InputError if an option is out of range,
    /// and what the partitioner throws.
    SubmeshExecutor(Complex<Real>& complex, const Options<Real>& options, Algorithm<Real> algorithm,
                    std::unique_ptr<Partitioner<Real>> partitioner, const Parallel& parallel);
    /// Gives the ids of the submeshes back to the complex, unless it has begun a new generation of
    /// ids.
    ~SubmeshExecutor() override;

    void begin_step() override;
    TargetReport<Real> compute_targets(const Flow<Real>& flow, Real time, Real dt) override;
    Reach<Real> recompute_targets(const Flow<Real>& flow, Real time, Real dt) override;
    MoveReport move() override;
    void end_step() override;
    void archive(Archive& archive) override;

    /// The current partition, and the profile of the last step.
    [[nodiscard]] SubmeshView view() const {
        return {partition_, moving_.tasks, profile_, threads_, pool_.work_so_far()};
    }

protected:
    [[nodiscard]] Work<Real>& home_of(std::uint32_t vertex) override;

private:
    struct Part;

    // Set-up.
    void divide();
    void make_parts(Recut recut);
    [[nodiscard]] std::uint32_t distribute_interface(std::vector<std::uint32_t> list);
    void connect();
    void make_room();
    [[nodiscard]] static std::size_t min_vertices(const Part& part);
    void refill(Part& part);
    [[nodiscard]] bool has_pools() const { return generation_ == complex_.ids.generation; }
    void lend_pools();
    void choose_threads();
    void give_back_surplus(Part& part);
    [[nodiscard]] std::uint32_t next_epochs();
    // Tasks.
    void begin_part(Part& part);
    void targets_part(Part& part, std::size_t pass, const Flow<Real>& flow, Real time, Real dt);
    void move_part(std::size_t task);
    void accept_routed(Work<Real>& work, const DeferredQueue<Real>& queue, std::size_t task);
    void accept(Work<Real>& work, const Deferred<Real>& one);
    void route(Part& part);
    // Between and after them.
    TargetReport<Real> hand_over(const Flow<Real>& flow, Real time, Real dt);
    void unlist(std::span<const std::uint32_t> vertices);
    void distribute_resized();
    void route_to_owners();
    void clean_up(MoveReport& report);
    void put_back();
    // Flows that depend on the interface: submesh_sight.cpp.
    TargetReport<Real> compute_targets_together(const Flow<Real>& flow, Real time, Real dt);
    void join_interface();
    void distribute_targets();
    [[nodiscard]] std::size_t owner_of(std::uint32_t vertex, std::size_t hint = 0) const;
    [[nodiscard]] Point<double> place_of(std::uint32_t vertex) const;
    [[nodiscard]] std::vector<float> work_of(const std::vector<std::uint32_t>& list) const;

    using Executor<Real>::complex_;
    using Executor<Real>::options_;
    using Executor<Real>::algorithm_;
    using Executor<Real>::whole_;
    using Executor<Real>::works_;
    using Executor<Real>::epoch_;
    using typename Executor<Real>::Progress;
    using Executor<Real>::progress_;

    std::unique_ptr<Partitioner<Real>> partitioner_;
    Parallel parallel_;
    Partition partition_;
    PartitionStatus status_;

    std::vector<std::unique_ptr<Part>> parts_; // colour by colour; none: the whole is one
    std::uint64_t generation_ = 0; // generation of the complex's ids in which the pools were lent
    std::vector<std::unique_ptr<Part>> spare_parts_; // of earlier divisions: their memory is reused
    std::size_t first_colour_ = 0;                   // parts of the first colour
    Schedule targets_schedule_;
    Schedule moving_;
    Schedule sharing_;
    ThreadPool pool_;
    ThreadChoice choice_;
    Timer step_timer_;
    // The interface of all submeshes, one after the other, for flows that depend on it: such flows
    // are evaluated, and the vertices integrated, all at once.
    Work<Real> joined_;
    std::vector<std::size_t> ends_;     // the ends there of each submesh's part, and of the
                                        // vertices in none
    std::vector<std::uint32_t> listed_; // scratch of hand_over
    std::vector<Point<double>> listed_places_;
    std::vector<std::size_t> kept_; // scratch of unlist
    std::uint32_t threads_ = 1;
    std::uint32_t useful_threads_ = 1;    // number of threads that have enough to do in this step
    std::vector<SubStepProfile> profile_; // of the last step
};

} // namespace dsc
