// SPDX-License-Identifier: MIT
#include "dsc3/complex/complex.h"

#include <algorithm>
#include <utility>

namespace dsc3 {

namespace {

constexpr std::uint32_t cells = 1U << 21U;

// Moves the bits of x to every third bit.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32U) & 0x1f00000000ffffULL;
    x = (x | x << 16U) & 0x1f0000ff0000ffULL;
    x = (x | x << 8U) & 0x100f00f00f00f00fULL;
    x = (x | x << 4U) & 0x10c30c30c30c30c3ULL;
    return (x | x << 2U) & 0x1249249249249249ULL;
}

class Morton {
public:
    explicit Morton(const Complex& complex) {
        low_.setConstant(std::numeric_limits<Real>::max());
        Point high = -low_;
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            if (complex.is_alive(Vertex{v})) {
                low_ = low_.cwiseMin(complex.at(v));
                high = high.cwiseMax(complex.at(v));
            }
        }
        const Real size = (high - low_).maxCoeff();
        scale_ = size > 0 ? (cells - 1) / size : 0;
    }
    std::uint64_t operator()(const Point& p) const {
        const Point x = scale_ * (p - low_);
        const auto part = [](Real value) { return spread(static_cast<std::uint64_t>(value)); };
        return part(x.x()) | part(x.y()) << 1U | part(x.z()) << 2U;
    }

private:
    Point low_;
    Real scale_ = 0;
};

using Order = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

// The new id of each old one.
std::vector<std::uint32_t> numbers(Order& order, std::uint32_t bound, std::uint32_t first) {
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> result(bound, no_id);
    for (const auto& [index, id] : order) {
        result[id] = first++;
    }
    return result;
}

// Moves the tet at order[k] to k, for all k, in place. Spoils the order.
void permute_tets(Complex& complex, std::vector<std::uint32_t>& order) {
    for (std::uint32_t first = 1; first < order.size(); ++first) {
        const TetRecord tet = complex.tets[first];
        const Phase phase = complex.phases[first];
        std::uint32_t to = first;
        while (order[to] != first) {
            const std::uint32_t from = std::exchange(order[to], to);
            complex.tets[to] = complex.tets[from];
            complex.phases[to] = complex.phases[from];
            to = from;
        }
        order[to] = to;
        complex.tets[to] = tet;
        complex.phases[to] = phase;
    }
}

} // namespace

void renumber(Complex& complex) {
    const Morton morton(complex);
    Order by_vertex;
    Order by_tet;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.is_alive(Vertex{v})) {
            by_vertex.emplace_back(morton(complex.at(v)), v);
        }
    }
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(Tet{t})) {
            const auto p = complex.positions_of(Tet{t});
            by_tet.emplace_back(morton(0.25 * (p[0] + p[1] + p[2] + p[3])), t);
        }
    }
    const auto vertex = numbers(by_vertex, complex.vertex_bound(), 0);
    auto tet = numbers(by_tet, complex.tet_bound(), 1);
    tet[border_tet] = border_tet;
    const auto corner = [&](Corner c) {
        return is_border(c) ? c : corner_of(tet[tet_of(c)], index_of(c));
    };
    Complex next;
    next.vertices.resize(by_vertex.size());
    for (const auto& [index, v] : by_vertex) {
        next.vertices[vertex[v]] = complex.vertices[v];
        if (complex.vertices[v].corner != no_id) {
            next.vertices[vertex[v]].corner = corner(complex.vertices[v].corner);
        }
    }
    next.tets.resize(by_tet.size() + 1);
    next.phases.resize(by_tet.size() + 1);
    for (const auto& [index, t] : by_tet) {
        TetRecord& record = next.tets[tet[t]];
        next.phases[tet[t]] = complex.phases[t];
        for (std::uint32_t i = 0; i < 4; ++i) {
            record.v[i] = vertex[complex.tets[t].v[i]];
            record.n[i] = corner(complex.tets[t].n[i]);
        }
    }
    next.version = complex.version + 1;
    std::vector<std::uint32_t> order;
    for (const auto& [index, v] : by_vertex) {
        order.push_back(v);
    }
    complex.attributes.permute(dsc::SimplexKind::vertex, order);
    order.assign(1, border_tet);
    for (const auto& [index, t] : by_tet) {
        order.push_back(t);
    }
    complex.attributes.permute(dsc::SimplexKind::triangle, order);
    next.attributes = std::move(complex.attributes);
    complex = std::move(next);
}

std::vector<std::uint32_t> renumber_tets(Complex& complex) {
    const Morton morton(complex);
    const std::uint32_t bound = complex.tet_bound();
    // The upper half of the index, with the id in the lower one, sorts as one number.
    std::vector<std::uint64_t> places;
    std::vector<std::uint32_t> order{0};
    places.reserve(complex.tet_count());
    order.reserve(bound);
    for (std::uint32_t t = 1; t < bound; ++t) {
        if (complex.is_alive(Tet{t})) {
            const auto p = complex.positions_of(Tet{t});
            places.push_back(morton(0.25 * (p[0] + p[1] + p[2] + p[3])) >> 31U << 32U | t);
        }
    }
    std::sort(places.begin(), places.end());
    for (const std::uint64_t place : places) {
        order.push_back(static_cast<std::uint32_t>(place));
    }
    for (std::uint32_t t = 1; t < bound; ++t) {
        if (!complex.is_alive(Tet{t})) {
            order.push_back(t);
        }
    }
    std::vector<std::uint32_t> ids(bound);
    for (std::uint32_t k = 0; k < bound; ++k) {
        ids[order[k]] = k;
    }
    places = {};
    const std::uint32_t living = complex.tet_count() + 1;
    complex.attributes.permute(dsc::SimplexKind::triangle, {order.begin(), order.begin() + living});
    const auto corner = [&](Corner c) { return corner_of(ids[tet_of(c)], index_of(c)); };
    for (VertexRecord& vertex : complex.vertices) {
        if (vertex.corner != no_id) {
            vertex.corner = corner(vertex.corner);
        }
    }
    for (std::uint32_t t = 1; t < bound; ++t) {
        if (!complex.is_alive(Tet{t})) {
            ids[t] = no_id;
            continue;
        }
        for (Corner& n : complex.tets[t].n) {
            n = corner(n);
        }
    }
    permute_tets(complex, order);
    complex.tets.resize(living);
    complex.phases.resize(living);
    complex.free_tets.clear();
    ++complex.version;
    return ids;
}

} // namespace dsc3
