// SPDX-License-Identifier: MIT
#include "dsc3/parallel/division.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace dsc3 {

namespace {

// Lengths in edge lengths: the footprint of a repair, and the smallest cell that is cut again.
constexpr Real footprint = 3.5;
constexpr Real min_extent = 16;
// From so many places of work for each submesh, what runs at the same time outweighs what is
// deferred at the cuts: in the first steps of Enright's flow at h = 1/128, up to 16 submeshes
// instead of 4 give eight threads (modelled) a speed-up of 4.1 instead of 3.3, two the same.
constexpr std::size_t min_work = 4000;
constexpr std::uint32_t min_submeshes = 4;
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
    Cutter(CutTree& tree, Division division, Real edge_length, Real price)
        : tree_(tree), division_(division), edge_length_(edge_length), price_(price) {}

    void cut(std::span<Point> places) {
        const Extent extent = extent_of(places);
        const Point lengths = extent.high - extent.low;
        axes_ = {0, 1, 2};
        std::stable_sort(axes_.begin(), axes_.end(),
                         [&](std::uint8_t a, std::uint8_t b) { return lengths[a] > lengths[b]; });
        cut(places, 1, 0, {extent.low[axes_[0]], extent.high[axes_[0]]});
    }

private:
    struct Plane {
        std::uint8_t axis = 0;
        Real place = std::numeric_limits<Real>::infinity();
    };
    struct Range {
        Real low;
        Real high;
    };

    // `range`: of the node, if all cuts are across the longest axis.
    void cut(std::span<Point> places, std::uint32_t node, std::uint32_t level, Range range) {
        if (level == tree_.levels) {
            return;
        }
        const auto [axis, place] = plane_of(places, level, range);
        tree_.axes[node] = axis;
        tree_.cuts[node] = place;
        const auto middle = std::stable_partition(
            places.begin(), places.end(),
            [axis = axis, place = place](const Point& p) { return p[axis] < place; });
        const auto lower = static_cast<std::size_t>(middle - places.begin());
        cut(places.first(lower), 2 * node, level + 1, {range.low, place});
        cut(places.subspan(lower), 2 * node + 1, level + 1, {place, range.high});
    }

    Plane plane_of(std::span<const Point> places, std::uint32_t level, Range range) {
        switch (division_) {
        case Division::fixed: return {axes_[0], (range.low + range.high) / 2};
        case Division::active: return {axes_[0], median(places, axes_[0])};
        case Division::blocks: {
            const std::uint8_t axis = axes_[2 * level < tree_.levels ? 0 : 1];
            return {axis, median(places, axis)};
        }
        case Division::cells: break;
        }
        return best(places, level);
    }

    Real median(std::span<const Point> places, std::uint8_t axis) {
        if (places.size() < min_sample) {
            return std::numeric_limits<Real>::infinity();
        }
        coordinates_.clear();
        for (const Point& p : places) {
            coordinates_.push_back(p[axis]);
        }
        const auto middle = coordinates_.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
        std::nth_element(coordinates_.begin(), middle, coordinates_.end());
        return *middle;
    }

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
    Division division_;
    Real edge_length_;
    Real price_;
    std::array<std::uint8_t, 3> axes_{}; ///< the longest extent first
    std::vector<Real> coordinates_;
};

// The default number. Cells are cut only while they are wide; slabs and blocks would become thin.
std::uint32_t submeshes_for(std::size_t places, const Parallel& parallel) {
    const bool are_cells = parallel.division == Division::cells && !parallel.partition;
    const std::size_t most = are_cells ? submesh_limit : default_slabs;
    return static_cast<std::uint32_t>(
        std::bit_floor(std::clamp<std::size_t>(places / min_work, min_submeshes, most)));
}

// Whether a place of another submesh is within the footprint.
bool is_near_border(const Point& p, const Parallel& parallel, Real edge_length) {
    const std::uint32_t submeshes = partition_size(parallel);
    const std::uint32_t own = parallel.partition(p) % submeshes;
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real way : {-footprint * edge_length, footprint * edge_length}) {
            if (parallel.partition(p + way * Point::Unit(axis)) % submeshes != own) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

std::array<CutTree, colour_count> cut_colours(std::vector<Point>& places, const Parallel& parallel,
                                              Real edge_length) {
    std::array<CutTree, colour_count> trees;
    const std::uint32_t submeshes =
        parallel.submeshes == 0 ? submeshes_for(places.size(), parallel) : parallel.submeshes;
    std::vector<Point> sample;
    std::vector<Point> near;
    for (CutTree& tree : trees) {
        const bool is_first = &tree == &trees[0];
        const bool is_partition = is_first && parallel.partition;
        tree.levels = static_cast<std::uint32_t>(std::bit_width(submeshes) - 1);
        const std::size_t size = std::min(places.size(), sample_size);
        sample.clear();
        for (std::size_t i = 0; i < size; ++i) {
            sample.push_back(places[i * places.size() / size]);
        }
        if (!is_partition) {
            Cutter(tree, is_first ? parallel.division : Division::cells, edge_length,
                   is_first ? balance_price : later_balance_price)
                .cut(sample);
        }
        near.clear();
        for (const Point& p : places) {
            if (is_partition ? is_near_border(p, parallel, edge_length)
                             : tree.distance(p) < footprint * edge_length) {
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
