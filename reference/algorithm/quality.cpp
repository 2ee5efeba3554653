// SPDX-License-Identifier: MIT
#include "reference/algorithm/quality.h"

#include "reference/complex/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::reference {

double distance(const Point<double>& a, const Point<double>& b) { return (b - a).norm(); }

double length(const Complex& K, const EdgeKey& e) {
    return distance(K.coord(e.v[0]), K.coord(e.v[1]));
}

double area(const Complex& K, const TriangleKey& t) {
    return 0.5 * std::abs(cross(K.coord(t.v[0]), K.coord(t.v[1]), K.coord(t.v[2])));
}

double quality(const Point<double>& a, const Point<double>& b, const Point<double>& c) {
    // The smallest angle lies between the two longer edges, and sin = 2 area / (their lengths).
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    const double ab = (b - a).squaredNorm();
    const double longest = std::max({bc, ca, ab});
    const double middle = std::max(std::min(bc, ca), std::min(std::max(bc, ca), ab));
    if (!(middle > 0)) {
        return 0;
    }
    return 2 * std::numbers::inv_sqrt3 * std::abs(cross(a, b, c)) / std::sqrt(longest * middle);
}

double quality(const Complex& K, const TriangleKey& t) {
    return quality(K.coord(t.v[0]), K.coord(t.v[1]), K.coord(t.v[2]));
}

double star_quality(const Complex& K, Vertex v) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const TriangleKey& t : K.triangles_at(v)) {
        smallest = std::min(smallest, quality(K, t));
    }
    return smallest;
}

double delaunay(const Complex& K, const EdgeKey& e) {
    const std::set<TriangleKey>& T = K.triangles_at(e);
    if (T.size() != 2) {
        return 1;
    }
    // sin(alpha + beta) = sin alpha cos beta + cos alpha sin beta, up to positive factors: the
    // cross and dot products at the two opposite vertices.
    const Point<double>& p = K.coord(e.v[0]);
    const Point<double>& q = K.coord(e.v[1]);
    double sine[2];
    double cosine[2];
    int i = 0;
    for (const TriangleKey& t : T) {
        for (Vertex w : t.v) {
            if (!has_vertex(e, w)) {
                sine[i] = std::abs(cross(K.coord(w), p, q));
                cosine[i] = (p - K.coord(w)).dot(q - K.coord(w));
            }
        }
        ++i;
    }
    const double first = sine[0] * cosine[1];
    const double second = sine[1] * cosine[0];
    const double size = std::abs(first) + std::abs(second);
    return size > 0 ? (first + second) / size : 0;
}

} // namespace dsc::reference
