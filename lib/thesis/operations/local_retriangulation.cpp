// SPDX-License-Identifier: MIT
#include "thesis/operations/local_retriangulation.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"
#include "thesis/operations/ear_clipping.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace dsc {

namespace {

// An edge of the polygon R', with the region R on its left.
struct PolygonEdge {
    std::uint32_t from;
    std::uint32_t to;
    Corner inside; // opposite to it in the region: holds its data on the domain boundary
    Corner across; // opposite to it on the other side: holds its data otherwise
};

// The plan of a retriangulation, which the guard makes and the operation carries out.
template <class Real>
struct RetriangulationPlan {
    std::array<std::uint32_t, 3> vertex{}; // of the given triangle
    std::array<bool, 3> vanishes{};        // those inside the domain
    std::vector<std::uint32_t> region;     // the triangles of R, the given one first
    std::vector<PolygonEdge> found;        // R', sorted by `from`
    std::vector<PolygonEdge> polygon;      // R' as a loop, from the smallest vertex
    std::vector<Point<Real>> points;       // of the polygon
    EarClipping ears;
    // Scratch of the operation.
    std::vector<Corner> side;                 // beyond the edge after polygon vertex i
    std::vector<std::uint32_t> original;      // that edge's index in the polygon; no_id: a new one
    std::vector<std::array<Corner, 2>> moves; // edge data: to, from
    std::vector<Corner> fresh;                // corners of new edges
};

// One for each thread, so that the common case does not allocate.
template <class Real>
RetriangulationPlan<Real>& scratch() {
    thread_local RetriangulationPlan<Real> plan;
    return plan;
}

// R = star(closure(t)): each triangle once, at the first vertex of t that it contains.
template <class Real>
void collect_region(const Complex<Real>& complex, Triangle triangle,
                    RetriangulationPlan<Real>& plan) {
    plan.region.assign(1, triangle.id);
    for (std::uint32_t i = 0; i < 3; ++i) {
        turn(complex, plan.vertex[i], [&](Corner c) {
            const auto& v = complex.triangles[triangle_of(c)].v;
            const auto seen = [&](std::uint32_t j) {
                return std::find(v.begin(), v.end(), plan.vertex[j]) != v.end();
            };
            if (triangle_of(c) != triangle.id && !(i > 0 && seen(0)) && !(i > 1 && seen(1))) {
                plan.region.push_back(triangle_of(c));
            }
        });
    }
}

// R' = closure(R) \ R, where R does not include the domain boundary, as half-edges with R on their
// left. It is one simple polygon if one loop goes through all of them and only one half-edge leaves
// each vertex. (An edge with R on both sides is two half-edges, and no such loop contains both; and
// as the complex is a planar manifold, no vertex of R' is without an edge.)
template <class Real>
bool find_polygon(const Complex<Real>& complex, RetriangulationPlan<Real>& plan) {
    const auto in_t = [&](std::uint32_t v) {
        return v == plan.vertex[0] || v == plan.vertex[1] || v == plan.vertex[2];
    };
    auto& found = plan.found;
    found.clear();
    for (const std::uint32_t t : plan.region) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t, i);
            const Corner across = complex.twin(c);
            const std::uint32_t from = complex.vertex(next(c));
            const std::uint32_t to = complex.vertex(prev(c));
            if (is_border(across) || (!in_t(from) && !in_t(to))) {
                found.push_back({from, to, c, across});
            }
        }
    }
    const auto by_from = [](const PolygonEdge& a, const PolygonEdge& b) { return a.from < b.from; };
    std::sort(found.begin(), found.end(), by_from);
    // If several half-edges leave a vertex, this takes the first, and the loop closes without the
    // others.
    auto& polygon = plan.polygon;
    polygon.assign(1, found.front());
    while (polygon.back().to != found.front().from) {
        const PolygonEdge key{polygon.back().to, 0, 0, 0};
        const auto at = std::lower_bound(found.begin(), found.end(), key, by_from);
        if (at == found.end() || at->from != key.from || polygon.size() == found.size()) {
            return false;
        }
        polygon.push_back(*at);
    }
    return polygon.size() == found.size();
}

template <class Real>
Verdict make_plan(const Complex<Real>& complex, const Region& region, Triangle triangle,
                  RetriangulationPlan<Real>& plan) {
    if (!complex.is_alive(triangle)) {
        return Verdict::not_a_simplex;
    }
    if (!owns_triangle(complex, region, triangle.id)) {
        return Verdict::on_submesh_boundary;
    }
    plan.vertex = complex.triangles[triangle.id].v;
    bool owned = true;
    bool on_interface = false;
    bool locked = false;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const StarSummary summary = inspect(complex, region, plan.vertex[i]);
        plan.vanishes[i] = !summary.on_boundary;
        owned = owned && summary.owned;
        on_interface = on_interface || summary.interface_edges > 0;
        locked = locked || (plan.vanishes[i] && complex.is_locked(Vertex{plan.vertex[i]}));
    }
    if (!owned) {
        return Verdict::on_submesh_boundary;
    }
    if (on_interface) {
        return Verdict::on_interface;
    }
    if (locked) {
        return Verdict::locked;
    }
    collect_region(complex, triangle, plan);
    if (!find_polygon(complex, plan)) {
        return Verdict::not_a_simple_polygon;
    }
    plan.points.clear();
    for (const PolygonEdge& edge : plan.polygon) {
        plan.points.push_back(complex.position(Vertex{edge.from}));
    }
    return ear_clipping(std::span<const Point<Real>>(plan.points), plan.ears) ? Verdict::legal
                                                                              : Verdict::inverts;
}

// Edge data of the domain boundary are stored in the very triangles that are rewritten, so one
// entry may have to make room for another: they are swapped through the unused fourth entry of a
// triangle.
template <class Real>
void move_edge_data(Complex<Real>& complex, std::vector<std::array<Corner, 2>>& moves,
                    Corner spare) {
    auto& attributes = complex.attributes;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const auto [to, from] = moves[i];
        if (to == from) {
            continue;
        }
        attributes.copy_edge(spare, to);
        attributes.copy_edge(to, from);
        attributes.copy_edge(from, spare);
        for (std::size_t j = i + 1; j < moves.size(); ++j) {
            if (moves[j][1] == to) {
                moves[j][1] = from;
            }
        }
    }
    attributes.reset_edge(spare);
}

// Writes the ears into the records of the region's first triangles.
template <class Real>
void write_triangles(Complex<Real>& complex, RetriangulationPlan<Real>& plan) {
    const std::uint32_t given = plan.region.front();
    const Phase phase = complex.triangles[given].phase;
    const std::size_t n = plan.polygon.size();
    const std::size_t count = plan.ears.triangles.size();
    plan.side.clear();
    plan.original.clear();
    plan.moves.clear();
    plan.fresh.clear();
    for (std::uint32_t i = 0; i < n; ++i) {
        plan.side.push_back(plan.polygon[i].across);
        plan.original.push_back(i);
    }
    // `corner` lies opposite to the edge after polygon vertex i, as the polygon is at the moment.
    const auto attach = [&](Corner corner, std::uint32_t i) {
        rewire::link(complex, corner, plan.side[i]);
        if (plan.original[i] == no_id) {
            plan.fresh.push_back(corner);
            plan.fresh.push_back(plan.side[i]);
        } else if (is_border(plan.side[i])) {
            plan.moves.push_back({corner, plan.polygon[plan.original[i]].inside});
        }
    };
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint32_t id = plan.region[k];
        const auto [p, q, r] = plan.ears.triangles[k];
        const std::array<std::uint32_t, 3> v{plan.polygon[p].from, plan.polygon[q].from,
                                             plan.polygon[r].from};
        complex.triangles[id] = {v, {border_corner, border_corner, border_corner}, phase, 0};
        for (std::uint32_t i = 0; i < 3; ++i) {
            complex.vertices[v[i]].corner = corner_of(id, i);
        }
        attach(corner_of(id, 2), p);
        attach(corner_of(id, 0), q);
        if (k + 1 == count) {
            attach(corner_of(id, 1), r);
        }
        plan.side[p] = corner_of(id, 1);
        plan.original[p] = no_id;
    }
}

// The data of all old triangles are merged into the first, from which the new ones are then cut off
// one by one.
template <class Real>
void copy_triangle_data(Complex<Real>& complex, const RetriangulationPlan<Real>& plan) {
    auto& attributes = complex.attributes;
    if (attributes.empty(SimplexKind::triangle)) {
        return;
    }
    const std::uint32_t given = plan.region.front();
    for (std::size_t k = 1; k < plan.region.size(); ++k) {
        attributes.merge_triangle(given, plan.region[k]);
    }
    const auto size_of = [&](std::size_t k) {
        const auto& v = complex.triangles[plan.region[k]].v;
        return static_cast<double>(area<Real>(complex.position(Vertex{v[0]}),
                                              complex.position(Vertex{v[1]}),
                                              complex.position(Vertex{v[2]})));
    };
    const std::size_t count = plan.ears.triangles.size();
    double left = 0;
    for (std::size_t k = 0; k < count; ++k) {
        left += size_of(k);
    }
    for (std::size_t k = 1; k < count; ++k) {
        const double size = size_of(k);
        attributes.split_triangle(plan.region[k], given, [&] { return size / left; });
        left -= size;
    }
}

template <class Real>
void copy_edge_data(Complex<Real>& complex, RetriangulationPlan<Real>& plan) {
    if (complex.attributes.empty(SimplexKind::edge)) {
        return;
    }
    move_edge_data(complex, plan.moves, corner_of(plan.region.front(), 3));
    for (const PolygonEdge& edge : plan.polygon) {
        if (!is_border(edge.across)) {
            complex.attributes.copy_edge(complex.twin(edge.across), edge.across);
        }
    }
    for (const Corner corner : plan.fresh) {
        complex.attributes.reset_edge(corner);
    }
}

// Lawson's flips on the edges between the new triangles. The test is strict and exact, so they
// terminate.
template <class Real>
void make_delaunay(Complex<Real>& complex, EditLog& log, RetriangulationPlan<Real>& plan) {
    auto& ids = plan.region;
    ids.resize(plan.ears.triangles.size());
    std::sort(ids.begin(), ids.end());
    const auto at = [&](Corner c) { return complex.position(Vertex{complex.vertex(c)}); };
    for (bool flipped = true; flipped;) {
        flipped = false;
        for (const std::uint32_t id : ids) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(id, i);
                const Corner other = complex.twin(c);
                if (other > c && std::binary_search(ids.begin(), ids.end(), triangle_of(other)) &&
                    in_circle<Real>(at(c), at(next(c)), at(prev(c)), at(other)) > 0) {
                    rewire::flip(complex, log, c);
                    flipped = true;
                }
            }
        }
    }
}

} // namespace

template <class Real>
Verdict local_retriangulation_guard(const Complex<Real>& complex, Triangle triangle,
                                    const Region& region) {
    return make_plan(complex, region, triangle, scratch<Real>());
}

template <class Real>
RetriangulationResult detail::local_retriangulation(const Submesh<Real>& submesh, Triangle triangle,
                                                    RetriangulationMethod method) {
    Complex<Real>& complex = submesh.complex;
    RetriangulationPlan<Real>& plan = scratch<Real>();
    RetriangulationResult result;
    result.verdict = make_plan(complex, submesh.region, triangle, plan);
    if (result.verdict != Verdict::legal) {
        return result;
    }
    EditLog& log = *submesh.log;
    ++log.counts.retriangulations;
    rewire::note(log, [&] {
        return Edit{.kind = EditKind::retriangulate, .corner = corner_of(triangle.id, 0)};
    });
    write_triangles(complex, plan);
    copy_triangle_data(complex, plan);
    copy_edge_data(complex, plan);
    // n - 2 new triangles: before, there were two more for each vertex inside the polygon.
    for (std::size_t k = plan.ears.triangles.size(); k < plan.region.size(); ++k) {
        complex.give_triangle(*submesh.pool, plan.region[k]);
        ++result.triangles_removed;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (plan.vanishes[i]) {
            const Vertex vanished{plan.vertex[i]};
            complex.give_vertex(*submesh.pool, vanished.id);
            rewire::note(log,
                         [&] { return Edit{.kind = EditKind::remove_vertex, .vertex = vanished}; });
            ++result.vertices_removed;
        }
    }
    if (method == RetriangulationMethod::delaunay) {
        make_delaunay(complex, *submesh.log, plan);
    }
    rethrow_failure(submesh);
    return result;
}

template Verdict local_retriangulation_guard(const Complex<double>&, Triangle, const Region&);
template Verdict local_retriangulation_guard(const Complex<float>&, Triangle, const Region&);
template RetriangulationResult detail::local_retriangulation(const Submesh<double>&, Triangle,
                                                             RetriangulationMethod);
template RetriangulationResult detail::local_retriangulation(const Submesh<float>&, Triangle,
                                                             RetriangulationMethod);

} // namespace dsc
