// SPDX-License-Identifier: MIT
#include "shapes/voronoi.h"

#include "shapes/voronoi_diagram.h"

#include <utility>

namespace dsc::scenes {

namespace {

// SplitMix64 by G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number
// generators" (2014), and its 53 upper bits as a fraction.
double next_fraction(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return static_cast<double>(z >> 11U) * 0x1p-53;
}

} // namespace

std::vector<Curve> voronoi_curves(const Rectangle& domain, std::span<const Point<double>> sites,
                                  double shortest) {
    VoronoiDiagram diagram = voronoi_diagram(domain, sites);
    if (shortest > 0) {
        diagram = without_short_edges(std::move(diagram), shortest);
    }
    std::vector<Curve> curves;
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        const VoronoiCell& cell = diagram.cells[i];
        for (std::size_t k = 0; k < cell.vertices.size(); ++k) {
            const std::uint32_t other = cell.beyond[k];
            if (other > i && !is_side(other)) {
                const std::size_t after = k + 1 < cell.vertices.size() ? k + 1 : 0;
                curves.push_back(
                    {{diagram.vertices[cell.vertices[k]], diagram.vertices[cell.vertices[after]]},
                     i + 1,
                     other + 1});
            }
        }
    }
    return curves;
}

std::vector<Point<double>> relaxed_sites(const Rectangle& domain,
                                         std::span<const Point<double>> sites, int rounds) {
    std::vector<Point<double>> result(sites.begin(), sites.end());
    for (int round = 0; round < rounds; ++round) {
        const VoronoiDiagram diagram = voronoi_diagram(domain, result);
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] = centroid(diagram.corners_of(diagram.cells[i]));
        }
    }
    return result;
}

std::vector<Point<double>> random_sites(const Rectangle& domain, std::size_t count,
                                        std::uint64_t seed) {
    std::vector<Point<double>> sites;
    sites.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = next_fraction(seed);
        const double y = next_fraction(seed);
        sites.emplace_back(domain.low.x() + x * (domain.high.x() - domain.low.x()),
                           domain.low.y() + y * (domain.high.y() - domain.low.y()));
    }
    return sites;
}

} // namespace dsc::scenes
