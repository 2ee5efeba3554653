// SPDX-License-Identifier: MIT
#include "dsc3/quality/star_quality.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc3 {

void StarQuality::put(const Complex& complex, Corner corner, std::uint32_t place) {
    const auto [u, v, w] = complex.face(corner);
    const Point a = complex.at(u) - origin_;
    const Point b = complex.at(v) - origin_;
    const Point c = complex.at(w) - origin_;
    const Point ab = b - a;
    const Point ac = c - a;
    const Point plane = ab.cross(ac);
    lanes_.plane_x[place] = plane.x();
    lanes_.plane_y[place] = plane.y();
    lanes_.plane_z[place] = plane.z();
    lanes_.offset[place] = plane.dot(a);
    const Point sum = a + b + c;
    lanes_.sum_x[place] = sum.x();
    lanes_.sum_y[place] = sum.y();
    lanes_.sum_z[place] = sum.z();
    lanes_.squares[place] = a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + ab.squaredNorm() +
                            ac.squaredNorm() + (c - b).squaredNorm();
}

void StarQuality::reset(const Point& origin, std::uint32_t size) {
    origin_ = origin;
    size_ = size;
    others_ = 0;
    if (lanes_.offset.size() < size_) {
        const std::size_t room = 2 * std::size_t{size_} + 64;
        for (auto* lane :
             {&lanes_.plane_x, &lanes_.plane_y, &lanes_.plane_z, &lanes_.offset, &lanes_.sum_x,
              &lanes_.sum_y, &lanes_.sum_z, &lanes_.squares, &lanes_.quality}) {
            lane->resize(room);
        }
    }
}

void StarQuality::gather(const Complex& complex, const Star& star, std::uint32_t without) {
    reset(complex.at(star.centre), static_cast<std::uint32_t>(star.corners.size()));
    std::uint32_t last = size_;
    for (const Corner corner : star.corners) {
        const bool is_last = without != no_id && has_vertex(complex.tets[tet_of(corner)], without);
        put(complex, corner, is_last ? --last : others_++);
    }
}

void StarQuality::gather(const Complex& complex, const EdgeAt& edge, const Ring& ring,
                         const Point& place) {
    reset(place, 2 * ring.size);
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        for (const std::uint32_t v : {edge.a, edge.b}) {
            const std::uint32_t t = ring.tets[i];
            put(complex, corner_of(t, index_in(complex.tets[t], v)), others_++);
        }
    }
}

Real StarQuality::worst(const Point& p, std::uint32_t count) {
    const Real x = p.x() - origin_.x();
    const Real y = p.y() - origin_.y();
    const Real z = p.z() - origin_.z();
    const Real square = 3 * (x * x + y * y + z * z);
    const Real* const plane_x = lanes_.plane_x.data();
    const Real* const plane_y = lanes_.plane_y.data();
    const Real* const plane_z = lanes_.plane_z.data();
    const Real* const offset = lanes_.offset.data();
    const Real* const sum_x = lanes_.sum_x.data();
    const Real* const sum_y = lanes_.sum_y.data();
    const Real* const sum_z = lanes_.sum_z.data();
    const Real* const squares = lanes_.squares.data();
    Real* const quality = lanes_.quality.data();
    Real least = std::numeric_limits<Real>::max();
#pragma omp simd reduction(min : least)
    for (std::uint32_t i = 0; i < count; ++i) {
        const Real det = offset[i] - plane_x[i] * x - plane_y[i] * y - plane_z[i] * z;
        const Real length2 = square - 2 * (sum_x[i] * x + sum_y[i] * y + sum_z[i] * z) + squares[i];
        const Real q = quality_scale * det / (length2 * std::sqrt(length2));
        quality[i] = q;
        least = std::min(least, q);
    }
    return least;
}

std::uint32_t StarQuality::worst_tet(std::uint32_t count) const {
    const auto begin = lanes_.quality.begin();
    return static_cast<std::uint32_t>(std::min_element(begin, begin + count) - begin);
}

Point StarQuality::gradient(std::uint32_t tet, const Point& p) const {
    const Point r = p - origin_;
    const Point plane(lanes_.plane_x[tet], lanes_.plane_y[tet], lanes_.plane_z[tet]);
    const Point sum(lanes_.sum_x[tet], lanes_.sum_y[tet], lanes_.sum_z[tet]);
    const Real det = lanes_.offset[tet] - plane.dot(r);
    const Real length2 = 3 * r.squaredNorm() - 2 * sum.dot(r) + lanes_.squares[tet];
    const Real factor = quality_scale / (length2 * std::sqrt(length2));
    return -factor * plane - (1.5 * factor * det / length2) * (6 * r - 2 * sum);
}

Point StarQuality::mean() const {
    Point sum = Point::Zero();
    for (std::uint32_t i = 0; i < size_; ++i) {
        sum += Point(lanes_.sum_x[i], lanes_.sum_y[i], lanes_.sum_z[i]);
    }
    return origin_ + sum / (3.0 * size_);
}

Real StarQuality::length() const { return std::sqrt(lanes_.squares[0] / 6); }

} // namespace dsc3
