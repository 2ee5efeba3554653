// SPDX-License-Identifier: MIT
#include "dsc/complex/complex.h"

#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/rewire.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace dsc {

namespace {

struct Keyed {
    std::uint64_t key;
    std::uint32_t id;
};

// Maps the living vertices to the grid; both axes by the same factor, so that cells are squares.
template <class Real>
class Grid {
public:
    explicit Grid(const Complex<Real>& complex) {
        const auto [low, high] = bounds_of(complex);
        low_ = low.template cast<double>();
        // Coordinates are halved, so that an extent near the largest double does not overflow.
        const double half = (high.template cast<double>() / 2 - low_ / 2).maxCoeff();
        scale_ = half > 0 ? 0.5 * cells / half : 0;
    }
    [[nodiscard]] std::uint64_t key(const Point<Real>& p) const {
        return hilbert_index(cell(static_cast<double>(p.x()), low_.x()),
                             cell(static_cast<double>(p.y()), low_.y()));
    }

private:
    static constexpr double cells = 4294967295.0;

    [[nodiscard]] std::uint32_t cell(double value, double low) const {
        // Also covers inf * 0 for extents that are subnormal or overflow.
        const double at = (value / 2 - low / 2) * scale_ * 2;
        return at > 0 ? static_cast<std::uint32_t>(std::min(at, cells)) : 0;
    }

    Point<double> low_;
    double scale_ = 0;
};

// The old ids of the living vertices in their new order.
template <class Real>
std::vector<std::uint32_t> order_vertices(const Complex<Real>& complex) {
    const Grid<Real> grid(complex);
    std::vector<Keyed> keyed;
    keyed.reserve(complex.vertex_count());
    for (const Vertex v : vertices(complex)) {
        keyed.push_back({grid.key(complex.position(v)), v.id});
    }
    std::sort(keyed.begin(), keyed.end(), [&](const Keyed& a, const Keyed& b) {
        if (a.key != b.key) {
            return a.key < b.key;
        }
        const auto& p = complex.vertices[a.id];
        const auto& q = complex.vertices[b.id];
        return std::tie(p.x, p.y, a.id) < std::tie(q.x, q.y, b.id);
    });
    std::vector<std::uint32_t> order;
    order.reserve(keyed.size());
    for (const Keyed& k : keyed) {
        order.push_back(k.id);
    }
    return order;
}

// The old ids of the border and the living triangles in their new order: bucketed by their smallest
// vertex, then sorted within each bucket. Vertices already have their new ids.
template <class Real>
std::vector<std::uint32_t> order_triangles(const Complex<Real>& complex) {
    const auto smallest = [&](std::uint32_t t) {
        const auto& v = complex.triangles[t].v;
        return std::min({v[0], v[1], v[2]});
    };
    std::vector<std::uint32_t> begin(complex.vertices.size() + 1, 0);
    for (const Triangle t : triangles(complex)) {
        ++begin[smallest(t.id) + 1];
    }
    for (std::size_t v = 1; v < begin.size(); ++v) {
        begin[v] += begin[v - 1];
    }
    std::vector<std::uint32_t> order(1 + std::size_t{begin.back()}, border_triangle);
    for (const Triangle t : triangles(complex)) {
        order[1 + begin[smallest(t.id)]++] = t.id; // begin[v] ends as the end of bucket v
    }
    const auto sorted = [&](std::uint32_t t) {
        auto v = complex.triangles[t].v;
        std::sort(v.begin(), v.end());
        return v;
    };
    std::uint32_t from = 0;
    for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
        std::sort(order.begin() + 1 + from, order.begin() + 1 + begin[v],
                  [&](std::uint32_t a, std::uint32_t b) { return sorted(a) < sorted(b); });
        from = begin[v];
    }
    return order;
}

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& order, std::size_t size) {
    std::vector<std::uint32_t> result(size, no_id);
    for (std::size_t i = 0; i < order.size(); ++i) {
        result[order[i]] = static_cast<std::uint32_t>(i);
    }
    return result;
}

// Entry i becomes the old entry order[i], cycle by cycle and in place; old entries not in `order`
// are dropped. Uses up `order`.
template <class Record>
void permute(std::vector<Record>& records, std::vector<std::uint32_t>& order,
             const std::vector<std::uint32_t>& new_of_old) {
    const std::size_t kept = order.size();
    for (std::uint32_t old = 0; old < new_of_old.size(); ++old) {
        if (new_of_old[old] == no_id) {
            order.push_back(old); // dead entries go to the end and are cut off
        }
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i] == i) {
            continue;
        }
        const Record first = records[i];
        std::size_t at = i;
        while (order[at] != i) {
            const std::size_t from = order[at];
            records[at] = records[from];
            order[at] = static_cast<std::uint32_t>(at);
            at = from;
        }
        records[at] = first;
        order[at] = static_cast<std::uint32_t>(at);
    }
    records.resize(kept);
    order.clear();
    order.shrink_to_fit();
}

void permute_edge_attributes(AttributeSet& attributes, const std::vector<std::uint32_t>& order) {
    if (attributes.empty(SimplexKind::edge)) {
        return;
    }
    std::vector<std::uint32_t> corners;
    corners.reserve(4 * order.size());
    for (const std::uint32_t old : order) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            corners.push_back(corner_of(old, i));
        }
    }
    attributes.permute(SimplexKind::edge, corners);
}

} // namespace

std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y) {
    std::uint64_t index = 0;
    for (std::uint32_t side = 0x80000000U; side != 0; side >>= 1U) {
        const bool right = (x & side) != 0;
        const bool upper = (y & side) != 0;
        index = (index << 2U) | (right ? (upper ? 2U : 3U) : (upper ? 1U : 0U));
        if (!upper) { // the lower quadrants are mirrored at a diagonal
            if (right) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

template <class Real>
Renumbering renumber(Complex<Real>& complex) {
    Renumbering result;
    {
        std::vector<std::uint32_t> order = order_vertices(complex);
        result.vertices = inverse(order, complex.vertices.size());
        complex.attributes.permute(SimplexKind::vertex, order);
        permute(complex.vertices, order, result.vertices);
    }
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t& v : complex.triangles[t.id].v) {
            v = result.vertices[v];
        }
    }
    {
        std::vector<std::uint32_t> order = order_triangles(complex);
        result.triangles = inverse(order, complex.triangles.size());
        permute_edge_attributes(complex.attributes, order);
        complex.attributes.permute(SimplexKind::triangle, order);
        permute(complex.triangles, order, result.triangles);
    }
    const auto moved = [&](Corner c) {
        return corner_of(result.triangles[triangle_of(c)], index_of(c));
    };
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        for (Corner& c : complex.triangles[t].n) {
            c = is_border(c) ? border_corner : moved(c);
        }
    }
    for (auto& vertex : complex.vertices) {
        if (vertex.corner != no_id) {
            vertex.corner = moved(vertex.corner);
        }
    }
    complex.ids.clear();
    rewire::note(complex.journal, [] { return Edit{.kind = EditKind::renumber}; });
    return result;
}

template Renumbering renumber(Complex<double>&);
template Renumbering renumber(Complex<float>&);

} // namespace dsc
