// SPDX-License-Identifier: MIT
// The curves of a network between its junctions, and how threads share them.
#pragma once

#include "dsc/base/types.h"
#include "dsc/motion/interface_flow.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace dsc {

struct CurveNetwork;

/// A part of a network: whole curves, or all junctions.
struct CurvePart {
    std::span<const std::uint32_t> vertices;
    std::span<const std::uint32_t> edges; ///< all that the vertices have
    bool are_junctions = false;           ///< whether all vertices are junctions; otherwise none is
};

/// An edge as seen from one of its ends.
struct CurveSide {
    std::uint32_t edge;
    bool is_first; ///< the end is the first vertex of the edge
};

/// A vertex between two anchors of a curve.
struct CurvePlace {
    std::uint32_t vertex;
    CurveSide before; ///< edge from it to the previous vertex, or to the first anchor
};

/// A curve: successive vertices between two anchors, which are junctions, or twice the cut of a
/// loop.
struct NetworkCurve {
    std::size_t begin;  ///< of its places
    std::size_t end;    ///< of its places; equals `begin` if an edge joins two junctions
    std::uint32_t from; ///< the anchor before the first vertex
    std::uint32_t to;   ///< the anchor after the last one
    CurveSide last;     ///< edge from the last vertex to `to`
    bool is_loop;
};

/// A network divided into curves: each runs from junction to junction, or is closed and cut at one
/// of its vertices. Between its anchors no curve depends on another, so that threads share the
/// curves. One object serves many networks, one after the other, and reuses its memory.
class CurveGraph {
public:
    /// Divides a network, which must live as long as the graph is used. O(vertices and edges).
    void begin(const CurveNetwork& network);

    [[nodiscard]] const CurveNetwork& network() const { return *network_; }
    /// Loops come last.
    [[nodiscard]] std::span<const NetworkCurve> curves() const { return curves_; }
    [[nodiscard]] std::span<const NetworkCurve> between_junctions() const {
        return curves().first(first_loop_);
    }
    /// Curve by curve.
    [[nodiscard]] std::span<const CurvePlace> places() const { return places_; }

    /// Calls `task(share)` for each share of the curves, on several threads.
    template <class Task>
    void for_each_share(const InShares& in_shares, const Task& task) const;
    /// Calls `visit(c)` for each index `c` of a curve, share by share.
    template <class Visit>
    void for_each_curve(const InShares& in_shares, const Visit& visit) const {
        for_each_share(in_shares, [&](std::size_t share) {
            for (std::size_t c = ends_[share].curves; c < ends_[share + 1].curves; ++c) {
                visit(c);
            }
        });
    }
    /// The curves in a share. No other share has any of their vertices.
    [[nodiscard]] CurvePart part(std::size_t share) const;
    /// The range of the share's curves among all curves.
    [[nodiscard]] std::pair<std::size_t, std::size_t> curves_of(std::size_t share) const {
        return {ends_[share].curves, ends_[share + 1].curves};
    }
    /// The junctions, which are in no share, with their edges in the order of the network.
    [[nodiscard]] CurvePart junctions() const { return {junctions_, arms_, true}; }
    /// Whether a vertex counts as a junction: as one of the network, or with more or fewer than two
    /// edges.
    [[nodiscard]] bool is_junction(std::uint32_t vertex) const { return number_[vertex] != no_id; }
    /// The index of a junction among all junctions.
    [[nodiscard]] std::uint32_t number(std::uint32_t junction) const { return number_[junction]; }

private:
    /// The end of a share in the lists; the next one begins there.
    struct ShareEnd {
        std::size_t curves = 0;
        std::size_t vertices = 0;
        std::size_t edges = 0;
    };

    void find_sides();
    void find_curves();
    void follow(std::uint32_t anchor, std::uint32_t edge);
    [[nodiscard]] std::uint32_t far_end(std::uint32_t edge, std::uint32_t vertex) const;
    void end_share() { ends_.push_back({curves_.size(), vertices_.size(), edges_.size()}); }
    [[nodiscard]] std::size_t shares() const { return ends_.size() - 1; }

    const CurveNetwork* network_ = nullptr;
    std::vector<std::uint32_t> degree_;                  ///< edges at each vertex
    std::vector<std::array<std::uint32_t, 2>> edges_at_; ///< of each vertex with exactly two edges
    std::vector<std::uint8_t> is_taken_;                 ///< by edge: it is part of a curve
    std::vector<NetworkCurve> curves_;
    std::size_t first_loop_ = 0;
    std::vector<CurvePlace> places_;
    std::vector<std::uint32_t> vertices_; ///< curve by curve, with the cuts of loops
    std::vector<std::uint32_t> edges_;    ///< curve by curve
    std::vector<ShareEnd> ends_; ///< ends of shares; the first entry is the begin of the first
    std::vector<std::uint32_t> junctions_;
    std::vector<std::uint32_t> number_; ///< index of the junction at a vertex, or no_id
    std::vector<std::uint32_t> arms_;   ///< edges with one or two junctions
};

template <class Task>
void CurveGraph::for_each_share(const InShares& in_shares, const Task& task) const {
    if (shares() == 1) {
        task(std::size_t{0});
    } else if (shares() > 1) {
        in_shares(shares(), std::cref(task)); // by reference: no allocation
    }
}

} // namespace dsc
