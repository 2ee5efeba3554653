// SPDX-License-Identifier: MIT
#include "dsc3/passes/arrival.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_collapse.h"
#include "dsc3/passes/clearance.h"
#include "dsc3/passes/movement.h"
#include "dsc3/passes/refinement.h"
#include "dsc3/passes/repair.h"
#include "dsc3/passes/worst_tets.h"

#include <algorithm>

namespace dsc3 {

namespace {

constexpr int patient_passes = 2; // later passes use more effort and lower thresholds
constexpr int refine_after = 3;   // passes
constexpr int unjam_after = 4;    // passes
// If a blocked vertex is beside a junction curve: before that, refinement may free it.
constexpr int unjam_at_curves_after = 8;
// Tets around a vertex that has not arrived are improved if their quality is below this.
constexpr Real blocking_quality = 0.35;
// The quality threshold of movement falls by this factor in each pass, down to this minimum.
constexpr Real move_factor = 0.3;
constexpr Real min_move = 1e-5;
// Interface edges at blocked vertices are collapsed if they are shorter than this, in edge lengths.
constexpr Real unjam_length = 0.8;
constexpr CollapseRules unjam_rules{.floor = 1e-4, .enough = 0.02, .min_cos = 0.3};
// Along junction curves, in edge lengths.
constexpr Real curve_deviation = 0.005;

// Lists the tets around vertices that have not arrived.
void list_blocking(PassState& state) {
    for (auto& list : state.lists) {
        list.clear();
    }
    constexpr std::size_t grain = 64;
    const std::uint32_t chunks = state.team.chunks(
        state.pending.size(), grain,
        [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t thread) {
            Star& star = state.threads[thread].star;
            for (std::size_t k = begin; k < end; ++k) {
                gather(state.complex, state.pending[k], star);
                for (const Corner corner : star.corners) {
                    if (quality_of(state.complex, tet_of(corner)) < blocking_quality) {
                        state.lists[chunk].push_back(tet_of(corner));
                    }
                }
            }
        });
    append_chunks(state.unfit, state.lists, chunks);
}

void unjam(PassState& state) {
    const Real h = state.options.edge_length;
    const Real length = unjam_length * h;
    CollapseRules rules = unjam_rules;
    rules.curve_deviation = curve_deviation * h;
    rules.longest_on_curve = state.options.interface.longest * h; // longer ones are split again
    state.work.rewiring.changed.clear();
    std::vector<WantingEdge>& edges = state.too_short;
    for (const std::uint32_t v : state.pending) {
        if (!state.complex.is_interface(Vertex{v})) {
            continue;
        }
        gather(state.complex, v, state.work.star);
        gather(state.complex, state.work.star, state.work.interface_star);
        edges.clear();
        for (const StarFace& face : state.work.interface_star.faces) {
            const Real square = squared_distance(state.complex.at(v), state.complex.at(face.x));
            if (square < length * length) {
                edges.push_back({square, v, face.x});
            }
        }
        std::sort(edges.begin(), edges.end(), [](const WantingEdge& x, const WantingEdge& y) {
            return x.square != y.square ? x.square < y.square : x.b < y.b;
        });
        for (const WantingEdge& edge : edges) {
            if (edge_collapse(state.complex, state.work, Vertex{v}, Vertex{edge.b}, rules) ==
                Verdict::legal) {
                ++state.unjammed;
                break;
            }
        }
    }
    state.collect_unfit(state.options.quality);
}

void drop_vanished(PassState& state) {
    std::erase_if(state.pending,
                  [&](std::uint32_t v) { return !state.complex.is_interface(Vertex{v}); });
}

} // namespace

std::uint32_t arrive(PassState& state) {
    Real move_quality = state.options.move_quality;
    std::uint32_t passes = 0;
    for (int pass = 0; pass < state.options.max_passes && !state.pending.empty(); ++pass) {
        ++passes;
        if (pass > refine_after) {
            make_way(state);
        }
        move_vertices(state, move_quality);
        list_blocking(state);
        const Effort effort = pass < patient_passes ? Effort::usual : Effort::more;
        repair_mesh(state, state.options.quality, effort);
        drop_vanished(state);
        if (pass >= refine_after && !state.pending.empty()) {
            const bool refined = pass < unjam_at_curves_after && refine_crossings(state);
            if (!refined && pass >= unjam_after) {
                unjam(state);
            }
            repair_mesh(state, state.options.quality, Effort::more);
            drop_vanished(state);
        }
        if (pass >= patient_passes) {
            move_quality = std::max(move_factor * move_quality, min_move);
        }
    }
    if (state.pending.empty()) {
        improve_worst_tets(state, WorstTets::off_curves);
    }
    state.unimproved.clear(); // beside late vertices the interface is not where it should be
    drop_vanished(state);
    return passes;
}

} // namespace dsc3
