// SPDX-License-Identifier: MIT
#include "dsc3/operations/workspace.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <limits>

namespace dsc3 {

OperationCounts& OperationCounts::operator+=(const OperationCounts& other) {
    splits += other.splits;
    collapses += other.collapses;
    edge_removals += other.edge_removals;
    face_flips += other.face_flips;
    smoothings += other.smoothings;
    interface_splits += other.interface_splits;
    interface_collapses += other.interface_collapses;
    interface_flips += other.interface_flips;
    reassigned += other.reassigned;
    return *this;
}

Real quality_of(const Complex& complex, std::uint32_t tet) {
    const auto& v = complex.tets[tet].v;
    return quality(complex.at(v[0]), complex.at(v[1]), complex.at(v[2]), complex.at(v[3]));
}

bool is_off_sheets(const Complex& complex, Workspace& work, std::uint32_t v) {
    if (!complex.is_interface(Vertex{v})) {
        return false;
    }
    gather(complex, v, work.other);
    gather(complex, work.other, work.interface_star);
    return !is_sheet(work.interface_star);
}

bool has_one_phase(const Complex& complex, const Ring& ring) {
    return std::all_of(ring.tets.begin(), ring.tets.begin() + ring.size, [&](std::uint32_t t) {
        return complex.phases[t] == complex.phases[ring.tets[0]];
    });
}

bool is_on_interface(const Complex& complex, const EdgeAt& edge, Ring& ring) {
    return edge.is_valid() && gather(complex, edge, ring) && !has_one_phase(complex, ring);
}

Real worst_quality(const Complex& complex, const Ring& ring) {
    Real worst = std::numeric_limits<Real>::max();
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        worst = std::min(worst, quality_of(complex, ring.tets[i]));
    }
    return worst;
}

} // namespace dsc3
