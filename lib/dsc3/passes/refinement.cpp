// SPDX-License-Identifier: MIT
#include "dsc3/passes/refinement.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_split.h"

#include <algorithm>
#include <tuple>

namespace dsc3 {

namespace {

// A tet below this quality at the targets is taken for inverted.
constexpr Real inverted_quality = 1e-4;
// Longer edges are split, in edge lengths: shorter ones would be collapsed and split in turn.
constexpr Real refined_length = 0.5;

// While it lives, the vertices that have not arrived are at their targets.
class PendingAtTargets : public dsc::Unmovable {
public:
    explicit PendingAtTargets(PassState& state) : state_(state) {
        for (const std::uint32_t v : state_.pending) {
            state_.moving[v].origin = state_.complex.at(v);
            state_.complex.vertices[v].position = state_.targets[v];
        }
    }
    ~PendingAtTargets() {
        for (const std::uint32_t v : state_.pending) {
            state_.complex.vertices[v].position = state_.moving[v].origin;
        }
    }

private:
    PassState& state_;
};

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
                complex.is_interface(Vertex{edge.b}) && gather(complex, edge, state.work.ring) &&
                !has_one_phase(complex, state.work.ring)) {
                longest = {length, edge.a, edge.b};
            }
        }
    }
    return longest;
}

// Lists the edges to be split, longest first, and where the middles of the curved edges are at the
// targets.
void find_crossings(PassState& state) {
    const PendingAtTargets at_targets(state);
    const Real shortest = refined_length * state.options.edge_length;
    auto& edges = state.too_long;
    edges.clear();
    for (const std::uint32_t v : state.pending) {
        if (!is_beside_curve(state.complex, state.work, v)) {
            continue;
        }
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
    std::sort(edges.begin(), edges.end(), [](const WantingEdge& x, const WantingEdge& y) {
        return std::tuple(y.square, x.a, x.b) < std::tuple(x.square, y.a, y.b);
    });
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const WantingEdge& x, const WantingEdge& y) {
                                return x.a == y.a && x.b == y.b;
                            }),
                edges.end());
    state.middles.clear();
    for (const WantingEdge& edge : edges) {
        state.middles.push_back(state.options.insertion(state.complex, state.work, edge.a, edge.b));
    }
}

} // namespace

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

void refine_crossings(PassState& state) {
    Complex& complex = state.complex;
    find_crossings(state);
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
}

} // namespace dsc3
