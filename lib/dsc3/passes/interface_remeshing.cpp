// SPDX-License-Identifier: MIT
#include "dsc3/passes/interface_remeshing.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_collapse.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/operations/interface_flip.h"

#include <algorithm>
#include <array>
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
    const Complex& complex = state.complex;
    const auto& thresholds = state.options.interface;
    const Real h = state.options.edge_length;
    const Real shortest = thresholds.shortest * h * (thresholds.shortest * h);
    const Real longest = thresholds.longest * h * (thresholds.longest * h);
    const auto look_at = [&](std::uint32_t v, std::uint32_t chunk, ThreadScratch& scratch) {
        gather(complex, v, scratch.star);
        gather(complex, scratch.star, scratch.interface_star);
        auto& faces = scratch.interface_star.faces;
        if (complex.is_boundary(Vertex{v})) {
            std::erase_if(faces, [](const StarFace& face) { return face.tet == border_tet; });
        }
        const auto is_seen_elsewhere = [&](std::uint32_t x) {
            return v > x && std::binary_search(vertices.begin(), vertices.end(), x);
        };
        const Point& pv = complex.at(v);
        for (const StarFace& face : faces) {
            // In a sheet each neighbour is x of one face; at a curve it may be y of all.
            const std::uint32_t y = face.y;
            if (std::any_of(faces.begin(), faces.end(),
                            [&](const StarFace& other) { return other.x == y; }) ||
                is_seen_elsewhere(y)) {
                continue;
            }
            const Real square = squared_distance(pv, complex.at(y));
            const WantingEdge edge{square, std::min(v, y), std::max(v, y)};
            if (square < shortest) {
                state.short_edges[chunk].push_back(edge);
            } else if (square > longest) {
                state.long_edges[chunk].push_back(edge);
            }
        }
        for (const StarFace& face : faces) {
            const std::uint32_t x = face.x;
            if (is_seen_elsewhere(x)) {
                continue;
            }
            const Point& px = complex.at(x);
            const Real square = squared_distance(pv, px);
            const WantingEdge edge{square, std::min(v, x), std::max(v, x)};
            if (square < shortest) {
                state.short_edges[chunk].push_back(edge);
            } else if (square > longest) {
                state.long_edges[chunk].push_back(edge);
            } else if (const StarFace* other = across(scratch.interface_star, face);
                       other != nullptr && wants_flip(pv, px, complex.at(face.y),
                                                      complex.at(other->x), FlipRules{}.slack)) {
                state.flips[chunk].push_back(edge);
            }
        }
    };
    for (auto* lists : {&state.short_edges, &state.long_edges, &state.flips}) {
        for (auto& list : *lists) {
            list.clear();
        }
    }
    constexpr std::size_t grain = 64;
    const std::uint32_t chunks = state.team.chunks(
        vertices.size(), grain,
        [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t thread) {
            for (std::size_t k = begin; k < end; ++k) {
                look_at(vertices[k], chunk, state.threads[thread]);
            }
        });
    state.too_short.clear();
    state.too_long.clear();
    state.to_flip.clear();
    append_chunks(state.too_short, state.short_edges, chunks);
    append_chunks(state.too_long, state.long_edges, chunks);
    append_chunks(state.to_flip, state.flips, chunks);
}

// By length, then by id, so that the order does not depend on that of the search.
template <class Before>
void sort(std::vector<WantingEdge>& edges, Before before) {
    std::sort(edges.begin(), edges.end(), [&](const WantingEdge& x, const WantingEdge& y) {
        return x.square != y.square ? before(x.square, y.square)
                                    : std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
}

// Edits edges in submeshes and then those that are left; `edit(work, edge)` returns a verdict. Two
// colours are enough: what they leave is little.
template <class Edit>
void edit_edges(PassState& state, std::vector<WantingEdge>& edges, Edit edit) {
    constexpr std::uint32_t colours = 2;
    if (state.submeshes != nullptr) {
        const Complex& complex = state.complex;
        const auto owner = [&](const WantingEdge& edge, std::uint32_t colour) {
            const std::array ends{edge.a, edge.b};
            return complex.is_interface(Vertex{edge.a}) && complex.is_interface(Vertex{edge.b})
                       ? state.work.rewiring.ownership->owner(ends, colour)
                       : Submeshes::done;
        };
        state.submeshes->in_colours(
            edges, colours, &SubmeshWorker::edges, owner, [&](SubmeshWorker& worker) {
                std::erase_if(worker.edges, [&](const WantingEdge& edge) {
                    return worker.submesh.free_tets.size() >= Submeshes::min_free_tets &&
                           edit(worker.work, edge) != Verdict::on_submesh_boundary;
                });
            });
        state.collect_from_submeshes();
    }
    for (const WantingEdge& edge : edges) {
        edit(state.work, edge);
    }
}

void collapse_short(PassState& state) {
    sort(state.too_short, std::less<>());
    const auto& thresholds = state.options.interface;
    const Real h = state.options.edge_length;
    const Real always = thresholds.always * h * (thresholds.always * h);
    Complex& complex = state.complex;
    edit_edges(state, state.too_short, [&](Workspace& work, const WantingEdge& edge) {
        if (!complex.is_interface(Vertex{edge.a}) || !complex.is_interface(Vertex{edge.b})) {
            return Verdict::not_a_simplex;
        }
        const CollapseRules rules{.floor = collapse_floor,
                                  .enough = collapse_enough,
                                  .deviation = edge.square < always
                                                   ? std::numeric_limits<Real>::infinity()
                                                   : thresholds.deviation * h};
        const Verdict verdict = edge_collapse(complex, work, Vertex{edge.a}, Vertex{edge.b}, rules);
        return verdict == Verdict::legal || verdict == Verdict::on_submesh_boundary
                   ? verdict
                   : edge_collapse(complex, work, Vertex{edge.b}, Vertex{edge.a}, rules);
    });
}

bool is_on_interface(const Complex& complex, const EdgeAt& edge, Ring& ring) {
    return edge.is_valid() && gather(complex, edge, ring) && !has_one_phase(complex, ring);
}

void split_long(PassState& state) {
    sort(state.too_long, std::greater<>());
    Complex& complex = state.complex;
    for (const WantingEdge& edge : state.too_long) {
        const EdgeAt at = find_edge(complex, edge.a, edge.b, state.work.star);
        if (!is_on_interface(complex, at, state.work.ring)) {
            continue;
        }
        Point place = state.options.insertion(complex, state.work, edge.a, edge.b);
        const Vertex v =
            edge_split(complex, state.work, at, midpoint(complex.at(edge.a), complex.at(edge.b)));
        if (v.is_valid()) {
            keep_on_sides(place, complex.position(v), complex.vertices[v.id].flags);
            if (!nudge(complex, state.work, v, place, insertion_quality)) {
                state.late.push_back({v.id, complex.position(v), place});
            }
        }
    }
}

void flip(PassState& state) {
    Complex& complex = state.complex;
    edit_edges(state, state.to_flip, [&](Workspace& work, const WantingEdge& edge) {
        const EdgeAt at = find_edge(complex, edge.a, edge.b, work.star);
        return at.is_valid() ? interface_flip(complex, work, at,
                                              {.cap_gap = cap_gap * state.options.edge_length})
                             : Verdict::not_a_simplex;
    });
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
