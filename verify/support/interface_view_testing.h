// SPDX-License-Identifier: MIT
// The expected contents of a view of the interface, computed from the triangles.
#pragma once

#include "dsc/algorithm/interface_sight.h"
#include "dsc/queries/phases.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dsc::test {

/// The graph of a list, in one range.
template <class Real>
void build(InterfaceGraph<Real>& graph, Complex<Real>& complex,
           const std::vector<std::uint32_t>& list) {
    graph.resize(list.size(), 1);
    graph.number(complex, list, 0);
    graph.connect(complex, 0, 0, list.size(), {});
    graph.join();
}

/// The phases to the left and to the right of each directed interface edge.
using DirectedEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<Phase, Phase>>;

template <class Real>
DirectedEdges interface_edges(const Complex<Real>& complex) {
    DirectedEdges edges;
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        for (std::uint32_t i = 0; complex.is_alive(Triangle{t}) && i < 3; ++i) {
            const Corner c = corner_of(t, i);
            if (is_interface(complex, complex.edge(c))) {
                const std::uint32_t a = complex.vertex(next(c));
                const std::uint32_t b = complex.vertex(prev(c));
                const Phase across = complex.phase_at(complex.twin(c));
                edges[{a, b}] = {complex.phase_at(c), across};
                edges[{b, a}] = {across, complex.phase_at(c)};
            }
        }
    }
    return edges;
}

/// The first error of the view; empty if it is correct. Each directed edge must start at its vertex
/// once, with the phases that it separates.
template <class Real>
std::string view_fault(const InterfaceView<Real>& view) {
    DirectedEdges missing = interface_edges(view.complex);
    std::string fault;
    const auto expect = [&](bool holds, std::size_t i, const char* what) {
        if (!holds && fault.empty()) {
            fault = "vertex " + std::to_string(view.vertices[i].id) + ": " + what;
        }
    };
    const auto leave = [&](std::size_t i, std::uint32_t to, Phase left, Phase right) {
        if (to >= view.size()) {
            expect(false, i, "a neighbour is no index");
            return;
        }
        const auto found = missing.find({view.vertices[i].id, view.vertices[to].id});
        expect(found != missing.end(), i, "an edge that does not exist, or occurs twice");
        if (found != missing.end()) {
            expect(found->second == std::pair(left, right), i, "other phases");
            missing.erase(found);
        }
    };
    for (std::size_t i = 0; i < view.size(); ++i) {
        const auto& record = view.complex.vertices[view.vertices[i].id];
        expect(view.is_on_boundary(i) == is_boundary(view.complex, view.vertices[i]), i,
               "boundary flag");
        expect(view.is_feature(i) == ((record.flags & vertex_feature) != 0), i, "feature flag");
        expect(view.is_junction(i) == (view.next[i] == no_id) &&
                   view.is_junction(i) == (view.previous[i] == no_id) &&
                   view.is_junction(i) == !arms_of(view, i).empty(),
               i, "junction flag");
        for (const InterfaceArm& arm : arms_of(view, i)) {
            leave(i, arm.neighbour, arm.left, arm.right);
        }
        if (view.is_junction(i)) {
            continue;
        }
        const Phase left = view.left[i];
        const Phase right = view.right[i];
        expect(left != border_phase && (right == border_phase || left > right), i, "sides");
        leave(i, view.next[i], left, right);
        leave(i, view.previous[i], right, left);
        if (view.next[i] < view.size() && !view.is_junction(view.next[i])) {
            expect(view.previous[view.next[i]] == i, i,
                   "is not the previous vertex of its next one");
        }
    }
    if (fault.empty() && !missing.empty()) {
        fault = "vertex " + std::to_string(missing.begin()->first.first) + ": an edge is missing";
    }
    return fault;
}

} // namespace dsc::test
