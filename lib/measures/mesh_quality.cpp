// SPDX-License-Identifier: MIT
#include "measures/mesh_quality.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/quality/measures.h"

#include <algorithm>
#include <utility>

namespace dsc::scenes {

namespace {

// The squared sine of the smallest angle at this quality, plus a margin above rounding in either
// precision; also for a quality of 0 or below.
double above(double quality) {
    const double positive = std::max(quality, 0.0);
    return 0.75 * positive * positive * 1.01 + 1e-5;
}

// Whether a triangle with sides u and v, counter-clockwise, is certainly not inverted and certainly
// has a smallest angle of a larger squared sine: most triangles of a mesh, without a division or a
// root. Never where a square may have lost bits to underflow. Made for loops over lanes.
[[gnu::always_inline]] inline bool is_clearly_better(double ux, double uy, double vx, double vy,
                                                     double squared_sine) {
    const double wx = vx - ux;
    const double wy = vy - uy;
    const double uu = ux * ux + uy * uy;
    const double vv = vx * vx + vy * vy;
    const double ww = wx * wx + wy * wy;
    const double doubled = ux * vy - uy * vx;
    const double longest = std::max(ww, std::max(uu, vv));
    const double middle = std::max(std::min(uu, vv), std::min(std::max(uu, vv), ww));
    return (doubled > 1e-140) & (doubled * doubled > squared_sine * (longest * middle));
}

// In plain numbers: points as vectors would be stored and loaded again.
template <class Real>
bool is_clearly_better(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c,
                       double squared_sine) {
    const auto x = static_cast<double>(a.x());
    const auto y = static_cast<double>(a.y());
    return is_clearly_better(static_cast<double>(b.x()) - x, static_cast<double>(b.y()) - y,
                             static_cast<double>(c.x()) - x, static_cast<double>(c.y()) - y,
                             squared_sine);
}

// All triangles of a star.
template <class Real>
bool is_clearly_better(const Ring<Real>& ring, double squared_sine) {
    const auto x = static_cast<double>(ring.x0);
    const auto y = static_cast<double>(ring.y0);
    const std::uint32_t n = ring.padded();
    double is_better = 1; // as wide as the lanes
#pragma omp simd reduction(min : is_better)
    for (std::uint32_t i = 0; i < n; ++i) {
        const bool here = is_clearly_better(static_cast<double>(ring.x[i]) - x,
                                            static_cast<double>(ring.y[i]) - y,
                                            static_cast<double>(ring.x_next[i]) - x,
                                            static_cast<double>(ring.y_next[i]) - y, squared_sine);
        is_better = std::min(is_better, here ? 1.0 : 0.0);
    }
    return is_better > 0;
}

} // namespace

template <class Real>
void QualityWatch<Real>::note(std::span<const Edit> edits) {
    // Each triangle that an edit makes or changes has one of these vertices.
    for (const Edit& edit : edits) {
        switch (edit.kind) {
        case EditKind::move:
        case EditKind::split: touched_.push_back(edit.vertex.id); break;
        case EditKind::flip: touched_.push_back(edit.apexes[0].id); break;
        case EditKind::collapse: touched_.push_back(edit.ends[1].id); break;
        case EditKind::insert_triangle: touched_.push_back(edit.ends[0].id); break;
        case EditKind::retriangulate:
        case EditKind::renumber:
        case EditKind::rebuild: forget(); break;
        case EditKind::relabel:
        case EditKind::insert_vertex:
        case EditKind::remove_vertex:
        case EditKind::remove_triangle: break;
        }
    }
}

template <class Real>
void QualityWatch<Real>::look_at(Triangle t) {
    const auto [a, b, c] = complex_.positions_of(t);
    min_quality_ = std::min(min_quality_, static_cast<double>(quality<Real>(a, b, c)));
    if (orientation<Real>(a, b, c) <= 0) {
        inverted_.push_back(t.id);
    }
}

template <class Real>
void QualityWatch<Real>::look_at(Vertex v, Ring<Real>& ring) {
    if (!gather(complex_, dsc::Region{}, v.id, ring) ||
        !is_clearly_better(ring, above(min_quality_))) {
        for_each_corner(complex_, v, [&](Corner c) { look_at(Triangle{triangle_of(c)}); });
    }
}

template <class Real>
MeshQuality QualityWatch<Real>::look() {
    Ring<Real> ring;
    const std::vector<std::uint32_t> before = std::exchange(inverted_, {});
    if (is_known_) {
        ++looks_;
        visited_.resize(complex_.vertex_bound(), 0);
        for (const std::uint32_t v : touched_) {
            if (complex_.is_alive(Vertex{v}) && std::exchange(visited_[v], looks_) != looks_) {
                look_at(Vertex{v}, ring);
            }
        }
        for (const std::uint32_t t : before) {
            if (complex_.is_alive(Triangle{t})) {
                look_at(Triangle{t});
            }
        }
    } else {
        for (const Triangle t : triangles(complex_)) {
            const auto [a, b, c] = complex_.positions_of(t);
            if (!is_clearly_better<Real>(a, b, c, above(min_quality_))) {
                look_at(t);
            }
        }
    }
    std::ranges::sort(inverted_);
    inverted_.erase(std::unique(inverted_.begin(), inverted_.end()), inverted_.end());
    touched_.clear();
    is_known_ = true;
    return {.min_quality = min_quality_, .inverted = inverted_.size()};
}

template <class Real>
MeshQuality measure_worst(const Complex<Real>& complex) {
    return QualityWatch<Real>(complex).look();
}

template <class Real>
MeshQuality measure_quality(const Complex<Real>& complex) {
    MeshQuality result = measure_worst(complex);
    std::vector<float> angles;
    angles.reserve(complex.triangle_count());
    for (const Triangle t : triangles(complex)) {
        angles.push_back(static_cast<float>(min_angle_deg(complex, t)));
    }
    if (!angles.empty()) {
        const auto half = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
        std::nth_element(angles.begin(), half, angles.end());
        result.median_angle_deg = static_cast<double>(*half);
        result.min_angle_deg = static_cast<double>(*std::min_element(angles.begin(), angles.end()));
    }
    return result;
}

template class QualityWatch<double>;
template class QualityWatch<float>;
template MeshQuality measure_worst(const Complex<double>&);
template MeshQuality measure_worst(const Complex<float>&);
template MeshQuality measure_quality(const Complex<double>&);
template MeshQuality measure_quality(const Complex<float>&);

} // namespace dsc::scenes
