// SPDX-License-Identifier: MIT
// Vertices that have not arrived yet, because another submesh must move a vertex first or because
// other vertices block them: their stars are distorted only temporarily, so edits of these stars
// are left to a later colour or pass.
#pragma once

#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

#include <algorithm>

namespace dsc {

/// Whether a vertex has yet to arrive. A vertex in contact may never arrive.
template <class Real>
bool is_waiting(const Complex<Real>& complex, std::uint32_t vertex) {
    const std::uint32_t flags = complex.vertices[vertex].flags;
    return (flags & vertex_on_way) != 0 && (flags & vertex_contact) != vertex_contact;
}

/// The stars that are not edited while one of their vertices has not arrived yet.
struct WaitingRule {
    bool in_advected_phases = false; ///< stars whose triangles must be kept
    bool everywhere = false;         ///< because fields would mix values of two times there

    [[nodiscard]] bool applies() const { return in_advected_phases || everywhere; }
};

/// The rule for a work. Stars wait only while vertices arrive: otherwise a vertex that moves half
/// of its way in each pass, because a star around it waits, would never arrive. O(attributes).
template <class Real>
WaitingRule waiting_rule(const Work<Real>& work) {
    if (work.arrived == 0 && !work.moving_vertices.empty()) {
        return {};
    }
    return {!work.options.advected_phases.empty(), work.complex.attributes.has_fields()};
}

/// Whether an owned star has to wait. O(degree).
template <class Real>
bool waits(const Work<Real>& work, const WaitingRule& rule, const Star<Real>& star) {
    const auto advects = [&](Phase phase) { return work.options.advects(phase); };
    const auto is_late = [&](std::uint32_t v) { return is_waiting(work.complex, v); };
    return (rule.everywhere ||
            std::any_of(star.phase.begin(), star.phase.begin() + star.size, advects)) &&
           (is_late(star.vertex) ||
            std::any_of(star.link.begin(), star.link.begin() + star.link_size(), is_late));
}

/// The same for the two triangles at the edge opposite to `c`, all of whose vertices are owned.
template <class Real>
bool waits_around(const Work<Real>& work, const WaitingRule& rule, Corner c) {
    const Complex<Real>& complex = work.complex;
    if (!rule.everywhere && !work.options.advects(complex.phase_at(c))) {
        return false;
    }
    const auto is_late = [&](Corner at) { return is_waiting(complex, complex.vertex(at)); };
    return is_late(c) || is_late(next(c)) || is_late(prev(c)) || is_late(complex.twin(c));
}

/// Defers a star to a later colour or, if the submesh is the whole complex, to the next pass.
template <class Real>
void deferred(Work<Real>& work, std::uint32_t vertex) {
    if (work.submesh.region.is_whole()) {
        work.resized.push_back(vertex);
    } else {
        work.deferred.star(vertex);
    }
}

} // namespace dsc
