// SPDX-License-Identifier: MIT
#include "dsc/parallel/partition/cuts.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace dsc {

namespace {

/// The last colour is small, and may be a single cell.
constexpr std::size_t max_colours = 3;

struct Cut {
    double at;
    double cost;
    std::size_t before; // sites
};

double coordinate(const Site& site, bool upright) { return upright ? site.y : site.x; }

void sort_along(std::vector<Site>& sites, bool upright) {
    std::sort(sites.begin(), sites.end(), [upright](const Site& a, const Site& b) {
        const double first = coordinate(a, upright);
        const double second = coordinate(b, upright);
        return first < second ||
               (first == second && coordinate(a, !upright) < coordinate(b, !upright));
    });
}

// The best cut of sites sorted along the axis, with about `share` of the weight before it.
std::optional<Cut> best_cut(std::span<const Site> sites, bool upright, double share,
                            const CutRules& rules) {
    double total = 0;
    for (const Site& site : sites) {
        total += static_cast<double>(site.weight);
    }
    const double low = coordinate(sites.front(), upright);
    const double high = coordinate(sites.back(), upright);
    std::optional<Cut> best;
    double passed = 0;
    std::size_t band_begin = 0;
    std::size_t band_end = 0;
    for (std::size_t i = 1; i < sites.size(); ++i) {
        passed += static_cast<double>(sites[i - 1].weight);
        const double off = std::abs(passed / total - share);
        const double last = coordinate(sites[i - 1], upright);
        const double next = coordinate(sites[i], upright);
        const double at = last + 0.5 * (next - last);
        if (off > rules.tolerance || i < rules.min_sites || sites.size() - i < rules.min_sites ||
            !(last < at && at < next) || at - low < rules.min_width ||
            high - at < rules.min_width) {
            continue;
        }
        while (coordinate(sites[band_begin], upright) < at - rules.band) {
            ++band_begin;
        }
        band_end = std::max(band_end, band_begin);
        while (band_end < sites.size() && coordinate(sites[band_end], upright) <= at + rules.band) {
            ++band_end;
        }
        const double cost = rules.band_price * static_cast<double>(band_end - band_begin) +
                            off * static_cast<double>(sites.size());
        if (!best || cost < best->cost) {
            best = Cut{at, cost, i};
        }
    }
    return best;
}

// The sites are kept sorted along both axes: sorted once, then only split.
class Divider {
public:
    Divider(std::vector<Site>& sites, const CutRules& rules)
        : along_x_(sites), along_y_(sites), scratch_(sites.size()), rules_(rules) {
        sort_along(along_x_, false);
        sort_along(along_y_, true);
    }

    void divide(std::size_t begin, std::size_t end, const Region& box, std::uint32_t cells) {
        if (cells < 2 || end - begin < 2 * std::max<std::size_t>(rules_.min_sites, 1)) {
            boxes.push_back(box);
            return;
        }
        const std::uint32_t first = cells / 2;
        const double share = static_cast<double>(first) / cells;
        const auto span = [&](const std::vector<Site>& sites) {
            return std::span<const Site>(sites).subspan(begin, end - begin);
        };
        const auto across = best_cut(span(along_x_), false, share, rules_);
        const auto up = best_cut(span(along_y_), true, share, rules_);
        if (!across && !up) {
            boxes.push_back(box);
            return;
        }
        const bool upright = up && (!across || up->cost < across->cost);
        const Cut& cut = upright ? *up : *across;
        split(upright ? along_x_ : along_y_, begin, end, upright, cut.at);
        Region low = box;
        Region high = box;
        low.kind = high.kind = Region::Kind::box;
        (upright ? low.side_high : low.high) = cut.at;
        (upright ? high.side_low : high.low) = cut.at;
        divide(begin, begin + cut.before, low, first);
        divide(begin + cut.before, end, high, cells - first);
    }

    std::vector<Region> boxes;

private:
    // Sites before the cut come first; both parts keep their order.
    void split(std::vector<Site>& sites, std::size_t begin, std::size_t end, bool upright,
               double at) {
        std::size_t kept = begin;
        std::size_t moved = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (coordinate(sites[i], upright) < at) {
                sites[kept++] = sites[i];
            } else {
                scratch_[moved++] = sites[i];
            }
        }
        std::copy_n(scratch_.begin(), moved, sites.begin() + static_cast<std::ptrdiff_t>(kept));
    }

    std::vector<Site>& along_x_;
    std::vector<Site> along_y_;
    std::vector<Site> scratch_;
    const CutRules& rules_;
};

// Whether a point is nearer than `band` to a side of the box.
bool is_near_side(const Region& box, const Site& site, double band) {
    return site.x - box.low < band || box.high - site.x < band || site.y - box.side_low < band ||
           box.side_high - site.y < band;
}

// Small cells spread the load; large ones have less boundary, where stars are gathered twice and
// two cores exchange cache lines. The best number of cells grows like the number of vertices to the
// power of 0.4: two cells below 360 vertices, four below 2,000, eight below 11,600. Twice as many
// take 4 to 10 % longer on one thread, and on two where a word takes half a microsecond from core
// to core. It is a power of two, so that two, four or eight threads have equal shares.
std::uint32_t cells_that_pay(std::size_t vertices) {
    const double doublings = 0.4 * std::log2(static_cast<double>(vertices) + 1) - 1.9;
    return static_cast<std::uint32_t>(std::exp2(std::max(0.0, std::round(doublings))));
}

} // namespace

std::vector<Region> divide_sites(std::vector<Site>& sites, std::uint32_t cells,
                                 const CutRules& rules) {
    Divider divider(sites, rules);
    divider.divide(0, sites.size(), Region{}, cells);
    return std::move(divider.boxes);
}

template <class Real>
CellPartitioner<Real>::CellPartitioner(const CellOptions& options) : options_(options) {
    require(options.submeshes <= 65536, "submeshes", options.submeshes, "0 (automatic) to 65536");
    require(options.min_width >= 2 && std::isfinite(options.min_width), "min_width",
            options.min_width, "2 edge lengths or more");
    require(options.band >= 0 && std::isfinite(options.band), "band", options.band,
            "0 edge lengths or more");
    const std::uint32_t min_recut = std::min(options.recut, options.recut_later);
    require(min_recut >= 1, "recut", min_recut, "1 step or more");
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
    CutRules rules;
    rules.band = options_.band * input.edge_length;
    rules.min_width = options_.min_width * input.edge_length;
    rules.min_sites = options_.min_vertices;
    const auto site_of = [&](std::size_t i) {
        const auto& record = input.complex.vertices[input.interface[i]];
        return Site{static_cast<double>(record.x), static_cast<double>(record.y), input.work[i]};
    };
    const std::size_t size = input.interface.size();
    partition.colours.resize(1);
    std::vector<Region>& regions = partition.colours.front().regions;
    if (recut == Recut::all) {
        const std::uint32_t cells =
            options_.submeshes > 0 ? options_.submeshes : cells_that_pay(size);
        sites_.clear();
        for (std::size_t i = 0; cells > 1 && i < size; ++i) {
            sites_.push_back(site_of(i));
        }
        regions = divide_sites(sites_, cells, rules);
    }
    sites_.clear();
    std::size_t at = 0;
    for (std::size_t i = 0; regions.size() > 1 && i < size; ++i) {
        const Site site = site_of(i);
        at = partition.colours.front().locate(input.interface[i], site.x, site.y, at);
        if (is_near_side(regions[std::min(at, regions.size() - 1)], site, rules.band)) {
            sites_.push_back({site.x, site.y, 1.0F});
        }
    }
    const auto cells = static_cast<std::uint32_t>(regions.size());
    // The later colours get the sites near the cuts of the first colour, then near those of the
    // first two. Their cuts follow the gaps between these few sites rather than the balance of
    // work.
    rules.tolerance = 0.5;
    rules.band_price = 8;
    rules.min_sites = 4;
    for (std::size_t later = 1; later < max_colours && !sites_.empty(); ++later) {
        Colour colour;
        colour.regions = divide_sites(sites_, cells, rules);
        std::size_t box = 0;
        std::erase_if(sites_, [&](const Site& site) {
            box = colour.locate(no_id, site.x, site.y, box);
            return box < colour.regions.size() &&
                   !is_near_side(colour.regions[box], site, rules.band);
        });
        partition.colours.push_back(std::move(colour));
    }
}

template class CellPartitioner<double>;
template class CellPartitioner<float>;

} // namespace dsc
