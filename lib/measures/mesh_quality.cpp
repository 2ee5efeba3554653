// SPDX-License-Identifier: MIT
#include "measures/mesh_quality.h"

#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/quality/measures.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

template <class Real, class Visit>
void for_triangles(const Complex<Real>& complex, Visit visit) {
    for (const Triangle t : triangles(complex)) {
        const auto v = complex.vertices_of(t);
        visit(complex.position(v[0]), complex.position(v[1]), complex.position(v[2]));
    }
}

} // namespace

template <class Real>
MeshQuality measure_worst(const Complex<Real>& complex) {
    MeshQuality result;
    for_triangles(complex, [&](const auto& a, const auto& b, const auto& c) {
        result.inverted += orientation<Real>(a, b, c) > 0 ? 0U : 1U;
        result.min_quality =
            std::min(result.min_quality, static_cast<double>(quality<Real>(a, b, c)));
    });
    return result;
}

template <class Real>
MeshQuality measure_quality(const Complex<Real>& complex) {
    MeshQuality result = measure_worst(complex);
    std::vector<float> angles;
    angles.reserve(complex.triangle_count());
    for_triangles(complex, [&](const auto& a, const auto& b, const auto& c) {
        angles.push_back(static_cast<float>(min_angle_deg<Real>(a, b, c)));
    });
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
