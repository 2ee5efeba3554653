// SPDX-License-Identifier: MIT
#include "dsc/base/types.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace dsc {

namespace detail {

// A closed curve around a component.
struct Outline {
    Corner first = no_id; // the smallest corner opposite to an edge of it
    Phase phase = exterior_phase;
    double area = 0;      // negative around a hole
    bool is_hole = false; // by more than rounding
    bool touches_border = false;
};

} // namespace detail

namespace {

using detail::Outline;

template <class Real>
Outline measure_outline(const Complex<Real>& complex, std::span<const Corner> corners) {
    Outline outline{.first = corners.front(), .phase = complex.phase_at(corners.front())};
    // Uses plain numbers, because points as vectors would be stored and loaded again.
    const auto at = [&](Corner c) -> const auto& { return complex.vertices[complex.vertex(c)]; };
    const auto& origin = at(next(corners.front()));
    double from_x = 0;
    double from_y = 0;
    double size = 0;
    for (const Corner c : corners) {
        const auto& end = at(prev(c));
        const double x = static_cast<double>(end.x) - static_cast<double>(origin.x);
        const double y = static_cast<double>(end.y) - static_cast<double>(origin.y);
        outline.area += (from_x * y - from_y * x) / 2;
        size += std::abs(from_x * y) + std::abs(from_y * x);
        outline.touches_border |= is_border(complex.twin(c));
        from_x = x;
        from_y = y;
    }
    const double rounding =
        static_cast<double>(corners.size() + 4) * std::numeric_limits<double>::epsilon();
    outline.is_hole = outline.area < -rounding * size;
    return outline;
}

// The corners opposite to edges where the phase changes, ascending.
std::vector<Corner> find_constrained(std::span<const TriangleRecord> records,
                                     std::span<const Phase> phase_of) {
    std::vector<Corner> constrained;
    for (std::uint32_t t = border_triangle + 1; t < records.size(); ++t) {
        const Phase phase = phase_of[t];
        const auto differs = [phase, phase_of, &across = records[t].n](std::uint32_t i) {
            return phase ^ phase_of[triangle_of(across[i])];
        };
        // One branch instead of three that the processor could not predict.
        if (phase != no_id && (differs(0) | differs(1) | differs(2)) != 0) [[unlikely]] {
            for (std::uint32_t i = 0; i < 3; ++i) {
                if (differs(i) != 0) {
                    constrained.push_back(corner_of(t, i));
                }
            }
        }
    }
    return constrained;
}

// Replaces the phase of a triangle, and of all that are joined to it, by a label.
template <class Real>
void fill_component(const Complex<Real>& complex, std::uint32_t from, std::uint32_t label,
                    std::vector<std::uint32_t>& of) {
    const Phase phase = std::exchange(of[from], label);
    std::vector<std::uint32_t> reached{from};
    while (!reached.empty()) {
        const TriangleRecord& triangle = complex.triangles[reached.back()];
        reached.pop_back();
        for (const Corner across : triangle.n) {
            if (const std::uint32_t t = triangle_of(across); of[t] == phase) {
                of[t] = label;
                reached.push_back(t);
            }
        }
    }
}

// Fills all components of each phase except the largest, whose triangles keep their phase. In the
// plane a component has exactly one outline that is no hole. If rounding makes an outline
// indistinguishable from a hole, it may belong to a component that is already filled, or to the
// only one; the largest is then filled as well, and no triangle keeps the phase.
template <class Real>
void fill_components(const Complex<Real>& complex, std::vector<Outline> outlines,
                     std::vector<std::uint32_t>& of) {
    std::vector<Phase> used;
    for (const Outline& outline : outlines) {
        used.push_back(outline.phase);
    }
    std::ranges::sort(used);
    std::erase_if(outlines, [](const Outline& outline) { return outline.is_hole; });
    std::ranges::sort(outlines, [](const Outline& one, const Outline& other) {
        return one.phase != other.phase ? one.phase < other.phase : one.area > other.area;
    });
    std::uint32_t label = 0;
    for (std::size_t i = 1; i < outlines.size(); ++i) {
        const std::uint32_t t = triangle_of(outlines[i].first);
        if (outlines[i].phase == outlines[i - 1].phase && of[t] == outlines[i].phase) {
            while (std::ranges::binary_search(used, label)) {
                ++label;
            }
            fill_component(complex, t, label++, of);
        }
    }
}

// Replaces phases and labels by numbers of components, in the order of their smallest triangles.
template <class Real>
std::vector<Component> number_components(const Complex<Real>& complex,
                                         std::vector<std::uint32_t>& of) {
    std::vector<Component> list;
    std::unordered_map<std::uint32_t, std::uint32_t> number_of;
    for (std::uint32_t t = border_triangle + 1; t < of.size();) {
        const std::uint32_t label = of[t];
        if (label == no_id) {
            ++t;
            continue;
        }
        const auto [entry, is_new] =
            number_of.try_emplace(label, static_cast<std::uint32_t>(list.size()));
        if (is_new) {
            list.push_back({.phase = complex.triangles[t].phase});
        }
        const std::uint32_t number = entry->second;
        const std::uint32_t first = t; // triangles of one component follow each other
        for (; t < of.size() && of[t] == label; ++t) {
            of[t] = number;
        }
        list[number].triangles += t - first;
    }
    return list;
}

} // namespace

template <class Real>
Components components(const Complex<Real>& complex) {
    Components result;
    // Initially the phase of each triangle, in a compact array, so that those of neighbours are in
    // the cache.
    std::vector<std::uint32_t>& of = result.of;
    static_assert(border_phase == no_id);
    of.resize(complex.triangle_bound());
    std::ranges::transform(complex.triangles, of.begin(), [](const TriangleRecord& triangle) {
        return triangle.v[0] == no_id ? no_id : triangle.phase;
    });
    std::vector<Outline> outlines;
    for_each_loop(
        complex, HalfEdges(find_constrained(complex.triangles, of)),
        [&](Corner c) { return of[triangle_of(c)] != of[triangle_of(complex.twin(c))]; },
        [&](std::span<const Corner> corners) {
            outlines.push_back(measure_outline(complex, corners));
        });
    fill_components(complex, outlines, of);
    result.list = number_components(complex, of);
    for (const Outline& outline : outlines) {
        Component& component = result.list[of[triangle_of(outline.first)]];
        component.area += outline.area;
        ++component.outlines;
        component.touches_border |= outline.touches_border;
    }
    return result;
}

template Components components(const Complex<double>&);
template Components components(const Complex<float>&);

} // namespace dsc
