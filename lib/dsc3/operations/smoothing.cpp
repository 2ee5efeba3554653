// SPDX-License-Identifier: MIT
#include "dsc3/operations/smoothing.h"

#include "dsc3/geometry/tet.h"

namespace dsc3 {

Verdict smooth(Complex& complex, Workspace& work, Vertex vertex, int iterations) {
    VertexRecord& record = complex.vertices[vertex.id];
    if ((record.flags & vertex_interface) != 0) {
        return Verdict::on_interface;
    }
    if ((record.flags & vertex_boundary) != 0) {
        return Verdict::on_boundary;
    }
    if ((record.flags & vertex_settled) != 0) {
        return Verdict::no_gain;
    }
    record.flags |= vertex_settled;
    gather(complex, vertex.id, work.star);
    StarQuality& star = work.quality;
    star.gather(complex, work.star);
    Point best = record.position;
    const Real before = star.worst(best);
    Real quality = before;
    const Point mean = star.mean();
    if (const Real there = star.worst(mean); there > quality) {
        quality = there;
        best = mean;
    } else {
        star.worst(best);
    }
    Real step = 0.2 * star.length();
    for (int iteration = 0; iteration < iterations; ++iteration) {
        const Point gradient = star.gradient(star.worst_tet(star.size()), best);
        const Real slope = gradient.norm();
        if (!(slope > 1e-30)) {
            break;
        }
        bool is_better = false;
        for (int attempt = 0; attempt < 3 && !is_better; ++attempt) {
            const Point to = best + (step / slope) * gradient;
            const Real there = star.worst(to);
            if (there > 1.0001 * quality) {
                quality = there;
                best = to;
                is_better = true;
            } else {
                step *= 0.4;
            }
        }
        if (!is_better) {
            break;
        }
        step *= 1.3;
    }
    if (!(quality > 1.001 * before + 1e-12)) {
        return Verdict::no_gain;
    }
    record.position = best;
    ++complex.version;
    ++work.counts.smoothings;
    for (const Corner corner : work.star.corners) {
        for (const std::uint32_t v : complex.tets[tet_of(corner)].v) {
            complex.vertices[v].flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
    }
    record.flags |= vertex_settled;
    return Verdict::legal;
}

} // namespace dsc3
