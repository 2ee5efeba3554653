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

// The squared sine of the smallest angle of a triangle with this quality, plus a margin above
// rounding errors in either precision; also for qualities of 0 or below.
double above(double quality) {
    const double positive = std::max(quality, 0.0);
    return 0.75 * positive * positive * 1.01 + 1e-5;
}

// Whether a triangle is certainly not inverted and the squared sine of its smallest angle is
// certainly larger: decides most triangles of a mesh without a division or a root. False if a
// square may have underflowed. Uses scalars, because vectors would be stored to memory and loaded
// again.
template <class Real>
bool is_clearly_better(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c,
                       double squared_sine) {
    const auto x = static_cast<double>(a.x());
    const auto y = static_cast<double>(a.y());
    const double ux = static_cast<double>(b.x()) - x;
    const double uy = static_cast<double>(b.y()) - y;
    const double vx = static_cast<double>(c.x()) - x;
    const double vy = static_cast<double>(c.y()) - y;
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

/// Collects inverted triangles and the minimum of the quality.
template <class Real>
struct Worst {
    const Complex<Real>& complex;
    double min_quality = 1;
    std::vector<std::uint32_t> inverted = {}; // triangles
    double squared_sine = above(min_quality);

    void look_at(Triangle t) {
        const auto [a, b, c] = complex.positions_of(t);
        if (is_clearly_better<Real>(a, b, c, squared_sine)) {
            return;
        }
        min_quality = std::min(min_quality, static_cast<double>(quality<Real>(a, b, c)));
        squared_sine = above(min_quality);
        if (orientation<Real>(a, b, c) <= 0) {
            inverted.push_back(t.id);
        }
    }
    void look_around(Vertex v) {
        for_each_corner(complex, v, [&](Corner c) { look_at(Triangle{triangle_of(c)}); });
    }
    void look_at_all() {
        inverted.clear();
        for (const Triangle t : triangles(complex)) {
            look_at(t);
        }
    }
};

} // namespace

template <class Real>
MeshQuality QualityWatch<Real>::look() {
    const Complex<Real>& complex = simulation_.complex();
    const std::span<const std::uint32_t> poor = simulation_.take_poor();
    Worst<Real> worst{.complex = complex, .min_quality = min_quality_};
    if (is_known_ && std::ranges::find(poor, no_id) == poor.end()) {
        for (const std::uint32_t v : poor) {
            if (complex.is_alive(Vertex{v})) {
                worst.look_around(Vertex{v});
            }
        }
        for (const std::uint32_t t : inverted_) {
            if (complex.is_alive(Triangle{t})) {
                worst.look_at(Triangle{t});
            }
        }
        std::ranges::sort(worst.inverted);
        worst.inverted.erase(std::unique(worst.inverted.begin(), worst.inverted.end()),
                             worst.inverted.end());
    } else {
        worst.look_at_all();
    }
    is_known_ = true;
    min_quality_ = worst.min_quality;
    inverted_ = std::move(worst.inverted);
    simulation_.watch_quality(min_quality_);
    return {.min_quality = min_quality_, .inverted = inverted_.size()};
}

template <class Real>
MeshQuality measure_worst(const Complex<Real>& complex) {
    Worst<Real> worst{.complex = complex};
    worst.look_at_all();
    return {.min_quality = worst.min_quality, .inverted = worst.inverted.size()};
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
