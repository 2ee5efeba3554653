// SPDX-License-Identifier: MIT
#include "geometric_flows/curve_graph.h"

#include "geometric_flows/curve_network.h"

#include <algorithm>

namespace dsc {

namespace {

/// More shares than most machines have cores: curves, and with them shares, differ in length.
constexpr std::size_t max_shares = 8;
/// The smallest number of vertices in a share: about ten microseconds of work.
constexpr std::size_t min_of_share = 256;

} // namespace

void CurveGraph::begin(const CurveNetwork& network) {
    network_ = &network;
    for (auto* list : {&junctions_, &arms_, &vertices_, &edges_}) {
        list->clear();
    }
    curves_.clear();
    places_.clear();
    ends_.clear();
    find_sides();
    find_curves();
}

// A vertex with more or fewer than two edges counts as a junction.
void CurveGraph::find_sides() {
    const std::size_t n = network_->positions.size();
    degree_.assign(n, 0);
    edges_at_.assign(n, {no_id, no_id});
    for (std::uint32_t e = 0; e < network_->edges.size(); ++e) {
        for (const std::uint32_t v : {network_->edges[e].from, network_->edges[e].to}) {
            if (degree_[v] < 2) {
                edges_at_[v][degree_[v]] = e;
            }
            ++degree_[v];
        }
    }
    number_.assign(n, no_id);
    for (std::uint32_t v = 0; v < n; ++v) {
        if (network_->is_junction[v] != 0 || degree_[v] != 2) {
            number_[v] = static_cast<std::uint32_t>(junctions_.size());
            junctions_.push_back(v);
        }
    }
}

void CurveGraph::find_curves() {
    places_.reserve(number_.size() - junctions_.size());
    end_share(); // where the first one begins
    is_taken_.assign(network_->edges.size(), 0);
    for (std::uint32_t e = 0; e < network_->edges.size(); ++e) {
        const CurveEdge& edge = network_->edges[e];
        const bool starts = is_junction(edge.from);
        const bool ends = is_junction(edge.to);
        if (starts || ends) {
            arms_.push_back(e);
        }
        if ((starts || ends) && is_taken_[e] == 0) {
            follow(starts ? edge.from : edge.to, e);
        }
    }
    first_loop_ = curves_.size();
    for (std::uint32_t e = 0; e < network_->edges.size(); ++e) {
        if (is_taken_[e] == 0) {
            follow(network_->edges[e].from, e);
        }
    }
    if (ends_.back().curves < curves_.size()) {
        end_share();
    }
}

std::uint32_t CurveGraph::far_end(std::uint32_t edge, std::uint32_t vertex) const {
    const CurveEdge& e = network_->edges[edge];
    return e.from == vertex ? e.to : e.from;
}

// Follows the curve that starts at the anchor with this edge, to its other anchor. Ends the share
// after the curve if the share has enough vertices.
void CurveGraph::follow(std::uint32_t anchor, std::uint32_t edge) {
    NetworkCurve curve{.begin = places_.size(),
                       .end = 0,
                       .from = anchor,
                       .to = anchor,
                       .last = {},
                       .is_loop = !is_junction(anchor)};
    if (curve.is_loop) {
        vertices_.push_back(anchor);
    }
    std::uint32_t last = anchor;
    std::uint32_t v = far_end(edge, anchor);
    for (; !is_junction(v) && v != anchor; v = far_end(edge, v)) {
        is_taken_[edge] = 1;
        places_.push_back({.vertex = v, .before = {edge, network_->edges[edge].from == v}});
        vertices_.push_back(v);
        edges_.push_back(edge);
        edge = edges_at_[v][edges_at_[v][0] == edge ? 1 : 0];
        last = v;
    }
    is_taken_[edge] = 1;
    edges_.push_back(edge);
    curve.end = places_.size();
    curve.to = v;
    curve.last = {edge, network_->edges[edge].from == last};
    curves_.push_back(curve);
    const std::size_t enough =
        std::max(min_of_share, (number_.size() - junctions_.size()) / max_shares + 1);
    if (vertices_.size() - ends_.back().vertices >= enough) {
        end_share();
    }
}

CurvePart CurveGraph::part(std::size_t share) const {
    const ShareEnd& begin = ends_[share];
    const ShareEnd& end = ends_[share + 1];
    return {{vertices_.data() + begin.vertices, vertices_.data() + end.vertices},
            {edges_.data() + begin.edges, edges_.data() + end.edges},
            false};
}

} // namespace dsc
