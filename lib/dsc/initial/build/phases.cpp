// SPDX-License-Identifier: MIT
#include "dsc/initial/build/phases.h"

#include "dsc/base/error.h"

namespace dsc::initial {

namespace {

// Bit i of a triangle's mark: the edge opposite to its corner i is part of an outline.
template <class Real>
void set_wall(Complex<Real>& complex, Corner corner) {
    complex.triangles[triangle_of(corner)].mark |= 1U << index_of(corner);
}

template <class Real>
void flood(Complex<Real>& complex, Phase phase, std::vector<std::uint32_t>& stack) {
    while (!stack.empty()) {
        const auto& record = complex.triangles[stack.back()];
        stack.pop_back();
        for (std::uint32_t i = 0; i < 3; ++i) {
            if ((record.mark >> i & 1U) != 0 || is_border(record.n[i])) {
                continue;
            }
            const std::uint32_t t = triangle_of(record.n[i]);
            if (complex.triangles[t].phase != phase) {
                complex.triangles[t].phase = phase;
                stack.push_back(t);
            }
        }
    }
}

} // namespace

template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const Outline> outlines, const Chains& chains) {
    std::vector<Corner> walls;
    std::vector<std::uint32_t> seeds;
    for (const auto& chain : chains) {
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const Corner inside = complex.find_half_edge(
                Vertex{chain[i]}, Vertex{chain[i + 1 < chain.size() ? i + 1 : 0]});
            if (inside == no_id) {
                throw InvariantError("fill_phases: a piece of an outline is no edge");
            }
            if (i == 0) {
                seeds.push_back(triangle_of(inside));
            }
            for (const Corner c : {inside, complex.twin(inside)}) {
                set_wall(complex, c);
                walls.push_back(c);
            }
        }
    }
    // A hole has the phase with which all triangles begin, so that it is not flooded; walls keep
    // every other flood inside its outline.
    std::vector<std::uint32_t> stack;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (outlines[k].phase != exterior_phase) {
            complex.triangles[seeds[k]].phase = outlines[k].phase;
            stack.push_back(seeds[k]);
            flood(complex, outlines[k].phase, stack);
        }
    }
    for (const Corner c : walls) {
        complex.triangles[triangle_of(c)].mark = 0;
    }
}

template void fill_phases(Complex<double>&, std::span<const Outline>, const Chains&);
template void fill_phases(Complex<float>&, std::span<const Outline>, const Chains&);

} // namespace dsc::initial
