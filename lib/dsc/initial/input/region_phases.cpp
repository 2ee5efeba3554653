// SPDX-License-Identifier: MIT
#include "dsc/initial/input/region_phases.h"

#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/line.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;
using Shapes = std::vector<std::uint32_t>; // shapes that cover a region, ascending

// --- which shapes cover the regions on both sides of each edge -----------------------------------

// The sides of an edge, as numbers.
std::uint32_t left_of(std::uint32_t e) { return 2 * e; }
std::uint32_t right_of(std::uint32_t e) { return 2 * e + 1; }

// One sweep from left to right over edges that meet at ends only (compare contacts.cpp).
class Regions {
public:
    Regions(const NodedShapes& noded) : points_(noded.points), edges_(noded.edges) {
        covering_.resize(2 * edges_.size());
        region_.resize(2 * edges_.size());
        std::iota(region_.begin(), region_.end(), 0U);
    }

    // Points are numbered from left to right, and edges run so: what is on their left lies above.
    void run() {
        std::vector<std::array<std::uint32_t, 3>> events; // point, begins, edge
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            events.push_back({edges_[e].from, 1, e});
            events.push_back({edges_[e].to, 0, e});
        }
        std::ranges::sort(events);
        const auto below = [this](std::uint32_t s, std::uint32_t t) { return is_below(s, t); };
        std::set<std::uint32_t, decltype(below)> status(below);
        std::vector<decltype(status)::iterator> places(edges_.size());
        for (std::size_t i = 0; i < events.size();) {
            std::size_t after = i;
            std::vector<std::uint32_t> ended;
            std::vector<std::uint32_t> begun;
            for (; after < events.size() && events[after][0] == events[i][0]; ++after) {
                (events[after][1] == 0 ? ended : begun).push_back(events[after][2]);
            }
            std::ranges::sort(ended, below);
            std::ranges::sort(begun, below);
            for (const std::uint32_t e : ended) {
                status.erase(places[e]);
            }
            for (const std::uint32_t e : begun) {
                places[e] = status.insert(e).first;
                const bool is_lowest = places[e] == status.begin();
                const std::uint32_t below_it = is_lowest ? e : *std::prev(places[e]);
                Shapes& right = covering_[right_of(e)];
                right = is_lowest ? Shapes{} : covering_[left_of(below_it)];
                std::ranges::set_symmetric_difference(right, edges_[e].shapes,
                                                      std::back_inserter(covering_[left_of(e)]));
                if (!is_lowest && ended.empty() && e == begun.front()) {
                    unite(right_of(e), left_of(below_it));
                }
            }
            unite_around(ended, begun);
            i = after;
        }
        for (std::uint32_t side = 0; side < region_.size(); ++side) {
            region_[side] = root_of(side);
        }
    }

    // The shapes that cover the region at one side of an edge.
    [[nodiscard]] const Shapes& covering(std::uint32_t side) const { return covering_[side]; }
    [[nodiscard]] std::uint32_t region(std::uint32_t side) const { return region_[side]; }

private:
    // Unites the regions about a point by the edges that end and begin there, each list from below.
    void unite_around(std::span<const std::uint32_t> ended, std::span<const std::uint32_t> begun) {
        for (const auto list : {ended, begun}) {
            for (std::size_t i = 1; i < list.size(); ++i) {
                unite(left_of(list[i - 1]), right_of(list[i]));
            }
        }
        const auto& first = ended.empty() ? begun : ended;
        const auto& second = begun.empty() ? ended : begun;
        if (ended.empty() || begun.empty()) {
            unite(right_of(first.front()), left_of(first.back()));
        } else {
            unite(right_of(first.front()), right_of(second.front()));
            unite(left_of(first.back()), left_of(second.back()));
        }
    }
    [[nodiscard]] std::uint32_t root_of(std::uint32_t side) {
        while (region_[side] != side) {
            region_[side] = region_[region_[side]];
            side = region_[side];
        }
        return side;
    }
    void unite(std::uint32_t one, std::uint32_t other) {
        const std::uint32_t a = root_of(one);
        const std::uint32_t b = root_of(other);
        region_[std::max(a, b)] = std::min(a, b);
    }
    [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation<double>(points_[a], points_[b], points_[c]);
    }
    [[nodiscard]] bool is_below(std::uint32_t s, std::uint32_t t) const {
        if (s == t) {
            return false;
        }
        const NodedEdge& one = edges_[s];
        const NodedEdge& other = edges_[t];
        if (one.from == other.from) {
            return side(other.from, other.to, one.to) < 0;
        }
        return other.from < one.from ? side(other.from, other.to, one.from) < 0
                                     : side(one.from, one.to, other.from) > 0;
    }

    const Points& points_;
    const std::vector<NodedEdge>& edges_;
    std::vector<Shapes> covering_;      // by side
    std::vector<std::uint32_t> region_; // by side: the smallest side of the region
};

// --- phases --------------------------------------------------------------------------------------

// The phase of each region: that of the innermost shape, by the even-odd rule among shapes of one
// phase.
class Phases {
public:
    Phases(std::span<const Shape> shapes, const NodedShapes& noded, const Regions& regions,
           const InitialOptions& options)
        : shapes_(shapes), noded_(noded), regions_(regions), options_(options),
          sides_of_(shapes.size() + 1, 0) {
        for (std::uint32_t e = 0; e < noded.edges.size(); ++e) {
            count(regions.covering(left_of(e)), middle_of(e));
            count(regions.covering(right_of(e)), middle_of(e));
        }
        for (const auto& [pair, common] : common_) {
            if (common.sides < std::min(sides_of_[pair.first], sides_of_[pair.second])) {
                if (!gives()) {
                    refuse(pair.first, pair.second);
                }
                overlapping_.push_back(pair);
            }
        }
    }

    // The phases on the left and right of each edge.
    std::vector<std::array<Phase, 2>> of_edges() {
        if (options_.coverage != Coverage::open) {
            measure();
        }
        std::vector<std::array<Phase, 2>> phases(noded_.edges.size());
        for (std::uint32_t side = 0; side < 2 * phases.size(); ++side) {
            phases[side / 2][side % 2] = of_region(side);
        }
        if (options_.coverage != Coverage::open) {
            give_gaps(phases);
        }
        return phases;
    }

private:
    // Whether gaps and overlaps are given to a neighbour.
    [[nodiscard]] bool gives() const {
        return options_.coverage == Coverage::first ||
               options_.coverage == Coverage::longest_border;
    }
    [[nodiscard]] Point<double> middle_of(std::uint32_t e) const {
        const NodedEdge& edge = noded_.edges[e];
        return midpoint(noded_.points[edge.from], noded_.points[edge.to]);
    }
    [[nodiscard]] double length_of(std::uint32_t e) const {
        return distance(noded_.points[noded_.edges[e].from], noded_.points[noded_.edges[e].to]);
    }
    [[nodiscard]] std::uint32_t domain() const {
        return static_cast<std::uint32_t>(shapes_.size());
    }

    [[nodiscard]] bool is_outside(std::uint32_t k) const {
        return k < shapes_.size() && initial::is_outside(shapes_[k]);
    }

    void measure() {
        for (std::uint32_t side = 0; side < 2 * noded_.edges.size(); ++side) {
            const std::uint32_t e = side / 2;
            const Shapes& within = regions_.covering(side);
            const Shapes& beyond = regions_.covering(side ^ 1U);
            Region& region = region_[regions_.region(side)];
            const double length = length_of(e);
            const double area = cross<double>(noded_.points[noded_.edges[e].from],
                                              noded_.points[noded_.edges[e].to]) /
                                2;
            region.area += side == left_of(e) ? area : -area;
            region.border += length;
            // Shapes that continue beyond an overlap, or begin beside a gap.
            const bool is_covered = within != Shapes{domain()};
            for (const std::uint32_t k : beyond) {
                if (k != domain() && !is_outside(k) &&
                    is_covered == std::ranges::binary_search(within, k)) {
                    region.shared[k] += length;
                }
            }
        }
    }

    // Whether `one`, rather than `other`, gets a region that both may get.
    [[nodiscard]] bool goes_before(std::uint32_t one, std::uint32_t other,
                                   const std::map<std::uint32_t, double>& shared) const {
        const auto share = [&](std::uint32_t k) {
            const auto at = shared.find(k);
            return at == shared.end() || options_.coverage == Coverage::first ? 0.0 : at->second;
        };
        return std::pair(-share(one), one) < std::pair(-share(other), other);
    }

    [[nodiscard]] Phase of_region(std::uint32_t side) {
        Shapes covering = regions_.covering(side);
        std::erase(covering, domain());
        if (std::ranges::any_of(covering, [&](std::uint32_t k) { return is_outside(k); })) {
            return border_phase; // whatever else reaches there
        }
        if (!overlapping_.empty() && covering.size() > 1) {
            const std::map<std::uint32_t, double>& shared = region_[regions_.region(side)].shared;
            for (const auto& [one, other] : overlapping_) {
                const bool has_both = std::ranges::binary_search(covering, one) &&
                                      std::ranges::binary_search(covering, other);
                if (has_both) {
                    std::erase(covering, goes_before(one, other, shared) ? other : one);
                }
            }
        }
        return of(std::move(covering));
    }

    // A gap is too narrow for the mesh: its mean width is below the edge length.
    void give_gaps(std::vector<std::array<Phase, 2>>& phases) {
        for (std::uint32_t side = 0; side < 2 * phases.size(); ++side) {
            if (regions_.covering(side) != Shapes{domain()}) {
                continue;
            }
            const Region& region = region_[regions_.region(side)];
            if (region.shared.empty() || 2 * region.area >= options_.edge_length * region.border) {
                continue;
            }
            const std::uint32_t to =
                std::ranges::min_element(region.shared, [&](const auto& a, const auto& b) {
                    return goes_before(a.first, b.first, region.shared);
                })->first;
            if (!gives()) {
                throw InputError({.what = "a gap between shapes",
                                  .where = "beside " + name_of(shapes_, to),
                                  .value = "an area of " + to_text(region.area) + " at " +
                                           to_text(middle_of(side / 2)),
                                  .allowed = "shapes that share their borders; a larger "
                                             "border_tolerance, or a coverage that gives gaps to "
                                             "a neighbour"});
            }
            phases[side / 2][side % 2] = shapes_[to].phase;
        }
    }

public:
private:
    // The phase of a region that these shapes cover.
    [[nodiscard]] Phase of(Shapes covering) const {
        std::ranges::sort(covering, [this](std::uint32_t a, std::uint32_t b) {
            return std::pair(sides_of_[b], a) < std::pair(sides_of_[a], b); // the outermost first
        });
        std::vector<Phase> around;
        for (std::size_t i = 0; i < covering.size(); ++i) {
            const auto is_around = [&](std::uint32_t k) {
                return !around.empty() && around.back() == shapes_[k].phase;
            };
            // If two shapes cover a region, one may be a hole that the other fills.
            if (i + 1 < covering.size() && !is_around(covering[i]) &&
                sides_of_[covering[i]] == sides_of_[covering[i + 1]]) {
                if (!is_around(covering[i + 1])) {
                    refuse(covering[i], covering[i + 1]);
                }
                std::swap(covering[i], covering[i + 1]);
            }
            const std::uint32_t k = covering[i];
            const Phase phase = shapes_[k].phase;
            if (!around.empty() && around.back() == phase) {
                around.pop_back();
            } else {
                around.push_back(phase);
            }
        }
        return around.empty() ? exterior_phase : around.back();
    }

    struct Common {
        std::size_t sides = 0; // of edges that both cover
        Point<double> place{0, 0};
    };

    [[noreturn]] void refuse(std::uint32_t one, std::uint32_t other) const {
        const auto [first, second] = std::pair(std::min(one, other), std::max(one, other));
        throw InputError({.what = "two shapes overlap",
                          .where = name_of(shapes_, second),
                          .value = "common area with " + name_of(shapes_, first) + " at " +
                                   to_text(common_.at({first, second}).place),
                          .allowed = "shapes side by side, or one inside the other; a larger "
                                     "border_tolerance joins borders that are near each other, and "
                                     "coverage first or longest_border gives overlaps to one"});
    }

    void count(const Shapes& covering, const Point<double>& middle) {
        if (std::ranges::any_of(covering, [&](std::uint32_t k) { return is_outside(k); })) {
            return;
        }
        for (std::size_t i = 0; i < covering.size() && covering[i] != domain(); ++i) {
            ++sides_of_[covering[i]];
            for (std::size_t j = i + 1; j < covering.size() && covering[j] != domain(); ++j) {
                Common& common = common_[{covering[i], covering[j]}];
                ++common.sides;
                common.place = middle;
            }
        }
    }

    struct Region {
        double area = 0;
        double border = 0;                      // its length
        std::map<std::uint32_t, double> shared; // length of its border with each shape
    };

    std::span<const Shape> shapes_;
    const NodedShapes& noded_;
    const Regions& regions_;
    const InitialOptions& options_;
    std::map<std::uint32_t, Region> region_; // by its smallest side
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_;
    std::vector<std::size_t> sides_of_; // by shape: of edges that it covers
    std::map<std::pair<std::uint32_t, std::uint32_t>, Common> common_;
};

} // namespace

std::vector<std::array<Phase, 2>> phases_beside(const NodedShapes& noded,
                                                std::span<const Shape> shapes,
                                                const InitialOptions& options) {
    Regions regions(noded);
    regions.run();
    return Phases(shapes, noded, regions, options).of_edges();
}

} // namespace dsc::initial
