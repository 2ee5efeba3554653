// SPDX-License-Identifier: MIT
#include "dsc3/passes/worst_tets.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_collapse.h"
#include "dsc3/operations/smoothing.h"
#include "dsc3/passes/repair.h"

#include <algorithm>
#include <tuple>

namespace dsc3 {

namespace {

constexpr int worst_rounds = 2;
// Tets around a worst tet are improved if their quality is below this.
constexpr Real quality_around = 0.3;
// Lengths are in edge lengths.
constexpr Real short_interface_edge = 0.6;
constexpr Real longest_move = 0.15;
constexpr Real deviation = 0.02;
constexpr Real turn_cos = 0.5;
// A little more than is needed, so that the next step finds nothing to do.
constexpr Real aim = 1.3 * worst_tet_quality;

bool is_bad(const Complex& complex, std::uint32_t t) {
    return complex.is_alive(Tet{t}) && quality_of(complex, t) < worst_tet_quality;
}

bool is_in_wedge(PassState& state, const TetRecord& tet) {
    return std::any_of(tet.v.begin(), tet.v.end(), [&](std::uint32_t v) {
        return is_off_sheets(state.complex, state.work, v);
    });
}

// Repairs the tets around its vertices inside a phase, though they are better than mesh repair
// demands, to make room for the tet. Returns whether it is good enough then.
bool repair_around(PassState& state, std::uint32_t t) {
    const TetRecord tet = state.complex.tets[t];
    for (const std::uint32_t v : tet.v) {
        if (state.complex.is_interface(Vertex{v})) {
            continue;
        }
        gather(state.complex, v, state.work.star);
        for (const Corner corner : state.work.star.corners) {
            if (quality_of(state.complex, tet_of(corner)) < quality_around) {
                state.unfit.push_back(tet_of(corner));
            }
        }
    }
    repair_mesh(state, quality_around, Effort::more);
    return !is_bad(state.complex, t);
}

bool collapse(PassState& state, const TetRecord& tet) {
    const Real h = state.options.edge_length;
    std::vector<WantingEdge>& edges = state.too_short;
    edges.clear();
    for (const std::uint32_t a : tet.v) {
        for (const std::uint32_t b : tet.v) {
            const Real square = squared_distance(state.complex.at(a), state.complex.at(b));
            if (a != b && square < short_interface_edge * h * (short_interface_edge * h) &&
                state.complex.is_interface(Vertex{a}) && state.complex.is_interface(Vertex{b})) {
                edges.push_back({square, a, b});
            }
        }
    }
    std::sort(edges.begin(), edges.end(), [](const WantingEdge& x, const WantingEdge& y) {
        return std::tie(x.square, x.a, x.b) < std::tie(y.square, y.a, y.b);
    });
    const CollapseRules rules{.floor = worst_tet_quality,
                              .enough = worst_tet_quality,
                              .min_cos = turn_cos,
                              .deviation = deviation * h};
    return std::any_of(edges.begin(), edges.end(), [&](const WantingEdge& edge) {
        return edge_collapse(state.complex, state.work, Vertex{edge.a}, Vertex{edge.b}, rules) ==
               Verdict::legal;
    });
}

bool move(PassState& state, std::uint32_t t) {
    const TetRecord tet = state.complex.tets[t];
    const Real h = state.options.edge_length;
    const AlongRules rules{.enough = aim, .farthest = longest_move * h, .deviation = deviation * h};
    bool done = false;
    for (const std::uint32_t v : tet.v) {
        done |=
            is_bad(state.complex, t) &&
            smooth_along_interface(state.complex, state.work, Vertex{v}, rules) == Verdict::legal;
    }
    return done;
}

} // namespace

void improve_worst_tets(PassState& state, WorstTets which) {
    for (int round = 0; round < worst_rounds && !state.unimproved.empty(); ++round) {
        auto& worst = state.worst;
        worst.clear();
        for (const std::uint32_t t : state.unimproved) {
            if (is_bad(state.complex, t)) {
                worst.emplace_back(quality_of(state.complex, t), t);
            }
        }
        std::sort(worst.begin(), worst.end());
        worst.erase(std::unique(worst.begin(), worst.end()), worst.end());
        state.unimproved.clear();
        for (const auto& [quality, t] : worst) {
            if (!is_bad(state.complex, t)) {
                continue;
            }
            if ((which == WorstTets::off_curves && is_in_wedge(state, state.complex.tets[t])) ||
                repair_around(state, t)) {
                continue;
            }
            state.work.rewiring.changed.clear();
            if (collapse(state, state.complex.tets[t]) || move(state, t)) {
                state.collect_unfit(state.options.quality);
                repair_mesh(state, state.options.quality, Effort::more);
                state.unimproved.push_back(t);
            }
        }
    }
    state.unimproved.clear();
}

} // namespace dsc3
