// SPDX-License-Identifier: MIT
#include "dsc3/complex/star.h"

#include <algorithm>
#include <utility>

namespace dsc3 {

void IdTable::clear() {
    count_ = 0;
    if (mask_ != 255) { // clearing a large table for the small stars that follow would be slow
        *this = IdTable();
        return;
    }
    std::fill_n(slots_.data(), 256, no_id);
}

void IdTable::grow() {
    const std::vector<std::uint32_t> old = std::move(slots_);
    slots_.assign(2 * old.size(), no_id);
    mask_ = 2 * mask_ + 1;
    --shift_;
    count_ = 0;
    for (const std::uint32_t id : old) {
        if (id != no_id) {
            enter(id);
        }
    }
}

void gather(const Complex& complex, std::uint32_t vertex, Star& star) {
    star.centre = vertex;
    star.met.clear();
    auto& corners = star.corners;
    corners.clear();
    corners.push_back(complex.vertices[vertex].corner);
    star.met.enter(tet_of(corners[0]));
    star.entries.assign(1, index_of(corners[0]));
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const TetRecord& tet = complex.tets[tet_of(corners[k])];
        for (const std::uint32_t i : face_indices[index_of(corners[k])]) {
            const std::uint32_t other = tet_of(tet.n[i]);
            if (i != star.entries[k] && other != border_tet && star.met.enter(other)) {
                corners.push_back(corner_of(other, index_in(complex.tets[other], vertex)));
                star.entries.push_back(index_of(tet.n[i]));
            }
        }
    }
}

void StarCache::open() {
    for (Entry& entry : entries_) {
        entry.centre = no_id;
    }
    is_open_ = true;
}

void StarCache::gather(const Complex& complex, std::uint32_t vertex, Star& star) {
    if (!is_open_) {
        dsc3::gather(complex, vertex, star);
        return;
    }
    Entry& entry = entries_[vertex % size];
    if (entry.centre == vertex) {
        star.centre = vertex;
        star.corners = entry.corners;
        return;
    }
    dsc3::gather(complex, vertex, star);
    entry.centre = vertex;
    entry.corners = star.corners;
}

EdgeAt find_edge(const Complex& complex, std::uint32_t a, std::uint32_t b, Star& star) {
    if (!complex.is_alive(Vertex{a}) || !complex.is_alive(Vertex{b}) || a == b) {
        return {};
    }
    gather(complex, a, star);
    for (const Corner corner : star.corners) {
        if (has_vertex(complex.tets[tet_of(corner)], b)) {
            return {tet_of(corner), a, b};
        }
    }
    return {};
}

namespace {

// The two vertices c, d of the tet such that (a, b, c, d) is positive.
std::array<std::uint32_t, 2> across(const TetRecord& tet, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t j = index_in(tet, b);
    const auto& others = face_indices[index_in(tet, a)];
    const std::uint32_t k = others[0] == j ? 0U : others[1] == j ? 1U : 2U;
    return {tet.v[others[(k + 1) % 3]], tet.v[others[(k + 2) % 3]]};
}

} // namespace

bool gather(const Complex& complex, const EdgeAt& edge, Ring& ring) {
    // Walk back to a face of the domain boundary, if there is one.
    std::uint32_t first = edge.tet;
    std::uint32_t steps = 0;
    auto [c, d] = across(complex.tets[first], edge.a, edge.b);
    ring.closed = true;
    for (;;) {
        const TetRecord& tet = complex.tets[first];
        const Corner other = tet.n[index_in(tet, d)];
        if (is_border(other)) {
            ring.closed = false;
            break;
        }
        first = tet_of(other);
        d = c;
        c = complex.vertex(other);
        if (first == edge.tet) {
            break; // once around: (c, d) are those of the first tet again
        }
        if (++steps > ring_limit) {
            return false;
        }
    }
    ring.size = 0;
    for (std::uint32_t at = first;;) {
        if (ring.size == ring_limit) {
            return false;
        }
        ring.vertices[ring.size] = c;
        ring.tets[ring.size++] = at;
        const TetRecord& tet = complex.tets[at];
        const Corner other = tet.n[index_in(tet, c)];
        if (is_border(other)) {
            ring.vertices[ring.size] = d;
            return true;
        }
        at = tet_of(other);
        if (at == first) {
            return true;
        }
        c = d;
        d = complex.vertex(other);
    }
}

} // namespace dsc3
