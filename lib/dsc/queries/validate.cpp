// SPDX-License-Identifier: MIT
#include "dsc/queries/validate.h"

#include "dsc/base/error.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/embedding.h"

#include <cmath>
#include <vector>

namespace dsc {

namespace {

// Each check returns a fault in words, or nothing.
using Problem = std::string;

std::string name(const char* kind, std::uint32_t id) {
    return std::string(kind) + " " + std::to_string(id);
}

template <class Real>
std::string name_vertex(const Complex<Real>& complex, std::uint32_t v) {
    return name("vertex", v) + " at " + to_text(complex.position(Vertex{v}));
}

std::string name_corner(Corner c) {
    return "triangle " + std::to_string(triangle_of(c)) + ", corner " + std::to_string(index_of(c));
}

template <class Real>
std::string name_triangle(const Complex<Real>& complex, std::uint32_t t) {
    const auto& v = complex.triangles[t].v;
    return name("triangle", t) + " (" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
           std::to_string(v[2]) + ")";
}

template <class Real>
Problem check_border(const Complex<Real>& complex) {
    if (complex.triangles.empty()) {
        return "triangle 0, the border, is missing";
    }
    const TriangleRecord& border = complex.triangles[border_triangle];
    if (border.phase != border_phase) {
        return "triangle 0, the border: its phase is " + std::to_string(border.phase) +
               " instead of the reserved one";
    }
    if (border.v != std::array<std::uint32_t, 3>{0, 0, 0} ||
        border.n != std::array<Corner, 3>{border_corner, border_corner, border_corner}) {
        return "triangle 0, the border: its record was overwritten";
    }
    return {};
}

template <class Real>
Problem check_attributes(const Complex<Real>& complex) {
    for (const auto& attribute : complex.attributes.list()) {
        const std::size_t expected = AttributeSet::entries(
            attribute->kind(), complex.vertices.size(), complex.triangles.size());
        const std::size_t size = attribute->size();
        if (size != expected) {
            return "attribute '" + attribute->name() + "': it has " + std::to_string(size) +
                   " entries instead of " + std::to_string(expected);
        }
    }
    return {};
}

template <class Real>
bool is_corner_of_living(const Complex<Real>& complex, Corner c) {
    return index_of(c) < 3 && complex.is_alive(Triangle{triangle_of(c)});
}

template <class Real>
Problem check_vertices(const Complex<Real>& complex, ValidationReport& report) {
    for (const Vertex v : vertices(complex)) {
        const auto& record = complex.vertices[v.id];
        ++report.vertices;
        if (!std::isfinite(record.x) || !std::isfinite(record.y)) {
            return name_vertex(complex, v.id) + ": a coordinate is not finite";
        }
        if (record.corner == no_id) {
            ++report.unused_vertices;
            continue;
        }
        if (!is_corner_of_living(complex, record.corner)) {
            return name_vertex(complex, v.id) + ": its corner (" + name_corner(record.corner) +
                   ") is not alive";
        }
        if (complex.vertex(record.corner) != v.id) {
            return name_vertex(complex, v.id) + ": its corner (" + name_corner(record.corner) +
                   ") is at vertex " + std::to_string(complex.vertex(record.corner));
        }
    }
    return {};
}

template <class Real>
Problem check_link(const Complex<Real>& complex, Corner c) {
    const Corner across = complex.twin(c);
    if (is_border(across)) {
        return {};
    }
    if (!is_corner_of_living(complex, across)) {
        return name_corner(c) + ": its neighbour (" + name_corner(across) + ") is not alive";
    }
    if (triangle_of(across) == triangle_of(c)) {
        return name_corner(c) + ": the triangle is its own neighbour";
    }
    if (complex.twin(across) != c) {
        return name_corner(c) + ": its neighbour (" + name_corner(across) +
               ") does not link back to it";
    }
    if (complex.vertex(next(c)) != complex.vertex(prev(across)) ||
        complex.vertex(prev(c)) != complex.vertex(next(across))) {
        return name_corner(c) + ": it and its neighbour (" + name_corner(across) +
               ") do not name the same two vertices, in opposite order";
    }
    return {};
}

template <class Real>
Problem check_corners(const Complex<Real>& complex, std::uint32_t t) {
    const auto& v = complex.triangles[t].v;
    for (const std::uint32_t id : v) {
        if (!complex.is_alive(Vertex{id})) {
            return name_triangle(complex, t) + ": vertex " + std::to_string(id) + " is not alive";
        }
        if (complex.vertices[id].corner == no_id) {
            return name_vertex(complex, id) + ": it has no corner but is a vertex of " +
                   name_triangle(complex, t);
        }
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
        return name_triangle(complex, t) + ": a vertex is named twice";
    }
    if (complex.triangles[t].phase == border_phase) {
        return name_triangle(complex, t) + ": its phase is the one reserved for the border";
    }
    return {};
}

template <class Real>
Problem check_links(const Complex<Real>& complex, std::uint32_t t) {
    Problem problem;
    for (std::uint32_t i = 0; i < 3 && problem.empty(); ++i) {
        problem = check_link(complex, corner_of(t, i));
    }
    return problem;
}

template <class Real>
Problem check_orientation(const Complex<Real>& complex, std::uint32_t t) {
    const auto [a, b, c] = complex.positions_of(Triangle{t});
    const int sign = orientation<Real>(a, b, c);
    if (sign > 0) {
        return {};
    }
    return name_triangle(complex, t) + (sign == 0 ? ": it is degenerate" : ": it is inverted");
}

// Each check runs over all triangles before the next check, because a bad vertex also breaks the
// links of its triangle's neighbours and must be reported first.
template <class Real, class Check>
Problem check_triangles(const Complex<Real>& complex, Check check) {
    for (const Triangle t : triangles(complex)) {
        if (Problem problem = check(t.id); !problem.empty()) {
            return problem;
        }
    }
    return {};
}

// The pools, lent ones included, hold exactly the dead ids.
template <class IsAlive>
Problem check_pools(const char* kind, const FreeIds& ids,
                    std::vector<std::uint32_t> IdPool::*of_kind, std::uint32_t first,
                    std::uint32_t bound, IsAlive is_alive) {
    std::vector<std::uint32_t> all = ids.*of_kind;
    for (const IdPool& pool : ids.lent) {
        all.insert(all.end(), (pool.*of_kind).begin(), (pool.*of_kind).end());
    }
    std::vector<std::uint8_t> listed(bound, 0);
    for (const std::uint32_t id : all) {
        if (id < first || id >= bound) {
            return std::string("free ") + name(kind, id) + ": the id is out of range";
        }
        if (is_alive(id)) {
            return std::string("free ") + name(kind, id) + ": it is alive, or in use";
        }
        if (listed[id] != 0) {
            return std::string("free ") + name(kind, id) + ": it is free twice";
        }
        listed[id] = 1;
    }
    for (std::uint32_t id = first; id < bound; ++id) {
        if (!is_alive(id) && listed[id] == 0) {
            return name(kind, id) + ": it is dead, but not free";
        }
    }
    return {};
}

// A direction counts as upper from 0 (included) to 180 degrees. Comparisons only, hence exact.
template <class Real>
bool is_upper(const Point<Real>& centre, const Point<Real>& p) {
    return p.y() > centre.y() || (p.y() == centre.y() && p.x() > centre.x());
}

// Rotates about v; terminates because the links are known to be correct. `expected` is the number
// of triangles that name v.
template <class Real>
Problem check_fan(const Complex<Real>& complex, std::uint32_t v, std::uint32_t expected) {
    const Corner first = first_corner(complex, complex.vertices[v].corner);
    const bool closed = !is_border(corner_cw(complex, first));
    const Point<Real> centre = complex.position(Vertex{v});
    const Point<Real> begin = complex.position(Vertex{complex.vertex(next(first))});
    std::uint32_t met = 0;
    std::uint32_t rounds = 0;  // of a closed fan: how many times it passes direction 0
    bool begins_again = false; // an open fan that returns to its beginning
    circulate(complex, first, [&](Corner c) {
        ++met;
        const Point<Real> from = complex.position(Vertex{complex.vertex(next(c))});
        const Point<Real> to = complex.position(Vertex{complex.vertex(prev(c))});
        rounds += !is_upper(centre, from) && is_upper(centre, to) ? 1U : 0U;
        begins_again =
            begins_again || (met > 1 && !closed && orientation(centre, from, begin) > 0 &&
                             orientation(centre, begin, to) >= 0);
    });
    if (met != expected) {
        return name_vertex(complex, v) + ": it is not manifold: " + std::to_string(expected) +
               " triangles name it, rotating about it meets " + std::to_string(met);
    }
    if ((closed && rounds != 1) || begins_again) {
        return name_vertex(complex, v) + ": the triangles go around it more than once";
    }
    return {};
}

template <class Real>
Problem check_fans(const Complex<Real>& complex) {
    std::vector<std::uint32_t> named(complex.vertex_bound(), 0);
    for (const Triangle t : triangles(complex)) {
        for (std::size_t i = 0; i < 3; ++i) {
            ++named[complex.triangles[t.id].v[i]];
        }
    }
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (named[v] != 0) {
            if (Problem problem = check_fan(complex, v, named[v]); !problem.empty()) {
                return problem;
            }
        }
    }
    return {};
}

template <class Real>
Problem find_problem(const Complex<Real>& complex, ValidationReport& report) {
    Problem problem = check_border(complex);
    const auto then = [&](auto check) {
        if (problem.empty()) {
            problem = check();
        }
    };
    then([&] { return check_attributes(complex); });
    then([&] { return check_vertices(complex, report); });
    const auto each_triangle = [&](auto check) {
        then([&] { return check_triangles(complex, check); });
    };
    each_triangle([&](std::uint32_t t) {
        ++report.triangles;
        return check_corners(complex, t);
    });
    each_triangle([&](std::uint32_t t) { return check_links(complex, t); });
    each_triangle([&](std::uint32_t t) { return check_orientation(complex, t); });
    then([&] {
        return check_pools("vertex", complex.ids, &IdPool::vertices, 0, complex.vertex_bound(),
                           [&](std::uint32_t id) { return complex.is_alive(Vertex{id}); });
    });
    then([&] {
        return check_pools("triangle", complex.ids, &IdPool::triangles, 1, complex.triangle_bound(),
                           [&](std::uint32_t id) { return complex.is_alive(Triangle{id}); });
    });
    then([&] { return check_fans(complex); });
    then([&] { return find_overlap(complex, report); });
    return problem;
}

} // namespace

template <class Real>
ValidationReport validate(const Complex<Real>& complex) {
    ValidationReport report;
    report.problem = find_problem(complex, report);
    return report;
}

template <class Real>
void validate_or_throw(const Complex<Real>& complex) {
    const ValidationReport report = validate(complex);
    if (!report.ok()) {
        throw InvariantError("the complex is not valid: " + report.problem);
    }
}

template ValidationReport validate(const Complex<double>&);
template ValidationReport validate(const Complex<float>&);
template void validate_or_throw(const Complex<double>&);
template void validate_or_throw(const Complex<float>&);

} // namespace dsc
