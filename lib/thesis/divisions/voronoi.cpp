// SPDX-License-Identifier: MIT
#include "thesis/divisions/voronoi.h"

#include "thesis/divisions/site_grid.h"

#include <algorithm>
#include <utility>

namespace dsc {

namespace {

// Each site moves to the mean of the points that are nearest to it.
void even_out(std::vector<Point<double>>& sites, const std::vector<Point<double>>& points,
              int rounds) {
    for (int round = 0; round < rounds; ++round) {
        std::vector<Point<double>> sums(sites.size(), Point<double>::Zero());
        std::vector<double> counts(sites.size(), 0);
        const SiteGrid grid(sites);
        for (const auto& p : points) {
            const std::uint32_t i = grid.nearest(p.x(), p.y());
            sums[i] += p;
            counts[i] += 1;
        }
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (counts[i] > 0) {
                sites[i] = sums[i] / counts[i];
            }
        }
    }
}

} // namespace

PlaceColour voronoi_colour(std::vector<Point<double>> sites) {
    const auto count = static_cast<std::uint32_t>(std::max<std::size_t>(sites.size(), 1));
    return {[grid = SiteGrid(std::move(sites))](double x, double y) { return grid.nearest(x, y); },
            count};
}

template <class Real>
std::vector<PlaceColour> voronoi_colours(const PartitionInput<Real>& input, std::uint32_t submeshes,
                                         int rounds) {
    std::vector<Point<double>> points;
    for (const std::uint32_t v : input.interface) {
        points.push_back(input.complex.position(Vertex{v}).template cast<double>());
    }
    if (points.size() < 2 || submeshes < 2) {
        return {voronoi_colour({})};
    }
    std::vector<Point<double>> sites;
    for (std::size_t i = 0; i < submeshes; ++i) {
        sites.push_back(points[i * points.size() / submeshes]);
    }
    even_out(sites, points, rounds);
    // The second colour has a site wherever the interface passes from one region to the next.
    std::vector<Point<double>> between;
    const SiteGrid grid(sites);
    std::uint32_t before = grid.nearest(points.back().x(), points.back().y());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t at = grid.nearest(points[i].x(), points[i].y());
        const Point<double> gap = points[i] - points[i == 0 ? points.size() - 1 : i - 1];
        if (at != before && gap.norm() < 3 * input.edge_length) {
            between.push_back(points[i]);
        }
        before = at;
    }
    std::vector<PlaceColour> colours{voronoi_colour(std::move(sites))};
    if (!between.empty()) {
        colours.push_back(voronoi_colour(std::move(between)));
    }
    return colours;
}

template std::vector<PlaceColour> voronoi_colours(const PartitionInput<double>&, std::uint32_t,
                                                  int);
template std::vector<PlaceColour> voronoi_colours(const PartitionInput<float>&, std::uint32_t, int);

} // namespace dsc
