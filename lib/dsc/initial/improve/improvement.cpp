// SPDX-License-Identifier: MIT
#include "dsc/initial/improve/improvement.h"

#include "dsc/initial/build/delaunay.h"
#include "dsc/initial/build/zone.h"
#include "dsc/initial/improve/relaxation.h"

namespace dsc::initial {

template <class Real>
Improvement improve(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
                    double edge_length, int rounds, Protection protection) {
    Improvement done;
    bool busy = true;
    while (done.rounds < rounds && busy) {
        ++done.rounds;
        const auto zone = find_zone(complex, interface_vertices, edge_length);
        // Smoothing after every change, as the next change is judged by the current triangles.
        std::size_t moves = smooth(complex, zone);
        const std::size_t collapses = thin_out(complex, zone, edge_length);
        moves += smooth(complex, zone);
        const std::size_t insertions =
            refine(complex, zone, protection) + split_long(complex, zone, edge_length);
        done.moves += moves;
        done.collapses += collapses;
        done.insertions += insertions;
        busy = moves + collapses + insertions > 0;
    }
    for (auto& record : complex.vertices) {
        record.slot = unsettled;
    }
    return done;
}

template Improvement improve(Complex<double>&, std::span<const std::uint32_t>, double, int,
                             Protection);
template Improvement improve(Complex<float>&, std::span<const std::uint32_t>, double, int,
                             Protection);

} // namespace dsc::initial
