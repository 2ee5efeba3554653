// SPDX-License-Identifier: MIT
// The star of one vertex, gathered once into small padded arrays of the link's coordinates, so that
// quality, move limit, lengths and Delaunay tests run on all lanes at once. Only min and max are
// reduced across lanes; the result does not depend on their order.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/records.h"
#include "dsc/complex/submesh.h"

#include <array>
#include <bit>
#include <cstdint>

namespace dsc {

/// The star of a vertex, with room for a degree of `capacity`.
template <class Real>
struct Star {
    static constexpr std::uint32_t lanes = 8;     ///< padding; a multiple of every vector width
    static constexpr std::uint32_t capacity = 56; ///< the largest degree that fits
    static constexpr std::uint32_t room = capacity + 2 * lanes; ///< of each array: with the padding

    std::uint32_t vertex = no_id; ///< its id
    std::uint32_t size = 0;       ///< triangles of the star
    bool closed = false;          ///< false: the vertex is on the domain boundary
    bool one_phase = false;       ///< all triangles have the same phase
    std::uint64_t changes = 0;    ///< bit i: triangle i is of another phase than the one before it
    bool owned = true;            ///< all vertices of the link, and the centre, lie in the region
    Real x0 = 0;                  ///< the centre
    Real y0 = 0;

    // Triangle i is the centre, (x, y)[i] and (x_next, y_next)[i], counter-clockwise; the padding
    // repeats triangle 0. These are the link vertices i and i + 1; link[size] closes the star, or
    // is the last vertex of an open one. Incident edge 0 of an open star has no predecessor: its
    // (x_previous, y_previous) is link vertex 0 itself. The coordinates of neighbours are stored
    // rather than shuffled, because a vector load that spans two recent stores has to wait for
    // both.
    alignas(64) std::array<Real, room> x;          ///< link vertex i
    alignas(64) std::array<Real, room> y;          ///< link vertex i
    alignas(64) std::array<Real, room> x_next;     ///< link vertex i + 1
    alignas(64) std::array<Real, room> y_next;     ///< link vertex i + 1
    alignas(64) std::array<Real, room> x_previous; ///< link vertex i - 1
    alignas(64) std::array<Real, room> y_previous; ///< link vertex i - 1
    std::array<std::uint32_t, room> link;          ///< ids of the link's vertices
    std::array<Corner, room> corner;               ///< corner of the centre in triangle i
    std::array<Phase, room> phase;                 ///< of triangle i

    /// The size rounded up to whole lanes.
    [[nodiscard]] std::uint32_t padded() const { return (size + lanes - 1) / lanes * lanes; }
    /// Vertices of the link.
    [[nodiscard]] std::uint32_t link_size() const { return closed ? size : size + 1; }
    /// The x coordinate of link vertex i; also of the last one of an open star.
    [[nodiscard]] Real link_x(std::uint32_t i) const { return i < size ? x[i] : x_next[size - 1]; }
    /// The y coordinate of link vertex i; also of the last one of an open star.
    [[nodiscard]] Real link_y(std::uint32_t i) const { return i < size ? y[i] : y_next[size - 1]; }
    /// The squared length of incident edge i.
    [[nodiscard]] Real squared_edge(std::uint32_t i) const {
        const Real dx = link_x(i) - x0;
        const Real dy = link_y(i) - y0;
        return dx * dx + dy * dy;
    }
    /// The phase between link vertex i - 1 and i (that is, clockwise of incident edge i).
    [[nodiscard]] Phase phase_before(std::uint32_t i) const {
        return i > 0 ? phase[i - 1] : (closed ? phase[size - 1] : border_phase);
    }
    /// The phase between link vertex i and i + 1 (counter-clockwise of incident edge i).
    [[nodiscard]] Phase phase_after(std::uint32_t i) const {
        return i < size ? phase[i] : border_phase;
    }
    /// Incident edge i separates two phases, or the domain from the outside.
    [[nodiscard]] bool is_constrained(std::uint32_t i) const {
        return phase_before(i) != phase_after(i);
    }
};

/// The incident interface edges of a star; more than two make a junction.
struct IncidentEdges {
    std::uint32_t count = 0;  ///< how many there are
    std::uint32_t first = 0;  ///< counter-clockwise from incident edge 0; if count > 0
    std::uint32_t second = 0; ///< the last one where there are more than two; if count > 1

    /// The other one of the two incident edges.
    [[nodiscard]] std::uint32_t other(std::uint32_t incident_edge) const {
        return first == incident_edge ? second : first;
    }
};

/// The incident edges whose two sides differ in phase. O(degree).
template <class Real>
IncidentEdges interface_edges_of(const Star<Real>& star) {
    IncidentEdges incident;
    if (star.closed) {
        const std::uint64_t rest = star.changes & (star.changes - 1);
        if (rest == 0) {
            return incident; // round a closed star the phase changes at least twice, or not at all
        }
        if ((rest & (rest - 1)) == 0) {
            return {2, static_cast<std::uint32_t>(std::countr_zero(star.changes)),
                    static_cast<std::uint32_t>(std::countr_zero(rest))};
        }
    }
    const std::uint32_t n = star.link_size();
    Phase before = star.phase_before(0);
    for (std::uint32_t i = 0; i < n; ++i) {
        const Phase after = star.phase_after(i);
        if (before != after && is_interface_pair(before, after)) {
            (incident.count == 0 ? incident.first : incident.second) = i;
            ++incident.count;
        }
        before = after;
    }
    return incident;
}

/// Where link vertex i is; also the last one of an open star.
template <class Real>
Point<Real> link_point(const Star<Real>& star, std::uint32_t i) {
    return {star.link_x(i), star.link_y(i)};
}

namespace detail {

// Half of a step's memory loads happen here, and a quarter of its instructions. So the walk writes
// each vertex once from registers into every row that needs it, and stars are filled up to whole
// lanes without a loop.

/// The kind of region, which decides how a star is tested for ownership.
enum class Owned : std::uint8_t {
    surely,  ///< the region is the whole mesh
    upright, ///< an axis-aligned box: by the bounds of the link
    tested,  ///< any other region: vertex by vertex
};

/// The smallest axis-aligned box around the star. It is updated in registers while the link is
/// walked, because reading the rows of the star would have to wait for the stores that fill them.
template <class Real>
struct Bounds {
    Real x_low; ///< of the centre at first
    Real x_high;
    Real y_low;
    Real y_high;

    void add(Real x, Real y) {
        x_low = x < x_low ? x : x_low;
        x_high = x > x_high ? x : x_high;
        y_low = y < y_low ? y : y_low;
        y_high = y > y_high ? y : y_high;
    }
    /// Whether an upright box owns the whole star. Combines flags, because branches take longer.
    [[nodiscard]] bool lie_in(const Region& box) const {
        return (box.low <= static_cast<double>(x_low)) & (static_cast<double>(x_high) < box.high) &
               (box.side_low <= static_cast<double>(y_low)) &
               (static_cast<double>(y_high) < box.side_high);
    }
};

/// Fills in a `Star`, triangle by triangle, counter-clockwise.
template <Owned how, class Real>
class StarWriter {
public:
    StarWriter(const Complex<Real>& complex, const Region& region, Star<Real>& star)
        : triangles_(complex.triangles.data()), vertices_(complex.vertices.data()), star_(star),
          region_(region), bounds_{star.x0, star.x0, star.y0, star.y0} {}

    static Real read(const Real& value) {
        if constexpr (how == Owned::surely) {
            return value;
        } else {
            return read_shared(value);
        }
    }

    /// Writes triangle i with its first link vertex. The walk enters it through the edge opposite
    /// to `entrance`, its corner before the centre's. Returns the entrance of the next triangle.
    Corner write(std::size_t i, Corner entrance) {
        const TriangleRecord& triangle = triangles_[triangle_of(entrance)];
        const std::uint32_t exit =
            preceding_index[index_of(entrance)]; // the corner after the centre's
        star_.corner[i] = next(entrance);
        star_.phase[i] = triangle.phase;
        if (i == 0) {
            phase_ = triangle.phase;
        }
        changes_ |= static_cast<std::uint64_t>(triangle.phase != phase_) << i;
        phase_ = triangle.phase;
        write_vertex(i, triangle.v[exit]);
        return triangle.n[exit];
    }

    /// Writes link vertex i.
    void write_vertex(std::size_t i, std::uint32_t id) {
        const auto& record = vertices_[id];
        const Real x = read(record.x);
        const Real y = read(record.y);
        if constexpr (how == Owned::tested) {
            owns_ = owns_ && region_.owns(id, static_cast<double>(x), static_cast<double>(y));
        } else if constexpr (how == Owned::upright) {
            bounds_.add(x, y);
        }
        star_.link[i] = id;
        star_.x[i] = x;
        star_.y[i] = y;
        star_.x_previous[i + 1] = x;
        star_.y_previous[i + 1] = y;
        if (i > 0) {
            star_.x_next[i - 1] = x;
            star_.y_next[i - 1] = y;
        }
    }

    /// Ends a star of n triangles: closes the star, and repeats triangle 0 behind it. Inlined, so
    /// that the compiler keeps the writer in registers during the walk.
    [[gnu::always_inline]] void finish(std::size_t n, bool closed) {
        Star<Real>& r = star_;
        r.size = static_cast<std::uint32_t>(n);
        r.closed = closed;
        r.one_phase = changes_ == 0;
        r.changes = changes_ | static_cast<std::uint64_t>(closed && r.phase[0] != phase_);
        const Real x = r.x[0];
        const Real y = r.y[0];
        if (closed) {
            r.link[n] = r.link[0];
            r.x_next[n - 1] = x;
            r.y_next[n - 1] = y;
        }
        const Real x_previous = r.x[closed ? n - 1 : 0];
        const Real y_previous = r.y[closed ? n - 1 : 0];
        r.x_previous[0] = x_previous;
        r.y_previous[0] = y_previous;
        // Writes always eight lanes, usually more than the padding needs, but without a loop.
        fill(r.x, n, x);
        fill(r.y, n, y);
        fill(r.x_next, n, r.x_next[0]);
        fill(r.y_next, n, r.y_next[0]);
        fill(r.x_previous, n, x_previous);
        fill(r.y_previous, n, y_previous);
        if constexpr (how == Owned::upright) {
            owns_ = bounds_.lie_in(region_);
        }
        r.owned = owns_;
    }

private:
    /// `prev_index` by a table: a load of one byte instead of a comparison and a selection.
    static constexpr std::array<std::uint8_t, 4> preceding_index{2, 0, 1, 0};

    static void fill(std::array<Real, Star<Real>::room>& row, std::size_t from, Real value) {
        Real* out = row.data() + from;
        for (std::size_t i = 0; i < Star<Real>::lanes; ++i) {
            out[i] = value;
        }
    }

    const TriangleRecord* triangles_;
    const VertexRecord<Real>* vertices_;
    Star<Real>& star_;
    const Region& region_;
    Bounds<Real> bounds_; // unused unless the region is an upright box
    bool owns_ = true;
    Phase phase_ = 0;
    std::uint64_t changes_ = 0;
};

/// Gathers an open star, from its first triangle to its last. Returns false if it does not fit.
template <Owned how, class Real>
[[gnu::noinline]] bool gather_open_star(const Complex<Real>& complex, const Region& region,
                                        Corner start, Star<Real>& star) {
    StarWriter<how, Real> writer(complex, region, star);
    Corner entrance = prev(first_corner(complex, start));
    for (std::size_t i = 0; i < Star<Real>::capacity; ++i) {
        const Corner across = writer.write(i, entrance);
        if (is_border(across)) {
            const Corner c = star.corner[i];
            writer.write_vertex(i + 1, complex.vertex(prev(c)));
            writer.finish(i + 1, false);
            return true;
        }
        entrance = across;
    }
    return false;
}

template <Owned how, class Real>
bool gather_star(const Complex<Real>& complex, const Region& region, std::uint32_t vertex,
                 Star<Real>& star) {
    using Writer = StarWriter<how, Real>;
    const auto& centre = complex.vertices[vertex];
    star.vertex = vertex;
    star.owned = true;
    star.x0 = Writer::read(centre.x);
    star.y0 = Writer::read(centre.y);
    if constexpr (how != Owned::surely) {
        const double x0 = static_cast<double>(star.x0);
        const double y0 = static_cast<double>(star.y0);
        const bool is_owned =
            how == Owned::upright ? region.is_inside(x0, y0) : region.owns(vertex, x0, y0);
        if (!is_owned) {
            // Another submesh may be rewriting this star: it must not be walked.
            star.owned = false;
            return false;
        }
    }
    const Corner start = centre.corner;
    if (start == no_id) {
        return false;
    }
    // Not `circulate`: nearly all stars are closed, so the walk begins anywhere, reads the record
    // of each triangle once, and begins again only if the domain ends on the way.
    Writer writer(complex, region, star);
    const Corner first = prev(start);
    Corner entrance = writer.write(0, first);
    std::size_t n = 1;
    while (entrance != first) {
        if (is_border(entrance)) {
            return gather_open_star<how>(complex, region, start, star);
        }
        if (n >= Star<Real>::capacity) {
            return false;
        }
        entrance = writer.write(n, entrance);
        ++n;
    }
    writer.finish(n, true);
    return true;
}

} // namespace detail

/// Gathers the star of `vertex`, counter-clockwise; an open star from its clockwise end. Returns
/// false if it has more triangles than fit, or none, or if the region does not own the centre (then
/// `owned` is false and nothing was read). O(degree).
template <class Real>
bool gather(const Complex<Real>& complex, const Region& region, std::uint32_t vertex,
            Star<Real>& star) {
    using detail::Owned;
    if (region.is_whole()) {
        return detail::gather_star<Owned::surely>(complex, region, vertex, star);
    }
    return region.kind == Region::Kind::upright
               ? detail::gather_star<Owned::upright>(complex, region, vertex, star)
               : detail::gather_star<Owned::tested>(complex, region, vertex, star);
}

} // namespace dsc
