// SPDX-License-Identifier: MIT
#include "thesis/divisions/slabs.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/parallel/executors.h"
#include "dsc/passes/algorithm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

namespace {

/// More vertices than this do not improve the counting method: sorting all vertices of a large mesh
/// took longer than the steps between two divisions.
constexpr std::size_t max_counted = 32768;

template <class Real>
double along(const Point<double>& normal, const VertexRecord<Real>& record) {
    return normal.x() * static_cast<double>(record.x) + normal.y() * static_cast<double>(record.y);
}

// The corners of the convex hull of the living vertices (Andrew's monotone chain): in any
// direction, one of them is the farthest. O(n log n).
template <class Real>
std::vector<Point<double>> hull_corners(const Complex<Real>& complex) {
    std::vector<Point<double>> points;
    for (const auto& record : complex.vertices) {
        if ((record.flags & vertex_dead) == 0) {
            points.emplace_back(static_cast<double>(record.x), static_cast<double>(record.y));
        }
    }
    std::ranges::sort(points, [](const Point<double>& a, const Point<double>& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Point<double>> hull;
    const auto add_chain = [&hull](const auto& chain) {
        const std::size_t first = hull.size();
        for (const Point<double>& p : chain) {
            while (hull.size() >= first + 2) {
                const Point<double> last = hull.back() - hull[hull.size() - 2];
                const Point<double> next = p - hull.back();
                if (last.x() * next.y() - last.y() * next.x() > 0) {
                    break;
                }
                hull.pop_back();
            }
            hull.push_back(p);
        }
    };
    add_chain(points);
    std::ranges::reverse(points);
    add_chain(points);
    return hull;
}

// Adds the outer cuts, which are infinite, to the inner ones.
std::vector<double> closed(const std::vector<double>& inner) {
    std::vector<double> cuts{-Region::infinity};
    cuts.insert(cuts.end(), inner.begin(), inner.end());
    cuts.push_back(Region::infinity);
    return cuts;
}

bool is_thin(const std::vector<double>& red, double low, double high, double min_width) {
    double last = low;
    for (const double cut : red) {
        if (cut - last < min_width) {
            return true;
        }
        last = cut;
    }
    return high - last < min_width;
}

// Cuts at each n-th of the weight (red), and halfway between (black).
Cuts shares(const std::vector<std::pair<double, float>>& sorted, double total,
            std::uint32_t slabs) {
    Cuts cuts;
    double passed = 0;
    std::uint32_t half = 1; // the next cut lies at half / (2 slabs) of the weight
    for (const auto& [place, weight] : sorted) {
        passed += static_cast<double>(weight);
        while (half < 2 * slabs && passed * 2 * slabs > total * half) {
            (half % 2 == 0 ? cuts.red : cuts.black).push_back(place);
            ++half;
        }
    }
    return cuts;
}

} // namespace

Cuts cuts_of_equal_share(std::vector<std::pair<double, float>>& positions, std::uint32_t slabs,
                         double min_width) {
    if (positions.empty() || slabs < 2) {
        return {{-Region::infinity, Region::infinity}, {-Region::infinity, Region::infinity}};
    }
    std::sort(positions.begin(), positions.end());
    double total = 0;
    for (const auto& [place, weight] : positions) {
        total += static_cast<double>(weight);
    }
    // Fewer slabs are made rather than thin ones; both colours have the same number.
    const double low = positions.front().first;
    const double high = positions.back().first;
    for (std::uint32_t n = slabs; n > 1; --n) {
        const Cuts cuts = shares(positions, total, n);
        if (!is_thin(cuts.red, low, high, min_width)) {
            return {closed(cuts.red), closed(cuts.black)};
        }
    }
    return {closed({}), closed({})};
}

Cuts cuts_of_equal_width(double low, double high, std::uint32_t slabs, double min_width) {
    const double max = min_width > 0 ? (high - low) / min_width : slabs;
    const auto count = static_cast<std::uint32_t>(std::clamp<double>(max, 1, slabs));
    Cuts cuts;
    const double width = (high - low) / count;
    for (std::uint32_t i = 0; i < count && count > 1; ++i) {
        if (i > 0) {
            cuts.red.push_back(low + i * width);
        }
        cuts.black.push_back(low + (i + 0.5) * width);
    }
    return {closed(cuts.red), closed(cuts.black)};
}

Colour slab_colour(std::span<const double> cuts, double normal_x, double normal_y, bool round) {
    Colour colour;
    const std::size_t count = cuts.size() - 1;
    if (count == 1) {
        colour.regions.emplace_back(); // the whole mesh
        return colour;
    }
    Region region;
    region.kind = Region::Kind::box;
    region.normal_x = normal_x;
    region.normal_y = normal_y;
    // If the two end slabs that form one submesh are the whole mesh, there is no gain.
    const bool joins = round && count > 2;
    for (std::size_t i = 0; i < (joins ? count - 1 : count); ++i) {
        region.low = joins && i == 0 ? cuts[count - 1] : cuts[i];
        region.high = cuts[i + 1];
        colour.regions.push_back(region);
    }
    return colour;
}

namespace {

// The unit vector along which points scatter most (first principal component). O(n).
template <class Real>
Point<double> principal_direction(const Complex<Real>& complex,
                                  std::span<const std::uint32_t> vertices) {
    if (vertices.empty()) {
        return {1, 0};
    }
    Point<double> mean = Point<double>::Zero();
    for (const std::uint32_t v : vertices) {
        mean += complex.position(Vertex{v}).template cast<double>();
    }
    mean /= static_cast<double>(vertices.size());
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const std::uint32_t v : vertices) {
        const Point<double> d = complex.position(Vertex{v}).template cast<double>() - mean;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

template <class Real>
SlabPartitioner<Real>::SlabPartitioner(const SlabOptions& options) : options_(options) {
    require(options.submeshes >= 1 && options.submeshes <= 65536, "submeshes", options.submeshes,
            "1 to 65536");
    require(std::isfinite(options.degrees), "degrees", options.degrees, "a finite angle");
    require(options.min_width >= 2, "min_width", options.min_width, "2 edge lengths or more");
    require(options.recut >= 1, "recut", options.recut, "1 step or more");
}

template <class Real>
Recut SlabPartitioner<Real>::is_due(const PartitionStatus& status) const {
    return status.steps_since_all >= options_.recut ? Recut::all : Recut::none;
}

// Finds the extent of the mesh along the normal. The mesh is searched only once, because its domain
// does not change.
template <class Real>
void SlabPartitioner<Real>::find_extent(const Complex<Real>& complex, const Point<double>& normal) {
    if (normal == extent_of_) {
        return;
    }
    extent_of_ = normal;
    low_ = Region::infinity;
    high_ = -Region::infinity;
    if (options_.follow_shape) { // the direction changes each time
        if (corners_.empty()) {
            corners_ = hull_corners(complex);
        }
        for (const Point<double>& corner : corners_) {
            low_ = std::min(low_, normal.dot(corner));
            high_ = std::max(high_, normal.dot(corner));
        }
        return;
    }
    for (const auto& record : complex.vertices) {
        if ((record.flags & vertex_dead) == 0) {
            low_ = std::min(low_, along(normal, record));
            high_ = std::max(high_, along(normal, record));
        }
    }
}

template <class Real>
void SlabPartitioner<Real>::divide(const PartitionInput<Real>& input, Recut /*recut*/,
                                   Partition& partition) {
    const double radians = options_.degrees * std::numbers::pi / 180;
    // At 90 degrees the axis is set exactly, because the cosine of a right angle is not zero in
    // floating point.
    const bool upright = options_.degrees == 90;
    const Point<double> normal =
        options_.follow_shape
            ? principal_direction(input.complex, input.interface)
            : (upright ? Point<double>(0, 1) : Point<double>(std::cos(radians), std::sin(radians)));
    const double min = options_.min_width * input.edge_length;
    Cuts cuts;
    if (options_.slabbing == Slabbing::fixed) {
        find_extent(input.complex, normal);
        cuts = cuts_of_equal_width(low_, high_, options_.submeshes, min);
    } else {
        std::vector<std::pair<double, float>> places;
        if (options_.slabbing == Slabbing::active) {
            for (std::size_t i = 0; i < input.interface.size(); ++i) {
                places.emplace_back(along(normal, input.complex.vertices[input.interface[i]]),
                                    input.work[i]);
            }
        } else {
            // Every vertex stands for the two triangles that it owns on average, and in a large
            // mesh also for the vertices with neighbouring numbers, which lie near it.
            const auto& vertices = input.complex.vertices;
            for (std::size_t v = 0; v < vertices.size(); v += 1 + vertices.size() / max_counted) {
                if ((vertices[v].flags & vertex_dead) == 0) {
                    places.emplace_back(along(normal, vertices[v]), 1.0F);
                }
            }
        }
        cuts = cuts_of_equal_share(places, options_.submeshes, min);
    }
    partition.colours = {slab_colour(cuts.red, normal.x(), normal.y(), false)};
    if (partition.colours.front().regions.size() > 1) {
        partition.colours.push_back(slab_colour(cuts.black, normal.x(), normal.y(), true));
    }
}

template class SlabPartitioner<double>;
template class SlabPartitioner<float>;

namespace {

template <class Real, Slabbing slabbing>
std::unique_ptr<Executor<Real>> slabs(Complex<Real>& complex, const Options<Real>& options,
                                      const Parallel& parallel, Algorithm<Real> algorithm) {
    return make_executor<Real>(complex, options, parallel,
                               std::make_unique<SlabPartitioner<Real>>(SlabOptions{
                                   .slabbing = slabbing, .submeshes = submeshes_of(parallel)}),
                               std::move(algorithm));
}

} // namespace

constinit const Division fixed_division{"fixed", "slabs of equal width (thesis, section 6.3)",
                                        SlabOptions{}.submeshes, slabs<double, Slabbing::fixed>,
                                        slabs<float, Slabbing::fixed>};
constinit const Division counting_division{
    "counting", "slabs of equal numbers of triangles (thesis, section 6.3)",
    SlabOptions{}.submeshes, slabs<double, Slabbing::counting>, slabs<float, Slabbing::counting>};
constinit const Division active_division{"active", "slabs of equal work", SlabOptions{}.submeshes,
                                         slabs<double, Slabbing::active>,
                                         slabs<float, Slabbing::active>};

} // namespace dsc
