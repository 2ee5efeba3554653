// SPDX-License-Identifier: MIT
#include "dsc/initial/build/zone.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <limits>

namespace dsc::initial {

namespace {

constexpr int rings = 4; // of edges about the interface that always belong to the zone
// An edge shorter than this share of the target is not one of the lattice, whose shortest edges
// belong to the half triangles at the sides.
constexpr double fine_below = 0.48;

template <class Real>
bool is_fine(const Complex<Real>& complex, std::uint32_t vertex, double length) {
    double shortest = std::numeric_limits<double>::infinity();
    const Point<Real> centre = complex.position(Vertex{vertex});
    for (const Vertex w : link_vertices(complex, Vertex{vertex})) {
        const Point<Real> spoke = complex.position(w) - centre;
        shortest = std::min(shortest, spoke.template cast<double>().norm());
    }
    return shortest < fine_below * length;
}

} // namespace

template <class Real>
std::vector<std::uint32_t> find_zone(Complex<Real>& complex,
                                     std::span<const std::uint32_t> interface_vertices,
                                     double edge_length) {
    std::vector<std::uint32_t> found(interface_vertices.begin(), interface_vertices.end());
    for (const std::uint32_t v : found) {
        complex.vertices[v].stamp = 1;
    }
    std::size_t ring_end = found.size();
    int ring = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i == ring_end) {
            ++ring;
            ring_end = found.size();
        }
        const std::uint32_t v = found[i];
        if (ring >= rings && !is_fine(complex, v, edge_length)) {
            continue;
        }
        for (const Vertex w : link_vertices(complex, Vertex{v})) {
            if (complex.vertices[w.id].stamp == 0) {
                complex.vertices[w.id].stamp = 1;
                found.push_back(w.id);
            }
        }
    }
    for (const std::uint32_t v : found) {
        complex.vertices[v].stamp = 0;
    }
    std::erase_if(found, [&](std::uint32_t v) { return complex.vertices[v].slot == settled; });
    return found;
}

template std::vector<std::uint32_t> find_zone(Complex<double>&, std::span<const std::uint32_t>,
                                              double);
template std::vector<std::uint32_t> find_zone(Complex<float>&, std::span<const std::uint32_t>,
                                              double);

} // namespace dsc::initial
