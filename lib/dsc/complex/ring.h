// SPDX-License-Identifier: MIT
// The star of one vertex, gathered once: the link's coordinates in small padded arrays, so that
// quality, move limit, lengths and Delaunay tests run on all lanes at once. Only min and max are
// reduced across lanes; the result does not depend on their order.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/submesh.h"

#include <algorithm>

namespace dsc {

/// The star of a vertex, with room for a degree of `capacity`.
template <class Real>
struct Ring {
    static constexpr std::uint32_t lanes = 8;     ///< padding; a multiple of every vector width
    static constexpr std::uint32_t capacity = 56; ///< the largest degree that fits
    static constexpr std::uint32_t room = capacity + 2 * lanes; ///< of each array: with the padding

    std::uint32_t vertex = no_id; ///< its id
    std::uint32_t size = 0;       ///< triangles of the star
    bool closed = false;          ///< false: the vertex is on the domain boundary
    bool one_phase = false;       ///< all triangles have the same phase
    bool owned = true;            ///< all vertices of the link, and the centre, lie in the region
    Real x0 = 0;                  ///< the centre
    Real y0 = 0;

    // Triangle i is the centre, (x, y)[i] and (x_next, y_next)[i], counter-clockwise; the padding
    // repeats triangle 0. These are the link vertices i and i + 1; link[size] closes the ring, or
    // is the last vertex of an open one. Spoke 0 of an open ring has no predecessor: its
    // (x_previous, y_previous) is link vertex 0 itself. Neighbours are stored rather than shuffled:
    // a vector load that spans two recent stores has to wait for both.
    alignas(64) std::array<Real, room> x;          ///< link vertex i
    alignas(64) std::array<Real, room> y;          ///< link vertex i
    alignas(64) std::array<Real, room> x_next;     ///< link vertex i + 1
    alignas(64) std::array<Real, room> y_next;     ///< link vertex i + 1
    alignas(64) std::array<Real, room> x_previous; ///< link vertex i - 1
    alignas(64) std::array<Real, room> y_previous; ///< link vertex i - 1
    std::array<std::uint32_t, room> link;          ///< ids of the link's vertices
    std::array<Corner, room> corner;               ///< of the centre in triangle i
    std::array<Phase, room> phase;                 ///< of triangle i

    /// The size rounded up to whole lanes.
    [[nodiscard]] std::uint32_t padded() const { return (size + lanes - 1) / lanes * lanes; }
    /// Vertices of the link.
    [[nodiscard]] std::uint32_t link_size() const { return closed ? size : size + 1; }
    /// The x coordinate of link vertex i; also of the last one of an open star.
    [[nodiscard]] Real link_x(std::uint32_t i) const { return i < size ? x[i] : x_next[size - 1]; }
    /// The y coordinate of link vertex i; also of the last one of an open star.
    [[nodiscard]] Real link_y(std::uint32_t i) const { return i < size ? y[i] : y_next[size - 1]; }
    /// The phase between link vertex i - 1 and i (that is, clockwise of spoke i).
    [[nodiscard]] Phase phase_before(std::uint32_t i) const {
        return i > 0 ? phase[i - 1] : (closed ? phase[size - 1] : border_phase);
    }
    /// The phase between link vertex i and i + 1 (counter-clockwise of spoke i).
    [[nodiscard]] Phase phase_after(std::uint32_t i) const {
        return i < size ? phase[i] : border_phase;
    }
    /// Spoke i separates two phases, or the domain from the outside.
    [[nodiscard]] bool is_constrained(std::uint32_t i) const {
        return phase_before(i) != phase_after(i);
    }
};

namespace detail {

/// How a star is tested for ownership while it is walked.
enum class Owned : std::uint8_t {
    surely,  ///< the region is the whole mesh
    upright, ///< an axis-aligned box: the extent of the star is kept, which costs almost nothing
    tested,  ///< any other region: vertex by vertex
};

template <Owned how, class Real>
class Ownership {
public:
    explicit Ownership(const Region& region) : region_(region) {}

    void show([[maybe_unused]] std::uint32_t vertex, [[maybe_unused]] Real x,
              [[maybe_unused]] Real y) {
        if constexpr (how == Owned::upright) {
            left_ = std::min(left_, x);
            right_ = std::max(right_, x);
            bottom_ = std::min(bottom_, y);
            top_ = std::max(top_, y);
        } else if constexpr (how == Owned::tested) {
            owns_ = owns_ && region_.owns(vertex, static_cast<double>(x), static_cast<double>(y));
        }
    }
    [[nodiscard]] bool owns_all() const {
        if constexpr (how == Owned::upright) {
            return (region_.low <= static_cast<double>(left_)) &
                   (static_cast<double>(right_) < region_.high) &
                   (region_.side_low <= static_cast<double>(bottom_)) &
                   (static_cast<double>(top_) < region_.side_high);
        }
        return owns_;
    }

private:
    static constexpr Real most = std::numeric_limits<Real>::max();

    const Region& region_;
    bool owns_ = true;
    Real left_ = most;
    Real right_ = -most;
    Real bottom_ = most;
    Real top_ = -most;
};

template <Owned how, class Real>
bool gather_star(const Complex<Real>& complex, const Region& region, std::uint32_t vertex,
                 Ring<Real>& ring) {
    const auto& centre = complex.vertices[vertex];
    ring.vertex = vertex;
    ring.owned = true;
    const auto* triangles = complex.triangles.data();
    const auto* vertices = complex.vertices.data();
    constexpr bool is_whole = how == Owned::surely;
    const auto read = [](const Real& value) {
        if constexpr (is_whole) {
            return value;
        } else {
            return read_shared(value);
        }
    };
    ring.x0 = read(centre.x);
    ring.y0 = read(centre.y);
    if constexpr (!is_whole) {
        if (!region.owns(vertex, static_cast<double>(ring.x0), static_cast<double>(ring.y0))) {
            // Another submesh may be rewriting this star: it must not be walked.
            ring.owned = false;
            return false;
        }
    }
    const Corner start = centre.corner;
    if (start == no_id) {
        return false;
    }
    Ownership<how, Real> ownership(region);
    const auto put = [&](std::uint32_t i, std::uint32_t id) {
        const auto& record = vertices[id];
        const Real x = read(record.x);
        const Real y = read(record.y);
        ownership.show(id, x, y);
        ring.link[i] = id;
        ring.x[i] = x;
        ring.y[i] = y;
        ring.x_previous[i + 1] = x;
        ring.y_previous[i + 1] = y;
        if (i > 0) {
            ring.x_next[i - 1] = x;
            ring.y_next[i - 1] = y;
        }
    };

    // Not `circulate`: most stars are closed, so this starts at once and starts again if it reaches
    // the end of the domain, and it reads each triangle's record once.
    Corner first = start;
    std::uint32_t n = 0;
    Corner c = start;
    Phase differing = 0;
    bool closed = true;
    while (true) {
        const auto& record = triangles[triangle_of(c)];
        const std::uint32_t i1 = index_of(next(c));
        ring.corner[n] = c;
        ring.phase[n] = record.phase;
        differing |= record.phase ^ ring.phase[0];
        put(n, record.v[i1]);
        ++n;
        const Corner across = record.n[i1];
        if (is_border(across)) {
            if (closed) {
                // The domain ends here: begin again from the clockwise end.
                closed = false;
                first = first_corner(complex, start);
                if (first != start) {
                    n = 0;
                    differing = 0;
                    c = first;
                    continue;
                }
            }
            put(n, record.v[index_of(prev(c))]);
            break;
        }
        c = next(across);
        if (c == first) {
            break;
        }
        if (n >= Ring<Real>::capacity) {
            return false;
        }
    }
    ring.size = n;
    ring.closed = closed;
    ring.one_phase = differing == 0;
    if (closed) {
        ring.link[n] = ring.link[0];
        ring.x[n] = ring.x[0];
        ring.y[n] = ring.y[0];
        ring.x_next[n - 1] = ring.x[0];
        ring.y_next[n - 1] = ring.y[0];
    }
    ring.x_previous[0] = ring.x[closed ? n - 1 : 0];
    ring.y_previous[0] = ring.y[closed ? n - 1 : 0];
    for (std::uint32_t i = n; i < ring.padded(); ++i) {
        ring.x[i] = ring.x[0];
        ring.y[i] = ring.y[0];
        ring.x_next[i] = ring.x_next[0];
        ring.y_next[i] = ring.y_next[0];
        ring.x_previous[i] = ring.x_previous[0];
        ring.y_previous[i] = ring.y_previous[0];
    }
    ring.owned = ownership.owns_all();
    return true;
}

} // namespace detail

/// Gathers the star of `vertex`, counter-clockwise; an open star from its clockwise end. Returns
/// false if it has more triangles than fit, or none, or if the region does not own the centre (then
/// `owned` is false and nothing was read). O(degree).
template <class Real>
bool gather(const Complex<Real>& complex, const Region& region, std::uint32_t vertex,
            Ring<Real>& ring) {
    using detail::Owned;
    if (region.is_whole()) {
        return detail::gather_star<Owned::surely>(complex, region, vertex, ring);
    }
    return region.is_upright() ? detail::gather_star<Owned::upright>(complex, region, vertex, ring)
                               : detail::gather_star<Owned::tested>(complex, region, vertex, ring);
}

} // namespace dsc
