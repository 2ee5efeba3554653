// SPDX-License-Identifier: MIT
#include "thesis/operations/loop_subdivision.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_split.h"

namespace dsc {

namespace {

// Midpoint i lies on the edge opposite to vertex i.
template <class Real>
std::array<Point<Real>, 3> midpoints(const Complex<Real>& complex, Triangle triangle) {
    const auto [a, b, c] = complex.vertices_of(triangle);
    const auto pa = complex.position(a);
    const auto pb = complex.position(b);
    const auto pc = complex.position(c);
    return {midpoint<Real>(pb, pc), midpoint<Real>(pc, pa), midpoint<Real>(pa, pb)};
}

} // namespace

template <class Real>
Verdict loop_subdivision_guard(const Complex<Real>& complex, Triangle triangle,
                               const Region& region) {
    if (!complex.is_alive(triangle)) {
        return Verdict::not_a_simplex;
    }
    if (!owns_triangle(complex, region, triangle.id)) {
        return Verdict::on_submesh_boundary;
    }
    const auto& record = complex.triangles[triangle.id];
    for (const Corner across : record.n) {
        if (!is_border(across) && !owns_triangle(complex, region, triangle_of(across))) {
            return Verdict::on_submesh_boundary;
        }
    }
    for (const Corner across : record.n) {
        if (is_interface_pair(record.phase, complex.phase_at(across))) {
            return Verdict::on_interface;
        }
    }
    // In exact arithmetic midpoints invert nothing; rounded ones may in a thin triangle.
    const auto m = midpoints(complex, triangle);
    bool positive = orientation<Real>(m[0], m[1], m[2]) > 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = corner_of(triangle.id, i);
        const auto at = [&](Corner corner) {
            return complex.position(Vertex{complex.vertex(corner)});
        };
        positive =
            positive && orientation<Real>(at(c), m[index_of(prev(c))], m[index_of(next(c))]) > 0;
        const Corner other = complex.twin(c);
        if (!is_border(other)) {
            positive = positive && orientation<Real>(at(other), at(next(other)), m[i]) > 0 &&
                       orientation<Real>(at(other), m[i], at(prev(other))) > 0;
        }
    }
    return positive ? Verdict::legal : Verdict::inverts;
}

template <class Real>
LoopSubdivisionResult detail::loop_subdivision(const Submesh<Real>& submesh, Triangle triangle) {
    Complex<Real>& complex = submesh.complex;
    const Verdict verdict = loop_subdivision_guard(complex, triangle, submesh.region);
    if (verdict != Verdict::legal) {
        return {verdict, {}};
    }
    IdPool& pool = *submesh.pool;
    std::size_t needed = 3;
    for (const Corner across : complex.triangles[triangle.id].n) {
        needed += is_border(across) ? 0U : 1U;
    }
    if (!complex.have_ids(pool, 3, needed)) {
        return {Verdict::out_of_ids, {}};
    }
    const auto m = midpoints(complex, triangle);
    LoopSubdivisionResult result;
    const auto split = [&](Corner c, std::uint32_t i) {
        const Vertex added{complex.take_vertex(pool)};
        const std::uint32_t t2 = complex.take_triangle(pool);
        const bool border = is_border(complex.twin(c));
        const std::uint32_t u2 = border ? no_id : complex.take_triangle(pool);
        rewire::split(complex, *submesh.log, c, added.id, m[i], t2, u2);
        result.vertices[i] = added;
        return t2;
    };
    // Three splits and a flip; only the geometry of the final state was tested. rewire.h says which
    // corner a new vertex takes.
    const std::uint32_t t = triangle.id;
    const std::uint32_t r = split(corner_of(t, 0), 0);    // t = (A, B, a), r = (A, a, C)
    split(corner_of(r, 1), 1);                            // r = (b, a, C), and (a, b, A)
    split(corner_of(t, 2), 2);                            // t = (A, c, a), and (a, c, B)
    rewire::flip(complex, *submesh.log, corner_of(t, 1)); // t = (b, c, a), and (b, A, c)
    ++submesh.log->counts.subdivisions;
    rethrow_failure(submesh);
    return result;
}

template Verdict loop_subdivision_guard(const Complex<double>&, Triangle, const Region&);
template Verdict loop_subdivision_guard(const Complex<float>&, Triangle, const Region&);
template LoopSubdivisionResult detail::loop_subdivision(const Submesh<double>&, Triangle);
template LoopSubdivisionResult detail::loop_subdivision(const Submesh<float>&, Triangle);

} // namespace dsc
