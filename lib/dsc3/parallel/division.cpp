// SPDX-License-Identifier: MIT
#include "dsc3/parallel/division.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace dsc3 {

namespace {

// Lengths in edge lengths: the footprint of a repair, the smallest cell that is cut again, and the
// interface from which there are eight submeshes.
constexpr Real footprint = 3.5;
constexpr Real min_extent = 16;
constexpr Real large_extent = 60;
// A sample is enough to find cuts.
constexpr std::size_t sample_size = 1500;
constexpr std::size_t min_sample = 16;
// The price of unequal shares: in the first colour, and in the others, which have less work.
constexpr Real balance_price = 0.5;
constexpr Real later_balance_price = 0.2;

struct Extent {
    Point low = Point::Constant(std::numeric_limits<Real>::infinity());
    Point high = Point::Constant(-std::numeric_limits<Real>::infinity());
};

Extent extent_of(std::span<const Point> places) {
    Extent extent;
    for (const Point& p : places) {
        extent.low = extent.low.cwiseMin(p);
        extent.high = extent.high.cwiseMax(p);
    }
    return extent;
}

class Cutter {
public:
    Cutter(CutTree& tree, Real edge_length, Real price)
        : tree_(tree), edge_length_(edge_length), price_(price) {}

    void cut(std::span<Point> places, std::uint32_t node, std::uint32_t level) {
        if (level == tree_.levels) {
            return;
        }
        const auto [axis, place] = best(places, level);
        tree_.axes[node] = axis;
        tree_.cuts[node] = place;
        const auto middle = std::stable_partition(
            places.begin(), places.end(),
            [axis = axis, place = place](const Point& p) { return p[axis] < place; });
        const auto lower = static_cast<std::size_t>(middle - places.begin());
        cut(places.first(lower), 2 * node, level + 1);
        cut(places.subspan(lower), 2 * node + 1, level + 1);
    }

private:
    struct Plane {
        std::uint8_t axis = 0;
        Real place = std::numeric_limits<Real>::infinity();
    };

    Plane best(std::span<const Point> places, std::uint32_t level) {
        Plane plane;
        const std::size_t n = places.size();
        if (n < min_sample) {
            return plane;
        }
        const Extent extent = extent_of(places);
        Real least = std::numeric_limits<Real>::infinity();
        for (std::uint8_t axis = 0; axis < 3; ++axis) {
            if (level > 0 && extent.high[axis] - extent.low[axis] < min_extent * edge_length_) {
                continue;
            }
            coordinates_.clear();
            for (const Point& p : places) {
                coordinates_.push_back(p[axis]);
            }
            std::sort(coordinates_.begin(), coordinates_.end());
            const Real near = footprint * edge_length_;
            std::size_t first = 0;
            std::size_t last = 0;
            for (std::size_t i = n / 5; i < n - n / 5; ++i) {
                const Real at = coordinates_[i];
                while (coordinates_[first] < at - near) {
                    ++first;
                }
                while (last < n && coordinates_[last] < at + near) {
                    ++last;
                }
                const Real off = std::abs(2 * static_cast<Real>(i) / static_cast<Real>(n) - 1);
                const Real cost =
                    static_cast<Real>(last - first) / static_cast<Real>(n) + price_ * off;
                if (cost < least) {
                    least = cost;
                    plane = {axis, at};
                }
            }
        }
        return plane;
    }

    CutTree& tree_;
    Real edge_length_;
    Real price_;
    std::vector<Real> coordinates_;
};

} // namespace

std::array<CutTree, colour_count> cut_colours(std::vector<Point>& places, std::uint32_t submeshes,
                                              Real edge_length) {
    std::array<CutTree, colour_count> trees;
    const Extent extent = extent_of(places);
    if (submeshes == 0) {
        const bool is_large = (extent.high - extent.low).maxCoeff() >= large_extent * edge_length;
        submeshes = is_large ? default_limit : default_limit / 2;
    }
    std::vector<Point> sample;
    std::vector<Point> near;
    for (CutTree& tree : trees) {
        tree.levels = static_cast<std::uint32_t>(std::bit_width(submeshes) - 1);
        const std::size_t size = std::min(places.size(), sample_size);
        sample.clear();
        for (std::size_t i = 0; i < size; ++i) {
            sample.push_back(places[i * places.size() / size]);
        }
        Cutter(tree, edge_length, &tree == &trees[0] ? balance_price : later_balance_price)
            .cut(sample, 1, 0);
        near.clear();
        for (const Point& p : places) {
            if (tree.distance(p) < footprint * edge_length) {
                near.push_back(p);
            }
        }
        if (near.size() > min_sample) {
            places.swap(near);
        }
    }
    return trees;
}

} // namespace dsc3
