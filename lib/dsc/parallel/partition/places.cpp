// SPDX-License-Identifier: MIT
#include "dsc/parallel/partition/partition.h"

#include "dsc/base/error.h"
#include "dsc/parallel/partition/site_grid.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dsc {

namespace {

std::uint32_t call_place(const void* context, double x, double y) {
    return static_cast<const PlaceColour*>(context)->number_of(x, y);
}

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

template <class Real>
PlacePartitioner<Real>::PlacePartitioner(PlaceFunction<Real> function, std::uint32_t recut)
    : function_(std::move(function)), recut_(recut) {
    if (!function_ || recut < 1) {
        throw InputError({.what = "not a partition",
                          .where = "PlacePartitioner",
                          .value = !function_ ? "no function" : "0",
                          .allowed = "a function, and 1 step or more between two divisions"});
    }
}

template <class Real>
Recut PlacePartitioner<Real>::is_due(const PartitionStatus& status) const {
    return status.steps_since_all >= recut_ ? Recut::all : Recut::none;
}

template <class Real>
void PlacePartitioner<Real>::divide(const PartitionInput<Real>& input, Recut /*recut*/,
                                    Partition& partition) {
    std::vector<PlaceColour> colours = function_(input);
    for (const PlaceColour& colour : colours) {
        if (!colour.number_of || colour.submeshes < 1) {
            throw InputError({.what = "not a colour",
                              .where = "PlacePartitioner",
                              .value = std::to_string(colour.submeshes) + " submeshes",
                              .allowed = "a function and 1 submesh or more"});
        }
    }
    if (colours.empty()) {
        throw InputError({.what = "no colour",
                          .where = "PlacePartitioner",
                          .value = "0",
                          .allowed = "1 colour or more"});
    }
    colours_ = std::move(colours);
    partition.colours.assign(colours_.size(), {});
    for (std::size_t c = 0; c < colours_.size(); ++c) {
        if (colours_[c].submeshes == 1) {
            partition.colours[c].regions.emplace_back(); // the whole mesh
            continue;
        }
        for (std::uint32_t i = 0; i < colours_[c].submeshes; ++i) {
            Region region;
            region.kind = Region::Kind::places;
            region.place = &call_place;
            region.context = &colours_[c];
            region.label = i;
            partition.colours[c].regions.push_back(region);
        }
    }
}

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
    // Where the interface passes from one region to the next, the second colour has a site.
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

#define DSC_INSTANTIATE(Real)                                                                      \
    template class PlacePartitioner<Real>;                                                         \
    template std::vector<PlaceColour> voronoi_colours(const PartitionInput<Real>&, std::uint32_t,  \
                                                      int);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
