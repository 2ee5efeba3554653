// SPDX-License-Identifier: MIT
#include "dsc/queries/embedding.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace dsc {

namespace {

// A boundary edge; its triangle lies to the left of the way from a to b.
template <class Real>
struct Segment {
    Point<Real> a;
    Point<Real> b;
    std::uint32_t a_id;
    std::uint32_t b_id;
    std::uint32_t component;

    [[nodiscard]] Real low_x() const { return std::min(a.x(), b.x()); }
    [[nodiscard]] Real high_x() const { return std::max(a.x(), b.x()); }
    [[nodiscard]] Real low_y() const { return std::min(a.y(), b.y()); }
    [[nodiscard]] Real high_y() const { return std::max(a.y(), b.y()); }
    [[nodiscard]] std::string name() const {
        return "boundary edge " + std::to_string(a_id) + "-" + std::to_string(b_id);
    }
};

// Numbers the components: triangles that are connected through edges.
template <class Real>
std::vector<std::uint32_t> label_components(const Complex<Real>& complex, std::uint64_t& count) {
    std::vector<std::uint32_t> label(complex.triangle_bound(), no_id);
    std::vector<std::uint32_t> stack;
    for (const Triangle t : triangles(complex)) {
        if (label[t.id] != no_id) {
            continue;
        }
        const auto number = static_cast<std::uint32_t>(count++);
        label[t.id] = number;
        stack.push_back(t.id);
        while (!stack.empty()) {
            const std::uint32_t at = stack.back();
            stack.pop_back();
            for (const Corner across : complex.triangles[at].n) {
                const std::uint32_t u = triangle_of(across);
                if (!is_border(across) && label[u] == no_id) {
                    label[u] = number;
                    stack.push_back(u);
                }
            }
        }
    }
    return label;
}

// The boundary edge that starts where the one opposite to `c` ends.
template <class Real>
Corner next_on_boundary(const Complex<Real>& complex, Corner c) {
    return next_along(complex, c, [&](Corner at) { return is_border(complex.twin(at)); });
}

template <class Real>
struct ComponentBoundary {
    std::vector<Segment<Real>> segments;
    std::vector<Segment<Real>> loops; ///< one segment of each loop
};

template <class Real>
ComponentBoundary<Real> collect_boundary(const Complex<Real>& complex,
                                         const std::vector<std::uint32_t>& component) {
    ComponentBoundary<Real> boundary;
    std::vector<std::uint8_t> seen(4 * std::size_t{complex.triangle_bound()}, 0);
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            Corner c = corner_of(t.id, i);
            if (!is_border(complex.twin(c)) || seen[c] != 0) {
                continue;
            }
            const std::size_t first = boundary.segments.size();
            while (seen[c] == 0) {
                seen[c] = 1;
                const Vertex a{complex.vertex(next(c))};
                const Vertex b{complex.vertex(prev(c))};
                boundary.segments.push_back(
                    {complex.position(a), complex.position(b), a.id, b.id, component[t.id]});
                c = next_on_boundary(complex, c);
            }
            boundary.loops.push_back(boundary.segments[first]);
        }
    }
    return boundary;
}

// A sweep along x. The edges of a vertical wall, which all begin at one x, are swept along y.
// Segments that share a vertex meet only there, because its half disc goes around once.
template <class Real>
std::string find_meeting(std::vector<Segment<Real>>& segments) {
    std::sort(segments.begin(), segments.end(), [](const auto& s, const auto& t) {
        return std::tuple(s.low_x(), s.low_y(), s.a_id) < std::tuple(t.low_x(), t.low_y(), t.a_id);
    });
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment<Real>& s = segments[i];
        for (std::size_t k = i + 1; k < segments.size() && segments[k].low_x() <= s.high_x(); ++k) {
            const Segment<Real>& t = segments[k];
            if (s.low_x() == s.high_x() && t.low_y() > s.high_y()) {
                break; // as all that follow at this x
            }
            const bool shares =
                s.a_id == t.a_id || s.a_id == t.b_id || s.b_id == t.a_id || s.b_id == t.b_id;
            if (shares || s.low_y() > t.high_y() || t.low_y() > s.high_y()) {
                continue;
            }
            if (segments_meet<Real>(s.a, s.b, t.a, t.b)) {
                return s.name() + " meets " + t.name() + ": the domain lies over itself";
            }
        }
    }
    return {};
}

// The winding number of the boundaries of the other components about the start of `loop`.
template <class Real>
int winding_of_others(const std::vector<Segment<Real>>& segments, const Segment<Real>& loop) {
    int winding = 0;
    const Point<Real>& p = loop.a;
    for (const Segment<Real>& s : segments) {
        if (s.component == loop.component) {
            continue;
        }
        if (s.a.y() <= p.y() && p.y() < s.b.y()) {
            winding += orientation(s.a, s.b, p) > 0 ? 1 : 0;
        } else if (s.b.y() <= p.y() && p.y() < s.a.y()) {
            winding -= orientation(s.a, s.b, p) < 0 ? 1 : 0;
        }
    }
    return winding;
}

} // namespace

template <class Real>
Embedding check_embedding(const Complex<Real>& complex) {
    Embedding result;
    const auto component = label_components(complex, result.components);
    ComponentBoundary<Real> boundary = collect_boundary(complex, component);
    result.boundary_edges = boundary.segments.size();
    result.boundary_loops = boundary.loops.size();
    result.problem = find_meeting(boundary.segments);
    if (!result.problem.empty() || result.components < 2) {
        return result;
    }
    for (const Segment<Real>& loop : boundary.loops) {
        if (winding_of_others(boundary.segments, loop) != 0) {
            result.problem = loop.name() + " lies inside another component: they overlap";
            return result;
        }
    }
    return result;
}

template Embedding check_embedding(const Complex<double>&);
template Embedding check_embedding(const Complex<float>&);

} // namespace dsc
