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
// Junction curves keep their vertices longer than sheets, by this factor of the deviation: where
// the flow has pressed a curve flat, a new vertex cannot be put to its place again.
constexpr Real of_curves = 0.05;
// In edge lengths: flips of caps move the interface by less.
constexpr Real cap_gap = 0.06;

// The vertex opposite to the edge (a, b) in the other face of the interface beside a tet, which has
// the face (a, b, c) of the interface; `no_id` if the interface ends there on a side.
std::uint32_t opposite(const Complex& complex, Corner corner, std::uint32_t c) {
    const Phase phase = complex.phase_at(corner);
    std::uint32_t at = tet_of(corner);
    std::uint32_t next = complex.vertex(corner);
    for (;;) {
        const TetRecord& tet = complex.tets[at];
        const Corner other = tet.n[index_in(tet, c)];
        if (is_border(other)) {
            return no_id;
        }
        if (complex.phase_at(other) != phase) {
            return next;
        }
        at = tet_of(other);
        c = next;
        next = complex.vertex(other);
    }
}

// Which edges of the interface are examined at a tet.
enum class Sight : std::uint8_t {
    once, // each edge at one of the tets around it, at least, if all tets are visited
    all,
};

// Finds edges to be collapsed, split or flipped at the faces of a tet.
void look_at(PassState& state, std::uint32_t t, std::uint32_t chunk, Sight sight) {
    const Complex& complex = state.complex;
    const auto& thresholds = state.options.interface;
    const Real h = state.options.edge_length;
    const Real shortest = thresholds.shortest * h * (thresholds.shortest * h);
    const Real longest = thresholds.longest * h * (thresholds.longest * h);
    const TetRecord& tet = complex.tets[t];
    for (std::uint32_t i = 0; i < 4; ++i) {
        const Phase beyond = complex.phase_at(tet.n[i]);
        if (beyond == complex.phases[t] || is_border(tet.n[i]) ||
            (sight == Sight::once && beyond > complex.phases[t])) {
            continue;
        }
        const auto face = complex.face(corner_of(t, i));
        for (std::uint32_t j = 0; j < 3; ++j) {
            const std::uint32_t a = face[j];
            const std::uint32_t b = face[(j + 1) % 3];
            // The phase rises and falls around an edge, so two of its faces have opposite
            // orientations; but an edge on a side may have one face.
            if (sight == Sight::once && a > b && complex.fixed_along(a, b) == 0) {
                continue;
            }
            const Point& pa = complex.at(a);
            const Point& pb = complex.at(b);
            const Real square = squared_distance(pa, pb);
            const WantingEdge edge{square, std::min(a, b), std::max(a, b)};
            if (square < shortest) {
                state.short_edges[chunk].push_back(edge);
            } else if (square > longest) {
                state.long_edges[chunk].push_back(edge);
            } else {
                const std::uint32_t c = face[(j + 2) % 3];
                const std::uint32_t d = opposite(complex, corner_of(t, i), c);
                if (d != no_id &&
                    wants_flip(pa, pb, complex.at(c), complex.at(d), FlipRules{}.slack)) {
                    state.flips[chunk].push_back(edge);
                }
            }
        }
    }
}

// Looks at the tets `tet(k)`, k < n.
template <class Tets>
void look(PassState& state, std::size_t n, Tets tet, Sight sight) {
    for (auto* lists : {&state.short_edges, &state.long_edges, &state.flips}) {
        for (auto& list : *lists) {
            list.clear();
        }
    }
    constexpr std::size_t grain = 1024;
    const std::uint32_t chunks = state.team.chunks(
        n, grain, [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t) {
            for (std::size_t k = begin; k < end; ++k) {
                if (state.complex.is_alive(Tet{tet(k)})) {
                    look_at(state, tet(k), chunk, sight);
                }
            }
        });
    state.too_short.clear();
    state.too_long.clear();
    state.to_flip.clear();
    append_chunks(state.too_short, state.short_edges, chunks);
    append_chunks(state.too_long, state.long_edges, chunks);
    append_chunks(state.to_flip, state.flips, chunks);
    sort_once(state.too_short, std::less<>());
    sort_once(state.too_long, std::greater<>());
    sort_once(state.to_flip, std::less<>());
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
        const auto edit_owned = [&](SubmeshWorker& worker, Workspace& work) {
            std::erase_if(worker.edges, [&](const WantingEdge& edge) {
                return worker.submesh.free_tets.size() >= Submeshes::min_free_tets &&
                       edit(work, edge) != Verdict::on_submesh_boundary;
            });
        };
        state.submeshes->in_colours(edges, colours, &SubmeshWorker::edges, owner, edit_owned);
        state.collect_from_submeshes();
    }
    for (const WantingEdge& edge : edges) {
        edit(state.work, edge);
    }
}

void collapse_short(PassState& state) {
    const auto& thresholds = state.options.interface;
    const Real h = state.options.edge_length;
    const Real always = thresholds.always * h * (thresholds.always * h);
    Complex& complex = state.complex;
    edit_edges(state, state.too_short, [&](Workspace& work, const WantingEdge& edge) {
        if (!complex.is_interface(Vertex{edge.a}) || !complex.is_interface(Vertex{edge.b})) {
            return Verdict::not_a_simplex;
        }
        const Real deviation =
            edge.square < always ? std::numeric_limits<Real>::infinity() : thresholds.deviation * h;
        const CollapseRules rules{.floor = collapse_floor,
                                  .enough = collapse_enough,
                                  .deviation = deviation,
                                  .curve_deviation = of_curves * deviation};
        const Verdict verdict = edge_collapse(complex, work, Vertex{edge.a}, Vertex{edge.b}, rules);
        return verdict == Verdict::legal || verdict == Verdict::on_submesh_boundary
                   ? verdict
                   : edge_collapse(complex, work, Vertex{edge.b}, Vertex{edge.a}, rules);
    });
}

// While it lives, late vertices are where they should be, so that all are at the same time: between
// late vertices, the middle to which the flow has carried an edge is not where its middle is now.
class AtTargets {
public:
    explicit AtTargets(PassState& state)
        : complex_(state.complex), late_(state.late), entries_(state.threads[0].places) {
        for (std::size_t k = 0; k < late_.size(); ++k) {
            enter(k);
        }
    }
    AtTargets(const AtTargets&) = delete;
    AtTargets& operator=(const AtTargets&) = delete;
    ~AtTargets() {
        for (const LateVertex& one : late_) {
            complex_.vertices[one.vertex].position = one.place;
        }
    }

    void add(const LateVertex& one) {
        late_.push_back(one);
        enter(late_.size() - 1);
    }
    // Moves the late ones of the vertices of the tets around an edge to their places, or back.
    void move(const EdgeAt& edge, const Ring& ring, Point LateVertex::*to) {
        move(edge.a, to);
        move(edge.b, to);
        for (std::uint32_t i = 0; i < ring.size + (ring.closed ? 0 : 1); ++i) {
            move(ring.vertices[i], to);
        }
    }

private:
    void enter(std::size_t k) {
        const LateVertex& one = late_[k];
        if (one.vertex >= entries_.size()) {
            entries_.resize(complex_.vertex_bound());
        }
        entries_[one.vertex] = static_cast<std::uint32_t>(k);
        complex_.vertices[one.vertex].position = one.target;
    }
    void move(std::uint32_t v, Point LateVertex::*to) {
        // An entry is valid if the list confirms it.
        if (v < entries_.size() && entries_[v] < late_.size() && late_[entries_[v]].vertex == v) {
            complex_.vertices[v].position = late_[entries_[v]].*to;
        }
    }

    Complex& complex_;
    std::vector<LateVertex>& late_;
    std::vector<std::uint32_t>& entries_; ///< by vertex
};

void split_long(PassState& state) {
    if (state.too_long.empty()) {
        return;
    }
    Complex& complex = state.complex;
    Ring& ring = state.work.ring;
    state.drop_stale_late();
    AtTargets late(state);
    for (const WantingEdge& edge : state.too_long) {
        const EdgeAt at = find_edge(complex, edge.a, edge.b, state.work.star);
        if (!is_on_interface(complex, at, ring)) {
            continue;
        }
        Point place = state.options.insertion(complex, state.work, edge.a, edge.b);
        (void)gather(complex, at, ring); // the insertion may use it
        late.move(at, ring, &LateVertex::place);
        const Vertex v =
            edge_split(complex, state.work, at, midpoint(complex.at(edge.a), complex.at(edge.b)));
        bool arrives = true;
        if (v.is_valid()) {
            keep_on_sides(place, complex.position(v), complex.vertices[v.id].flags);
            arrives = nudge(complex, state.work, v, place, insertion_quality);
        }
        late.move(at, ring, &LateVertex::target);
        if (!arrives) {
            late.add({v.id, complex.position(v), place});
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

// Looks at all faces of the interface.
void look(PassState& state) {
    if (state.is_dense(state.interface.size())) {
        const auto same = [](std::size_t k) { return static_cast<std::uint32_t>(k); };
        look(state, state.complex.tets.size(), same, Sight::once);
        return;
    }
    auto& beside = state.beside;
    beside.clear();
    for (const std::uint32_t v : state.interface) {
        gather(state.complex, v, state.work.star);
        for (const Corner corner : state.work.star.corners) {
            beside.push_back(tet_of(corner));
        }
    }
    look(
        state, beside.size(), [&](std::size_t k) { return beside[k]; }, Sight::once);
}

} // namespace

void remesh_interface(PassState& state) {
    state.update_interface();
    auto& changed = state.work.rewiring.changed;
    changed.clear();
    look(state);
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
        look(
            state, changed.size() - first, [&](std::size_t k) { return changed[first + k]; },
            Sight::all);
    }
    state.collect_unfit(state.options.quality);
    state.update_interface();
    state.grow();
}

} // namespace dsc3
