// SPDX-License-Identifier: MIT
#include "dsc/initial/build/phases.h"

#include "dsc/initial/build/walls.h"

namespace dsc::initial {

template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const Outline> outlines, const Chains& chains) {
    const std::vector<Wall> walls = raise_walls(complex, chains);
    // A hole has the phase with which all triangles begin, so that it is not flooded; walls keep
    // every other flood inside its outline.
    std::vector<std::uint32_t> stack;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const std::uint32_t k = walls[i].chain;
        const Phase phase = outlines[k].phase;
        const bool first = i == 0 || walls[i - 1].chain != k;
        if (first && phase != exterior_phase) {
            const std::uint32_t seed = triangle_of(walls[i].left);
            complex.triangles[seed].phase = phase;
            stack.push_back(seed);
            flood(complex, stack, [&](std::uint32_t t) {
                const bool fresh = complex.triangles[t].phase != phase;
                complex.triangles[t].phase = phase;
                return fresh;
            });
        }
    }
    remove_walls(complex, walls);
}

template void fill_phases(Complex<double>&, std::span<const Outline>, const Chains&);
template void fill_phases(Complex<float>&, std::span<const Outline>, const Chains&);

} // namespace dsc::initial
