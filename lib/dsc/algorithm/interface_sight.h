// SPDX-License-Identifier: MIT
// The interface as flows see it: the graph behind an `InterfaceView`, and the adapter of such a
// flow to code that expects a function of positions and time. The function takes all interface
// vertices at once, so that they are all at the same stage.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

#include <span>
#include <vector>

namespace dsc {

/// The graph is built in three rounds; in the first two, threads may work on different ranges of
/// the list:
///
///     graph.resize(size, ranges);   // then for each range, at once: number
///                                   // when all are done, for each range, at once: connect
///     graph.join();
///
/// Uses `VertexRecord::slot` of the interface vertices. Reuses its memory.
template <class Real>
class InterfaceGraph {
public:
    /// Makes room for that many vertices in that many ranges.
    void resize(std::size_t vertices, std::size_t ranges);
    /// Numbers the vertices of `list` from `begin` on. O(list).
    void number(Complex<Real>& complex, std::span<const std::uint32_t> list, std::size_t begin);
    /// Finds the neighbours of numbers `begin` to `end`, which are range `range`. Neighbours
    /// without a number are omitted: a pass of the application may just have put them on the
    /// interface, and they are listed from the next sub-step on. `stars` are the cached stars of
    /// vertices in the list, in its order. O(stars).
    void connect(const Complex<Real>& complex, std::size_t range, std::size_t begin,
                 std::size_t end, std::span<const CachedStar> stars);
    /// Concatenates the junctions of all ranges. O(junctions).
    void join();

    /// The view at these positions of the stage, one for each vertex. The view refers to the graph
    /// and the arguments.
    [[nodiscard]] InterfaceView<Real> view(const Complex<Real>& complex,
                                           std::span<const Point<Real>> positions,
                                           const InShares& in_shares = one_by_one) const;

private:
    struct Junctions { // of one range; the last entry of `begin` is the number of arms
        std::vector<std::uint32_t> indices;
        std::vector<std::uint32_t> begin;
        std::vector<InterfaceArm> arms;
    };
    [[nodiscard]] bool has_number(const Complex<Real>& complex, std::uint32_t v) const;
    bool connect_cached(const Complex<Real>& complex, std::size_t i, const CachedStar& star);
    void connect_one(const Complex<Real>& complex, std::size_t i, Junctions& found);

    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> next_;
    std::vector<Phase> left_;
    std::vector<Phase> right_;
    std::vector<std::uint8_t> flags_;
    Junctions junctions_;
    std::vector<Junctions> found_; // by range
};

/// Computes the targets of the whole interface at once, for any kind of flow. Reuses its memory.
template <class Real>
class InterfaceSight : public Unmovable {
public:
    /// `in_shares`: the threads of each step; must outlive this object.
    explicit InterfaceSight(const InShares& in_shares) : in_shares_(in_shares) {}

    /// Finds the velocities of `work.interface` at `time`, and targets at time + dt. The list must
    /// be the whole interface; it is divided into ranges that end at `ends`, and an `InterfaceFlow`
    /// is called for each range. O(stars of the interface), shared among the ranges, if the flow
    /// depends on the interface; else O(interface vertices).
    TargetReport<Real> compute_targets(Work<Real>& work, std::span<const std::size_t> ends,
                                       const Flow<Real>& flow, Real time, Real dt);
    /// Finds new targets of the same work and flow for another dt. A held vertex stays held.
    Reach<Real> recompute_targets(const Flow<Real>& flow, Real time, Real dt);

private:
    void look(std::span<const std::size_t> ends);
    /// Finds how far vertices have gone ahead of the time, by the flow. The flow sees a vertex that
    /// is ahead and waits where its front is now: at its own place, its neighbours would have
    /// tilted normals, and it would pass them in the stages of the integrator.
    void find_leads(const InterfaceFlow<Real>& flow, Real time);
    /// The flow as a function of the positions of all of the interface, in the order of its list.
    /// Valid while `flow` exists. Locked and held vertices, and those whose stage is not finite,
    /// are seen at their present positions: a failure at one vertex must not affect its neighbours.
    [[nodiscard]] Velocity<Real> velocity(const InterfaceFlow<Real>& flow);
    Reach<Real> displace(const InterfaceMotion<Real>& motion, Real time, Real dt);
    void evaluate(std::span<const Point<Real>> positions, Real time,
                  std::span<Point<Real>> velocities);
    [[nodiscard]] std::size_t begin_of(std::size_t range) const {
        return range == 0 ? 0 : ends_[range - 1];
    }
    [[nodiscard]] bool stays(std::size_t i) const;

    const InShares& in_shares_;
    InterfaceGraph<Real> graph_;
    Work<Real>* work_ = nullptr;
    std::vector<std::size_t> ends_;
    const InterfaceFlow<Real>* flow_ = nullptr;
    std::vector<Point<Real>> stage_;

    struct Lead {
        std::size_t i = 0;                     ///< of the vertex
        Real time = 0;                         ///< by which it is ahead
        Point<Real> way = Point<Real>::Zero(); ///< that it has gone in that time
    };
    std::vector<Lead> leads_;
};

} // namespace dsc
