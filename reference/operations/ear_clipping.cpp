// SPDX-License-Identifier: MIT
#include "reference/operations/ear_clipping.h"

#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <list>
#include <numeric>

namespace dsc::reference {

namespace {

bool lies_in(const Point<double>& a, const Point<double>& b, const Point<double>& c,
             const Point<double>& p) {
    return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

} // namespace

std::optional<std::vector<std::array<std::size_t, 3>>>
ear_clipping(std::span<const Point<double>> polygon) {
    if (polygon.size() < 3) {
        return std::nullopt;
    }
    std::list<std::size_t> rest(polygon.size());
    std::iota(rest.begin(), rest.end(), std::size_t{0});
    const auto next = [&](auto i) { return ++i == rest.end() ? rest.begin() : i; };
    const auto prev = [&](auto i) { return i == rest.begin() ? std::prev(rest.end()) : --i; };
    const auto is_ear = [&](std::size_t a, std::size_t b, std::size_t c) {
        return orientation(polygon[a], polygon[b], polygon[c]) > 0 &&
               std::ranges::none_of(rest, [&](std::size_t i) {
                   return i != a && i != b && i != c &&
                          lies_in(polygon[a], polygon[b], polygon[c], polygon[i]);
               });
    };

    std::vector<std::array<std::size_t, 3>> triangles;
    triangles.reserve(polygon.size() - 2);
    auto current = rest.begin();
    std::size_t skipped = 0;
    while (rest.size() > 3) {
        const std::array<std::size_t, 3> corner{*prev(current), *current, *next(current)};
        if (is_ear(corner[0], corner[1], corner[2])) {
            triangles.push_back(corner);
            const auto successor = next(current);
            rest.erase(current);
            current = successor;
            skipped = 0;
        } else {
            current = next(current);
            if (++skipped == rest.size()) {
                return std::nullopt;
            }
        }
    }
    const std::array<std::size_t, 3> last{*prev(current), *current, *next(current)};
    if (orientation(polygon[last[0]], polygon[last[1]], polygon[last[2]]) <= 0) {
        return std::nullopt;
    }
    triangles.push_back(last);
    return triangles;
}

} // namespace dsc::reference
