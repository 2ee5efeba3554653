// SPDX-License-Identifier: MIT
#include "dsc3/passes/interface_remeshing.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_collapse.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/operations/interface_flip.h"

#include <algorithm>
#include <limits>

namespace dsc3 {

namespace {

constexpr int rounds = 4;
constexpr int collapsing_rounds = 2; // new edges of splits are not collapsed again
// Lower bound of the quality after a collapse.
constexpr Real collapse_floor = 0.05;
constexpr Real collapse_enough = 0.3;
// A new vertex moves towards its position as long as the quality of its tets stays above this.
constexpr Real insertion_quality = 0.02;
// In edge lengths: flips of caps move the interface by less.
constexpr Real cap_gap = 0.06;

// The other face of the star at the edge to `face.x`.
const StarFace* across(const InterfaceStar& interface_star, const StarFace& face) {
    const auto at = std::find_if(interface_star.faces.begin(), interface_star.faces.end(),
                                 [&](const StarFace& other) { return other.y == face.x; });
    return at == interface_star.faces.end() || at->x == face.y ? nullptr : &*at;
}

// Finds edges to be collapsed, split or flipped at these vertices; each edge is examined from its
// lower vertex.
void look(PassState& state, const std::vector<std::uint32_t>& vertices) {
    state.too_short.clear();
    state.too_long.clear();
    state.to_flip.clear();
    const Complex& complex = state.complex;
    const auto& thresholds = state.options.interface;
    const Real h = state.options.edge_length;
    const Real shortest = thresholds.shortest * h * (thresholds.shortest * h);
    const Real longest = thresholds.longest * h * (thresholds.longest * h);
    Workspace& work = state.work;
    for (const std::uint32_t v : vertices) {
        gather(complex, v, work.star);
        gather(complex, work.star, work.interface_star);
        const Point& pv = complex.at(v);
        for (const StarFace& face : work.interface_star.faces) {
            const std::uint32_t x = face.x;
            if (v > x && std::binary_search(vertices.begin(), vertices.end(), x)) {
                continue;
            }
            const Point& px = complex.at(x);
            const Real square = squared_distance(pv, px);
            const WantingEdge edge{square, std::min(v, x), std::max(v, x)};
            if (square < shortest) {
                state.too_short.push_back(edge);
            } else if (square > longest) {
                state.too_long.push_back(edge);
            } else if (const StarFace* other = across(work.interface_star, face);
                       other != nullptr && wants_flip(pv, px, complex.at(face.y),
                                                      complex.at(other->x), FlipRules{}.slack)) {
                state.to_flip.push_back(edge);
            }
        }
    }
}

// By length, then by id, so that the order does not depend on that of the search.
template <class Before>
void sort(std::vector<WantingEdge>& edges, Before before) {
    std::sort(edges.begin(), edges.end(), [&](const WantingEdge& x, const WantingEdge& y) {
        return x.square != y.square ? before(x.square, y.square)
                                    : std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
}

void collapse_short(PassState& state) {
    sort(state.too_short, std::less<>());
    const auto& thresholds = state.options.interface;
    const Real h = state.options.edge_length;
    const Real always = thresholds.always * h * (thresholds.always * h);
    for (const WantingEdge& edge : state.too_short) {
        if (!state.complex.is_interface(Vertex{edge.a}) ||
            !state.complex.is_interface(Vertex{edge.b})) {
            continue;
        }
        const CollapseRules rules{.floor = collapse_floor,
                                  .enough = collapse_enough,
                                  .deviation = edge.square < always
                                                   ? std::numeric_limits<Real>::infinity()
                                                   : thresholds.deviation * h};
        if (edge_collapse(state.complex, state.work, Vertex{edge.a}, Vertex{edge.b}, rules) !=
            Verdict::legal) {
            edge_collapse(state.complex, state.work, Vertex{edge.b}, Vertex{edge.a}, rules);
        }
    }
}

bool is_on_interface(const Complex& complex, const EdgeAt& edge, Ring& ring) {
    if (!edge.is_valid() || !gather(complex, edge, ring)) {
        return false;
    }
    return std::any_of(ring.tets.begin(), ring.tets.begin() + ring.size, [&](std::uint32_t t) {
        return complex.phases[t] != complex.phases[edge.tet];
    });
}

void split_long(PassState& state) {
    sort(state.too_long, std::greater<>());
    Complex& complex = state.complex;
    for (const WantingEdge& edge : state.too_long) {
        const EdgeAt at = find_edge(complex, edge.a, edge.b, state.work.star);
        if (!is_on_interface(complex, at, state.work.ring)) {
            continue;
        }
        const Point place = state.options.insertion(complex, state.work, edge.a, edge.b);
        const Vertex v =
            edge_split(complex, state.work, at, midpoint(complex.at(edge.a), complex.at(edge.b)));
        if (v.is_valid()) {
            nudge(complex, state.work, v, place, insertion_quality);
        }
    }
}

void flip(PassState& state) {
    for (const WantingEdge& edge : state.to_flip) {
        const EdgeAt at = find_edge(state.complex, edge.a, edge.b, state.work.star);
        if (at.is_valid()) {
            interface_flip(state.complex, state.work, at,
                           {.cap_gap = cap_gap * state.options.edge_length});
        }
    }
}

// Finds the interface vertices of the tets written since `first`, by ascending id.
void find_around(PassState& state, std::size_t first) {
    auto& around = state.around;
    around.clear();
    const auto& changed = state.work.rewiring.changed;
    for (std::size_t i = first; i < changed.size(); ++i) {
        if (state.complex.is_alive(Tet{changed[i]})) {
            for (const std::uint32_t v : state.complex.tets[changed[i]].v) {
                if (state.complex.is_interface(Vertex{v})) {
                    around.push_back(v);
                }
            }
        }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
}

} // namespace

void remesh_interface(PassState& state) {
    state.update_interface();
    auto& changed = state.work.rewiring.changed;
    changed.clear();
    look(state, state.interface);
    for (int round = 0; round < rounds; ++round) {
        const std::size_t first = changed.size();
        if (round < collapsing_rounds) {
            collapse_short(state);
        }
        split_long(state);
        flip(state);
        if (changed.size() == first) {
            break;
        }
        find_around(state, first);
        look(state, state.around);
    }
    state.collect_unfit(state.options.quality);
    state.update_interface();
    state.grow();
}

} // namespace dsc3
