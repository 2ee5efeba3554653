// SPDX-License-Identifier: MIT
#include "dsc3/passes/refinement.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/passes/pending_at_targets.h"

#include <algorithm>
#include <functional>

namespace dsc3 {

namespace {

// Longer edges are split, in edge lengths: shorter ones would be collapsed and split in turn.
constexpr Real refined_length = 0.5;
// Where a curved edge of a sheet is farther from its middle, in lengths of the edge, the sheet is
// not resolved: a vertex there could lie beyond another sheet, and wait for it to pass.
constexpr Real largest_bend = 0.03;

// The longest edge of a tet that is on the interface and longer than the root of `square`; its ends
// are `no_id` if there is none.
WantingEdge longest_on_interface(PassState& state, std::uint32_t t, Real square) {
    const Complex& complex = state.complex;
    const auto& v = complex.tets[t].v;
    WantingEdge longest{square, no_id, no_id};
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            const EdgeAt edge{t, std::min(v[i], v[j]), std::max(v[i], v[j])};
            const Real length = squared_distance(complex.at(edge.a), complex.at(edge.b));
            if (length > longest.square && complex.is_interface(Vertex{edge.a}) &&
                complex.is_interface(Vertex{edge.b}) &&
                is_on_interface(complex, edge, state.work.ring)) {
                longest = {length, edge.a, edge.b};
            }
        }
    }
    return longest;
}

// Whether a vertex of the interface has one of a junction curve, or itself, in its star, which the
// workspace then holds. O(degree^2).
bool is_beside_curve(const Complex& complex, Workspace& work, std::uint32_t v) {
    gather(complex, v, work.star);
    work.star.met.clear();
    return std::any_of(work.star.corners.begin(), work.star.corners.end(), [&](Corner corner) {
        const auto& of_tet = complex.tets[tet_of(corner)].v;
        return std::any_of(of_tet.begin(), of_tet.end(), [&](std::uint32_t w) {
            return work.star.met.enter(w) && is_off_sheets(complex, work, w);
        });
    });
}

Point middle_of(PassState& state, const WantingEdge& edge) {
    const Complex& complex = state.complex;
    const Point& a = complex.at(edge.a);
    const Point& b = complex.at(edge.b);
    const Point place = state.options.insertion(complex, state.work, edge.a, edge.b);
    const Point middle = midpoint(a, b);
    const bool is_resolved =
        (place - middle).norm() <= largest_bend * (b - a).norm() ||
        (is_off_sheets(complex, state.work, edge.a) && is_off_sheets(complex, state.work, edge.b));
    return is_resolved ? place : middle;
}

// Lists the edges to be split, longest first, and where the middles of the curved edges are at the
// targets. Returns false if no pending vertex is beside a curve.
bool find_crossings(PassState& state) {
    const PendingAtTargets at_targets(state);
    const Real shortest = refined_length * state.options.edge_length;
    auto& edges = state.too_long;
    edges.clear();
    bool is_any_beside_curve = false;
    for (const std::uint32_t v : state.pending) {
        if (!is_beside_curve(state.complex, state.work, v)) {
            continue;
        }
        is_any_beside_curve = true;
        for (const Corner corner : state.work.star.corners) {
            if (quality_of(state.complex, tet_of(corner)) <= inverted_quality) {
                const WantingEdge edge =
                    longest_on_interface(state, tet_of(corner), shortest * shortest);
                if (edge.a != no_id) {
                    edges.push_back(edge);
                }
            }
        }
    }
    sort_once(edges, std::greater<>());
    state.middles.clear();
    for (const WantingEdge& edge : edges) {
        state.middles.push_back(middle_of(state, edge));
    }
    return is_any_beside_curve;
}

} // namespace

bool refine_crossings(PassState& state) {
    Complex& complex = state.complex;
    if (!find_crossings(state)) {
        return false;
    }
    state.work.rewiring.changed.clear();
    for (std::size_t k = 0; k < state.too_long.size(); ++k) {
        const WantingEdge& edge = state.too_long[k];
        const EdgeAt at = find_edge(complex, edge.a, edge.b, state.work.star);
        if (!at.is_valid()) {
            continue;
        }
        const Vertex v =
            edge_split(complex, state.work, at, midpoint(complex.at(edge.a), complex.at(edge.b)));
        if (v.is_valid()) {
            state.grow();
            state.targets[v.id] = state.middles[k];
            keep_on_sides(state.targets[v.id], complex.position(v), complex.vertices[v.id].flags);
            state.pending.push_back(v.id);
        }
    }
    state.collect_unfit(state.options.quality);
    return true;
}

} // namespace dsc3
