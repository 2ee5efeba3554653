// SPDX-License-Identifier: MIT
// The state shared by the passes of a step: pending vertices, their targets, and tets to be
// improved.
#pragma once

#include "dsc3/operations/workspace.h"
#include "dsc3/parallel/submeshes.h"
#include "dsc3/parallel/team.h"
#include "dsc3/passes/options.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace dsc3 {

/// A vertex that is not where it should be: the flow moves it from there.
struct LateVertex {
    std::uint32_t vertex = no_id;
    /// Its position: distinguishes it from a new vertex that reuses the id.
    Point place = Point::Zero();
    Point target = Point::Zero();
};

/// The state of a vertex in movement: one cache line.
struct alignas(64) MovingVertex {
    std::uint32_t leaders = 0; ///< from how many vertices its displacement was averaged
    std::uint32_t wanted = 0;  ///< the last round in which one of its tets was bad
    float fraction = 0;        ///< of its displacement
    Point way = Point::Zero(); ///< from its origin to its target
    Point origin = Point::Zero();
};

/// What the tets of one chunk contribute to the displacement of a vertex.
struct Follower {
    Point way;
    std::uint32_t vertex;
    std::uint32_t count;
};

/// Sorts by length, then by id, and keeps each edge once, so that the order does not depend on that
/// of the search. O(n log n).
template <class Before>
void sort_once(std::vector<WantingEdge>& edges, Before before) {
    std::sort(edges.begin(), edges.end(), [&](const WantingEdge& x, const WantingEdge& y) {
        return x.square != y.square ? before(x.square, y.square)
                                    : std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const WantingEdge& x, const WantingEdge& y) {
                                return x.a == y.a && x.b == y.b;
                            }),
                edges.end());
}

/// Of one thread: no cache line is also another thread's.
struct alignas(64) ThreadScratch {
    Star star;
    std::vector<std::uint32_t> places; ///< by vertex: its place in the list of followers
};

/// Of one simulation. Arrays by id grow with the complex; nothing else is allocated in a step.
struct PassState {
    Complex& complex;
    const Options& options;
    Team& team;
    Submeshes* submeshes = nullptr; ///< none: sequential
    Workspace work = {};

    std::vector<std::uint32_t> interface = {}; ///< its vertices, by ascending id
    bool ends_on_sides = false;                ///< whether one of them is on the domain boundary
    std::vector<std::uint32_t> pending = {};   ///< vertices that have not arrived
    std::vector<Point> targets = {};           ///< by vertex, for pending ones
    std::vector<LateVertex> late = {}; ///< that have not arrived, or have no room where inserted
    std::vector<std::uint32_t> unfit = {};      ///< tets to be improved
    std::vector<std::uint32_t> unimproved = {}; ///< worst tets that mesh repair left bad
    std::uint64_t unjammed = 0;                 ///< interface collapses of blocked vertices

    std::vector<std::uint32_t> merged = {}; ///< scratch of `update_interface`
    // Scratch of interface remeshing.
    std::vector<WantingEdge> too_short = {};
    std::vector<WantingEdge> too_long = {};
    std::vector<WantingEdge> to_flip = {};
    std::vector<std::pair<Real, std::uint32_t>> worst = {}; ///< unimproved tets, by quality
    std::vector<std::uint32_t> beside = {};                 ///< tets with a vertex of the interface
    std::vector<Point> middles = {};                        ///< of the curved edges `too_long`
    // Scratch of movement.
    std::vector<std::uint8_t> moves = {};  ///< by vertex: not 0 if it moves in this pass
    std::vector<MovingVertex> moving = {}; ///< by vertex
    std::vector<std::uint32_t> moving_vertices = {};
    std::vector<std::uint32_t> tet_stamps = {}; ///< by tet: the last pass that listed it
    std::uint32_t pass = 0;
    std::vector<std::uint32_t> near = {}; ///< tets with a vertex that moves
    std::vector<Real> near_quality = {};
    std::vector<std::uint32_t> listed = {};
    // Scratch of loops in chunks.
    ByChunk<std::uint32_t> lists = {};
    ByChunk<std::uint32_t> lists_beyond = {};
    ByChunk<WantingEdge> short_edges = {};
    ByChunk<WantingEdge> long_edges = {};
    ByChunk<WantingEdge> flips = {};
    ByChunk<Follower> followers = {};
    std::vector<ThreadScratch> threads = {};

    /// Whether the tets at so many vertices are better found by looking at all tets in the order of
    /// their ids: memory is then read in that order, and so, nearly, in the order of places.
    [[nodiscard]] bool is_dense(std::size_t count) const {
        return 1000 * count > complex.tet_count();
    }
    /// Makes the arrays by id as long as the complex.
    void grow();
    /// Takes over what the submeshes have done.
    void collect_from_submeshes();
    /// Removes vertices from `interface` that have left it, and adds new ones. O(interface).
    void update_interface();
    /// Finds the interface from scratch. O(mesh).
    void find_interface();
    /// Updates `ends_on_sides`. O(interface).
    void update_ends();
    /// Renumbers the tets, and those listed as unfit. O(n log n).
    void renumber();
    /// Removes late vertices that were moved or have left the interface. O(late).
    void drop_stale_late();
    /// Adds the tets that were written since the last call, if they are below the quality.
    void collect_unfit(Real quality);
};

} // namespace dsc3
