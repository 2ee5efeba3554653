// SPDX-License-Identifier: MIT
#include "dsc/parallel/cells.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace dsc {

namespace {

using Site = CellTree::Site;

struct Cut {
    double at;
    double cost;
    std::size_t left; // sites before it
};

double coordinate(const Site& site, bool upright) { return upright ? site.y : site.x; }

void sort_along(std::span<Site> sites, bool upright) {
    std::sort(sites.begin(), sites.end(), [upright](const Site& a, const Site& b) {
        const double first = coordinate(a, upright);
        const double second = coordinate(b, upright);
        return first < second || (first == second && coordinate(a, !upright) < coordinate(b, !upright));
    });
}

// The best cut of sites that are sorted along the axis, with about `share` of the weight before it.
std::optional<Cut> best_cut(std::span<const Site> sites, bool upright, double share, double band,
                            double least_width, std::uint32_t least_sites) {
    double total = 0;
    for (const Site& site : sites) {
        total += static_cast<double>(site.weight);
    }
    const double low = coordinate(sites.front(), upright);
    const double high = coordinate(sites.back(), upright);
    // A share that is off costs what the others wait; a site in the band is done by two colours.
    constexpr double tolerance = 0.12;
    constexpr double band_price = 2;
    std::optional<Cut> best;
    double passed = 0;
    std::size_t band_begin = 0;
    std::size_t band_end = 0;
    for (std::size_t i = 1; i < sites.size(); ++i) {
        passed += static_cast<double>(sites[i - 1].weight);
        const double off = std::abs(passed / total - share);
        const double before = coordinate(sites[i - 1], upright);
        const double after = coordinate(sites[i], upright);
        if (off > tolerance || after <= before || i < least_sites ||
            sites.size() - i < least_sites) {
            continue;
        }
        const double at = before + 0.5 * (after - before);
        if (at - low < least_width || high - at < least_width || !(before < at)) {
            continue;
        }
        while (coordinate(sites[band_begin], upright) < at - band) {
            ++band_begin;
        }
        band_end = std::max(band_end, band_begin);
        while (band_end < sites.size() && coordinate(sites[band_end], upright) <= at + band) {
            ++band_end;
        }
        const double cost = band_price * static_cast<double>(band_end - band_begin) +
                            off * static_cast<double>(sites.size());
        if (!best || cost < best->cost) {
            best = Cut{at, cost, i};
        }
    }
    return best;
}

} // namespace

void CellTree::divide(std::span<Site> sites, const Region& box, std::uint32_t cells, double band,
                      double least_width, std::uint32_t least_sites,
                      std::vector<Region>& boxes) {
    if (cells < 2 || sites.size() < 2 * static_cast<std::size_t>(least_sites)) {
        boxes.push_back(box);
        return;
    }
    const std::uint32_t first = cells / 2;
    const double share = static_cast<double>(first) / cells;
    sort_along(sites, false);
    const auto across = best_cut(sites, false, share, band, least_width, least_sites);
    sort_along(sites, true);
    const auto up = best_cut(sites, true, share, band, least_width, least_sites);
    if (!across && !up) {
        boxes.push_back(box);
        return;
    }
    const bool upright = up && (!across || up->cost < across->cost);
    const Cut& cut = upright ? *up : *across;
    if (!upright) {
        sort_along(sites, false);
    }
    Region low = box;
    Region high = box;
    low.kind = high.kind = Region::Kind::box;
    (upright ? low.side_high : low.high) = cut.at;
    (upright ? high.side_low : high.low) = cut.at;
    divide(sites.subspan(0, cut.left), low, first, band, least_width, least_sites, boxes);
    divide(sites.subspan(cut.left), high, cells - first, band, least_width, least_sites, boxes);
}

template <class Real>
CellPartitioner<Real>::CellPartitioner(const CellOptions& options) : options_(options) {
    const auto refuse = [](const char* what, const std::string& value, const char* allowed) {
        throw InputError("value out of range", what, value, allowed);
    };
    if (options.submeshes > 65536) {
        refuse("submeshes", std::to_string(options.submeshes), "0 (automatic) to 65536");
    }
    if (options.vertices_per_cell < 1) {
        refuse("vertices_per_cell", "0", "1 or more");
    }
    if (!(options.least_width >= 2) || !std::isfinite(options.least_width)) {
        refuse("least_width", std::to_string(options.least_width), "2 edge lengths or more");
    }
    if (!(options.band >= 0) || !std::isfinite(options.band)) {
        refuse("band", std::to_string(options.band), "0 edge lengths or more");
    }
    if (options.recut < 1 || options.recut_later < 1) {
        refuse("recut", "0", "1 step or more");
    }
}

template <class Real>
Recut CellPartitioner<Real>::is_due(const PartitionStatus& status) const {
    if (status.steps_since_all >= options_.recut) {
        return Recut::all;
    }
    return status.steps_since_all % options_.recut_later == 0 ? Recut::later : Recut::none;
}

template <class Real>
void CellPartitioner<Real>::divide(const PartitionInput<Real>& input, Recut recut,
                                   Partition& partition) {
    const double band = options_.band * input.edge_length;
    const double least_width = options_.least_width * input.edge_length;
    const std::uint32_t automatic = std::max<std::uint32_t>(
        1, static_cast<std::uint32_t>(input.interface.size()) / options_.vertices_per_cell);
    // An even number, so that two threads have the same.
    const std::uint32_t wanted =
        options_.submeshes > 0 ? options_.submeshes : automatic - (automatic > 1 ? automatic % 2 : 0);
    const auto site_of = [&](std::size_t i) {
        const auto& record = input.complex.vertices[input.interface[i]];
        return Site{static_cast<double>(record.x), static_cast<double>(record.y), input.work[i]};
    };
    if (recut == Recut::all) {
        sites_.clear();
        for (std::size_t i = 0; i < input.interface.size(); ++i) {
            sites_.push_back(site_of(i));
        }
        partition.colours.assign(1, {});
        CellTree::divide(sites_, Region{}, wanted, band, least_width, options_.least_vertices,
                         partition.colours.front().regions);
    }
    const Colour& first = partition.colours.front();
    if (first.regions.size() < 2) {
        partition.colours.resize(1);
        return;
    }
    // The second colour: what lies near the cuts of the first.
    sites_.clear();
    std::size_t at = 0;
    for (std::size_t i = 0; i < input.interface.size(); ++i) {
        const Site site = site_of(i);
        at = first.locate(input.interface[i], site.x, site.y, at);
        const Region& box = first.regions[std::min(at, first.regions.size() - 1)];
        if (site.x - box.low < band || box.high - site.x < band || site.y - box.side_low < band ||
            box.side_high - site.y < band) {
            sites_.push_back({site.x, site.y, 1.0F});
        }
    }
    const auto cells = static_cast<std::uint32_t>(first.regions.size());
    partition.colours.resize(2);
    partition.colours[1].regions.clear();
    CellTree::divide(sites_, Region{}, cells, band, least_width, 4,
                     partition.colours[1].regions);
    if (partition.colours[1].regions.size() == 1) {
        partition.colours[1].regions.front() = Region{}; // one submesh: the whole mesh
    }
}

template class CellPartitioner<double>;
template class CellPartitioner<float>;

} // namespace dsc
