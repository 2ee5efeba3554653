// SPDX-License-Identifier: MIT
#include "dsc/parallel/slabs.h"

#include <algorithm>
#include <limits>

namespace dsc {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Inner cuts, ascending, with those dropped that leave a slab thinner than allowed.
std::vector<double> close_cuts(const std::vector<double>& inner, double low, double high,
                               double least_width) {
    std::vector<double> cuts{-infinity};
    double last = low;
    for (const double cut : inner) {
        if (cut - last >= least_width && high - cut >= least_width) {
            cuts.push_back(cut);
            last = cut;
        }
    }
    cuts.push_back(infinity);
    return cuts;
}

} // namespace

Cuts cuts_of_equal_share(std::vector<double>& positions, std::uint32_t slabs, double least_width) {
    if (positions.empty() || slabs < 2) {
        return {{-infinity, infinity}, {-infinity, infinity}};
    }
    std::sort(positions.begin(), positions.end());
    const auto share = [&](double fraction) {
        const auto at = static_cast<std::size_t>(fraction * static_cast<double>(positions.size()));
        return positions[std::min(at, positions.size() - 1)];
    };
    std::vector<double> red;
    std::vector<double> black;
    for (std::uint32_t i = 0; i < slabs; ++i) {
        const auto n = static_cast<double>(slabs);
        if (i > 0) {
            red.push_back(share(i / n));
        }
        black.push_back(share((i + 0.5) / n));
    }
    const double low = positions.front();
    const double high = positions.back();
    // The half slabs at the two ends are thin by design; only the full ones need the width.
    return {close_cuts(red, low, high, least_width),
            close_cuts(black, low - least_width, high + least_width, least_width)};
}

Cuts cuts_of_equal_width(double low, double high, std::uint32_t slabs, double least_width) {
    std::vector<double> red;
    std::vector<double> black;
    const double width = (high - low) / slabs;
    for (std::uint32_t i = 0; i < slabs; ++i) {
        if (i > 0) {
            red.push_back(low + i * width);
        }
        black.push_back(low + (i + 0.5) * width);
    }
    return {close_cuts(red, low, high, least_width),
            close_cuts(black, low - least_width, high + least_width, least_width)};
}

std::size_t slab_of(std::span<const double> cuts, double s) {
    // Outer cuts are infinite: the answer is always inside.
    const auto after = std::upper_bound(cuts.begin() + 1, cuts.end() - 1, s);
    return static_cast<std::size_t>(after - cuts.begin()) - 1;
}

Region slab_region(std::span<const double> cuts, std::size_t i, double normal_x, double normal_y) {
    Region region;
    region.kind = Region::Kind::slab;
    region.normal_x = normal_x;
    region.normal_y = normal_y;
    region.low = cuts[i];
    region.high = cuts[i + 1];
    return region;
}

} // namespace dsc
