// SPDX-License-Identifier: MIT
#include "dsc/passes/interface/carried.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/interface/list.h"
#include "dsc/queries/phases.h"

#include <algorithm>

namespace dsc {

template <class Real>
bool is_carried(const Complex<Real>& complex, std::span<const Phase> phases, Vertex vertex) {
    const Corner first = complex.vertices[vertex.id].corner;
    if (phases.empty() || first == no_id ||
        std::ranges::find(phases, complex.phase_at(first)) == phases.end()) {
        return false;
    }
    const Phase phase = complex.phase_at(first);
    bool is_inside = true;
    for_each_corner(complex, vertex, [&](Corner c) {
        is_inside = is_inside && complex.phase_at(c) == phase &&
                    !is_border(complex.twin(prev(c))) && !is_border(complex.twin(next(c)));
    });
    return is_inside;
}

template <class Real>
std::vector<std::uint32_t> collect_moved(const Complex<Real>& complex,
                                         const Options<Real>& options) {
    if (options.carried_phases.empty()) {
        return collect_interface(complex, options.shuffle_seed);
    }
    std::vector<std::uint32_t> list = collect_interface(complex);
    for (const Vertex v : vertices(complex)) {
        if (is_carried<Real>(complex, options.carried_phases, v)) {
            list.push_back(v.id);
        }
    }
    shuffle_interface(list, options.shuffle_seed);
    return list;
}

template <class Real>
bool is_moved(const Complex<Real>& complex, const Options<Real>& options, Vertex vertex) {
    return complex.is_alive(vertex) && complex.vertices[vertex.id].corner != no_id &&
           (is_interface(complex, vertex) ||
            is_carried<Real>(complex, options.carried_phases, vertex));
}

template <class Real>
std::vector<std::uint32_t> moved_among(const Complex<Real>& complex, const Options<Real>& options,
                                       std::span<const std::uint32_t> changed) {
    std::vector<std::uint32_t> moved;
    for (const std::uint32_t v : changed) {
        if (is_moved(complex, options, Vertex{v})) {
            moved.push_back(v);
        }
    }
    return moved;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template bool is_carried(const Complex<Real>&, std::span<const Phase>, Vertex);                \
    template std::vector<std::uint32_t> collect_moved(const Complex<Real>&, const Options<Real>&); \
    template bool is_moved(const Complex<Real>&, const Options<Real>&, Vertex);                    \
    template std::vector<std::uint32_t> moved_among(const Complex<Real>&, const Options<Real>&,    \
                                                    std::span<const std::uint32_t>);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
