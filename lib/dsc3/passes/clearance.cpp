// SPDX-License-Identifier: MIT
#include "dsc3/passes/clearance.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/smoothing.h"
#include "dsc3/passes/pending_at_targets.h"

#include <algorithm>

namespace dsc3 {

namespace {

constexpr int ascents = 8; // steps of gradient ascent

void list_in_the_way(PassState& state) {
    const Complex& complex = state.complex;
    state.listed.clear();
    for (const std::uint32_t v : state.pending) {
        gather(complex, v, state.work.star);
        for (const Corner corner : state.work.star.corners) {
            if (quality_of(complex, tet_of(corner)) > inverted_quality) {
                continue;
            }
            for (const std::uint32_t w : complex.tets[tet_of(corner)].v) {
                const std::uint32_t flags = complex.vertices[w].flags;
                if ((flags & vertex_interface) == 0 &&
                    (state.ends_on_sides || (flags & vertex_boundary) == 0)) {
                    state.listed.push_back(w);
                }
            }
        }
    }
    std::sort(state.listed.begin(), state.listed.end());
    state.listed.erase(std::unique(state.listed.begin(), state.listed.end()), state.listed.end());
}

} // namespace

void make_way(PassState& state) {
    PendingAtTargets at_targets(state);
    list_in_the_way(state);
    for (const std::uint32_t w : state.listed) {
        gather(state.complex, w, state.work.star);
        StarQuality& star = state.work.quality;
        star.gather(state.complex, state.work.star);
        Point place = state.complex.at(w);
        const Real before = star.worst(place);
        const std::uint32_t fixed = state.complex.vertices[w].flags & vertex_boundary;
        if (raise_worst(star, before, place, ascents, fixed) > before) {
            at_targets.add(w, place);
        }
    }
}

} // namespace dsc3
