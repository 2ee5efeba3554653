// SPDX-License-Identifier: MIT
#include "thesis/operations/ear_clipping.h"

#include "dsc/geometry/predicates.h"

namespace dsc {

namespace {

template <class Real>
bool is_ear(std::span<const Point<Real>> polygon, const std::vector<std::uint32_t>& next,
            std::uint32_t before, std::uint32_t at, std::uint32_t after) {
    const Point<Real>& a = polygon[before];
    const Point<Real>& b = polygon[at];
    const Point<Real>& c = polygon[after];
    if (orientation<Real>(a, b, c) <= 0) {
        return false;
    }
    for (std::uint32_t i = next[after]; i != before; i = next[i]) {
        // Test beyond the diagonal first, where most of the polygon lies.
        const Point<Real>& p = polygon[i];
        if (orientation<Real>(c, a, p) >= 0 && orientation<Real>(a, b, p) >= 0 &&
            orientation<Real>(b, c, p) >= 0) {
            return false;
        }
    }
    return true;
}

} // namespace

template <class Real>
bool ear_clipping(std::span<const Point<Real>> polygon, EarClipping& work) {
    work.triangles.clear();
    if (polygon.size() < 3) {
        return false;
    }
    auto left = static_cast<std::uint32_t>(polygon.size());
    work.next.resize(left);
    work.prev.resize(left);
    for (std::uint32_t i = 0; i < left; ++i) {
        work.next[i] = i + 1 < left ? i + 1 : 0;
        work.prev[i] = i > 0 ? i - 1 : left - 1;
    }
    std::uint32_t current = 0;
    std::uint32_t skipped = 0;
    while (left > 3) {
        const std::uint32_t before = work.prev[current];
        const std::uint32_t after = work.next[current];
        if (is_ear(polygon, work.next, before, current, after)) {
            work.triangles.push_back({before, current, after});
            work.next[before] = after;
            work.prev[after] = before;
            --left;
            skipped = 0;
        } else if (++skipped == left) {
            return false;
        }
        current = after;
    }
    const std::uint32_t before = work.prev[current];
    const std::uint32_t after = work.next[current];
    work.triangles.push_back({before, current, after});
    return orientation<Real>(polygon[before], polygon[current], polygon[after]) > 0;
}

template bool ear_clipping(std::span<const Point<double>>, EarClipping&);
template bool ear_clipping(std::span<const Point<float>>, EarClipping&);

} // namespace dsc
