// SPDX-License-Identifier: MIT
#include "measures/mesh_quality.h"

#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/quality/measures.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

// The squared sine of the smallest angle at this quality, plus a margin above rounding in either
// precision; also for a quality of 0 or below.
double above(double quality) {
    const double positive = std::max(quality, 0.0);
    return 0.75 * positive * positive * 1.01 + 1e-5;
}

// Whether a triangle is certainly not inverted and certainly has a smallest angle of a larger
// squared sine: most triangles of a mesh, without a division or a root. Never where a square may
// have lost bits to underflow. In plain numbers: a run asks this of each triangle after each step.
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
    return doubled > 1e-140 && doubled * doubled > squared_sine * (longest * middle);
}

} // namespace

template <class Real>
MeshQuality measure_worst(const Complex<Real>& complex) {
    MeshQuality result;
    double limit = above(result.min_quality);
    for (const Triangle t : triangles(complex)) {
        const auto v = complex.vertices_of(t);
        const Point<Real> a = complex.position(v[0]);
        const Point<Real> b = complex.position(v[1]);
        const Point<Real> c = complex.position(v[2]);
        if (!is_clearly_better<Real>(a, b, c, limit)) {
            result.inverted += orientation<Real>(a, b, c) > 0 ? 0U : 1U;
            result.min_quality =
                std::min(result.min_quality, static_cast<double>(quality<Real>(a, b, c)));
            limit = above(result.min_quality);
        }
    }
    return result;
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

template MeshQuality measure_worst(const Complex<double>&);
template MeshQuality measure_worst(const Complex<float>&);
template MeshQuality measure_quality(const Complex<double>&);
template MeshQuality measure_quality(const Complex<float>&);

} // namespace dsc::scenes
