// SPDX-License-Identifier: MIT
#include "dsc3/operations/edge_removal.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <limits>

namespace dsc3 {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// Appends the tets over the piece of the polygon from vertex i to vertex j.
void append(Workspace& work, std::uint32_t a, std::uint32_t b,
            std::span<const std::uint32_t> polygon, std::size_t i, std::size_t j, Phase phase) {
    if (j < i + 2) {
        return;
    }
    const std::uint32_t k = work.polygon_apex[i][j];
    work.rewiring.made.push_back({{polygon[i], polygon[k], polygon[j], b}, phase});
    work.rewiring.made.push_back({{polygon[k], polygon[i], polygon[j], a}, phase});
    append(work, a, b, polygon, i, k, phase);
    append(work, a, b, polygon, k, j, phase);
}

std::uint32_t link_size(const Ring& ring) { return ring.closed ? ring.size : ring.size + 1; }

// Whether both faces of the domain boundary at the edge of an open ring lie on one side; otherwise
// tets would be missing, or stick out, without the edge.
bool is_within_side(const Complex& complex, const EdgeAt& edge, const Ring& ring) {
    return ring.size > 1 &&
           (complex.fixed_along(edge.a, edge.b) & complex.fixed_along(edge.a, ring.vertices[0]) &
            complex.fixed_along(edge.a, ring.vertices[ring.size])) != 0;
}

} // namespace

// polygon_quality[i][j] is the best worst quality over the piece from vertex i to vertex j, and
// polygon_apex[i][j] the third vertex of the triangle at its chord. Triangles below the floor are
// skipped.
Real best_triangulation(const Complex& complex, Workspace& work, std::uint32_t a, std::uint32_t b,
                        std::span<const std::uint32_t> polygon, Real floor) {
    auto& best = work.polygon_quality;
    const Point& pa = complex.at(a);
    const Point& pb = complex.at(b);
    const std::size_t n = polygon.size();
    for (std::size_t i = n - 1; i-- > 0;) {
        best[i][i + 1] = infinity;
        for (std::size_t j = i + 2; j < n; ++j) {
            best[i][j] = -infinity;
            for (std::size_t k = i + 1; k < j; ++k) {
                const Real limit = std::max(best[i][j], floor);
                Real worst = std::min(best[i][k], best[k][j]);
                if (worst <= limit) {
                    continue;
                }
                const Point& pi = complex.at(polygon[i]);
                const Point& pj = complex.at(polygon[j]);
                const Point& pk = complex.at(polygon[k]);
                worst = std::min(worst, quality(pi, pk, pj, pb));
                if (worst <= limit) {
                    continue;
                }
                worst = std::min(worst, quality(pk, pi, pj, pa));
                if (worst > limit) {
                    best[i][j] = worst;
                    work.polygon_apex[i][j] = static_cast<std::uint32_t>(k);
                }
            }
        }
    }
    return n > 2 ? best[0][n - 1] : infinity;
}

void append_triangulation(Workspace& work, std::uint32_t a, std::uint32_t b,
                          std::span<const std::uint32_t> polygon, Phase phase) {
    append(work, a, b, polygon, 0, polygon.size() - 1, phase);
}

Verdict edge_removal_guard(const Complex& complex, Workspace& work, const EdgeAt& edge, Real gain) {
    Ring& ring = work.ring;
    if (!gather(complex, edge, ring) || link_size(ring) > polygon_limit) {
        return Verdict::no_gain;
    }
    if (!ring.closed && !is_within_side(complex, edge, ring)) {
        return Verdict::on_boundary;
    }
    if (!has_one_phase(complex, ring)) {
        return Verdict::on_interface;
    }
    const Real before = worst_quality(complex, ring);
    const Real floor = std::max({before * gain, before + 1e-9, quality_floor});
    return best_triangulation(complex, work, edge.a, edge.b,
                              {ring.vertices.data(), link_size(ring)}, floor) > floor
               ? Verdict::legal
               : Verdict::no_gain;
}

Verdict edge_removal(Complex& complex, Workspace& work, const EdgeAt& edge, Real gain) {
    const Verdict verdict = edge_removal_guard(complex, work, edge, gain);
    if (verdict == Verdict::legal) {
        const Ring& ring = work.ring;
        work.rewiring.made.clear();
        append_triangulation(work, edge.a, edge.b, {ring.vertices.data(), link_size(ring)},
                             complex.phases[ring.tets[0]]);
        // On a side two faces become two others.
        replace(complex, work.rewiring, {ring.tets.data(), ring.size}, work.rewiring.made,
                ring.closed ? 0 : 4);
        ++work.counts.edge_removals;
    }
    return verdict;
}

Verdict face_flip(Complex& complex, Workspace& work, Corner corner) {
    const Corner other = complex.twin(corner);
    if (is_border(other)) {
        return Verdict::on_boundary;
    }
    if (complex.phase_at(other) != complex.phase_at(corner)) {
        return Verdict::on_interface;
    }
    const std::array<std::uint32_t, 2> old{tet_of(corner), tet_of(other)};
    const Real before = std::min(quality_of(complex, old[0]), quality_of(complex, old[1]));
    const Real floor = std::max(1.0001 * before + 1e-9, quality_floor);
    const std::uint32_t d = complex.vertex(corner);
    const std::uint32_t e = complex.vertex(other);
    const auto face = complex.face(corner);
    work.rewiring.made.clear();
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t x = face[i];
        const std::uint32_t y = face[(i + 1) % 3];
        if (!(quality(complex.at(d), complex.at(x), complex.at(y), complex.at(e)) > floor)) {
            return Verdict::no_gain;
        }
        work.rewiring.made.push_back({{d, x, y, e}, complex.phase_at(corner)});
    }
    replace(complex, work.rewiring, old, work.rewiring.made);
    ++work.counts.face_flips;
    return Verdict::legal;
}

} // namespace dsc3
