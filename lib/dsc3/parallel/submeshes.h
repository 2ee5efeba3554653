// SPDX-License-Identifier: MIT
// Edits in submeshes, colour after colour. The submeshes of a colour are disjoint, so their threads
// need no locks; where a cut prevents an edit, a later colour, which cuts elsewhere, does it.
#pragma once

#include "dsc3/complex/ownership.h"
#include "dsc3/operations/workspace.h"
#include "dsc3/parallel/parallel.h"
#include "dsc3/parallel/team.h"

#include <cstdint>
#include <vector>

namespace dsc3 {

/// An interface edge that is a candidate of remeshing.
struct WantingEdge {
    Real square; ///< of its length
    std::uint32_t a;
    std::uint32_t b;
};

/// A submesh, the items that are to be edited there, and what the edits have changed. No cache line
/// is also that of another one.
struct alignas(64) SubmeshWorker {
    Submesh submesh;
    std::vector<std::uint32_t> changed;    ///< as `Rewiring::changed`
    std::vector<std::uint32_t> interface;  ///< as `Rewiring::interface`
    std::vector<std::uint32_t> unfit;      ///< tets to be improved; afterwards those deferred
    std::vector<std::uint32_t> unimproved; ///< as `PassState::unimproved`
    std::vector<WantingEdge> edges;        ///< to be edited; afterwards those deferred
    std::vector<Point> places;             ///< of its work since the last division
};

/// The submeshes of a simulation.
class Submeshes : public dsc::Unmovable {
public:
    /// Items below this number are done by one thread: colours would cost more than they gain.
    static constexpr std::size_t min_items = 24;
    /// A submesh edits only while it has so many free ids of tets.
    static constexpr std::size_t min_free_tets = 128;
    /// What `owner` returns for an item that needs nothing any more.
    static constexpr std::uint32_t done = no_id - 1;

    Submeshes(Complex& complex, Real edge_length, const Parallel& parallel, Team& team);

    /// Cuts all colours anew, such that each submesh has as much work as in the time since the last
    /// call, and little of it near the cuts. O(mesh), shared by the threads.
    void divide(const std::vector<std::uint32_t>& interface);

    /// Hands out the items of a list to submeshes in up to `colours` colours: `owner(item, colour)`
    /// is a submesh, `no_id` or `done`. `edit(worker, work)` then edits all items of `worker.*list`
    /// in the workspace of a thread, and leaves those in it that it defers. Afterwards `items` has
    /// those that no colour did.
    template <class Item, class Owner, class Edit>
    void in_colours(std::vector<Item>& items, std::uint32_t colours,
                    std::vector<Item> SubmeshWorker::*list, Owner owner, Edit edit);

    [[nodiscard]] Ownership& ownership() { return ownership_; }
    /// Adds counts, changed tets and new interface vertices of all submeshes to those of `work`.
    void hand_over(Workspace& work);
    /// A number for the division and the number of submeshes, by the options. Partitions of an
    /// application that divide the complex differently have different numbers, except by chance (1
    /// in 65,536). O(vertices) for a partition.
    [[nodiscard]] std::uint32_t kind() const;
    /// The next division depends on where the work was: writes it or reads it back.
    void archive(dsc::Archive& archive);
    [[nodiscard]] std::vector<SubmeshWorker>& workers() { return workers_; }

private:
    void gather_places();
    void label();
    void deal_ids(std::uint32_t colour);
    void take_ids_back();

    Complex& complex_;
    Team& team_;
    Real edge_length_;
    Parallel parallel_;
    Ownership ownership_;
    std::vector<SubmeshWorker> workers_;
    // By thread and not by submesh: they stay in the caches of their cores.
    std::vector<Workspace> workspaces_;
    std::vector<std::size_t> loads_;    ///< items by submesh
    std::vector<std::uint32_t> order_;  ///< submeshes with items: those with the most first
    std::vector<std::uint32_t> owners_; ///< by item
    std::vector<Point> places_;
};

/// Appends a list to another one, and empties it.
template <class Value>
void move_all(std::vector<Value>& to, std::vector<Value>& from) {
    to.insert(to.end(), from.begin(), from.end());
    from.clear();
}

template <class Item, class Owner, class Edit>
void Submeshes::in_colours(std::vector<Item>& items, std::uint32_t colours,
                           std::vector<Item> SubmeshWorker::*list, Owner owner, Edit edit) {
    for (std::uint32_t colour = 0; colour < colours && items.size() >= min_items; ++colour) {
        owners_.resize(items.size());
        constexpr std::size_t grain = 256;
        team_.chunks(items.size(), grain,
                     [&](std::uint32_t, std::size_t begin, std::size_t end, std::uint32_t) {
                         for (std::size_t k = begin; k < end; ++k) {
                             owners_[k] = owner(items[k], colour);
                         }
                     });
        std::size_t kept = 0;
        for (std::size_t k = 0; k < items.size(); ++k) {
            if (owners_[k] == no_id) {
                items[kept++] = items[k];
            } else if (owners_[k] != done) {
                (workers_[owners_[k]].*list).push_back(items[k]);
            }
        }
        items.resize(kept);
        loads_.clear();
        for (const SubmeshWorker& worker : workers_) {
            loads_.push_back((worker.*list).size());
        }
        deal_ids(colour);
        team_.each(static_cast<std::uint32_t>(order_.size()),
                   [&](std::uint32_t k, std::uint32_t thread) {
                       SubmeshWorker& worker = workers_[order_[k]];
                       Workspace& work = workspaces_[thread];
                       work.rewiring.submesh = &worker.submesh;
                       edit(worker, work);
                       move_all(worker.changed, work.rewiring.changed);
                       move_all(worker.interface, work.rewiring.interface);
                   });
        take_ids_back();
        for (SubmeshWorker& worker : workers_) {
            move_all(items, worker.*list);
        }
    }
}

} // namespace dsc3
