// SPDX-License-Identifier: MIT
#include "dsc/queries/components.h"

#include "dsc/geometry/triangle.h"

namespace dsc {

template <class Real>
Components components(const Complex<Real>& complex) {
    Components result;
    result.of.assign(complex.triangle_bound(), no_id);
    std::vector<std::uint32_t> waiting;
    const auto at = [&](Vertex v) {
        return Point<double>(complex.position(v).template cast<double>());
    };
    for (const Triangle first : triangles(complex)) {
        if (result.of[first.id] != no_id) {
            continue;
        }
        const auto number = static_cast<std::uint32_t>(result.list.size());
        Component component{.phase = complex.phase(first)};
        result.of[first.id] = number;
        waiting.assign(1, first.id);
        while (!waiting.empty()) {
            const std::uint32_t t = waiting.back();
            waiting.pop_back();
            ++component.triangles;
            const auto [a, b, c] = complex.vertices_of(Triangle{t});
            component.area += area(at(a), at(b), at(c));
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner across = complex.twin(corner_of(t, i));
                const std::uint32_t other = triangle_of(across);
                component.touches_border = component.touches_border || is_border(across);
                if (!is_border(across) && result.of[other] == no_id &&
                    complex.phase_at(across) == component.phase) {
                    result.of[other] = number;
                    waiting.push_back(other);
                }
            }
        }
        result.list.push_back(component);
    }
    for_each_outline(complex, [&](std::span<const Corner> outline) {
        ++result.list[result.of[triangle_of(outline.front())]].outlines;
    });
    return result;
}

template Components components(const Complex<double>&);
template Components components(const Complex<float>&);

} // namespace dsc
