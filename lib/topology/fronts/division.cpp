// SPDX-License-Identifier: MIT
#include "topology/fronts/division.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_split.h"
#include "topology/fronts/arrival.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace dsc {

namespace {

/// Fronts that arrive within this of each other, in edge lengths, arrive at the same time.
constexpr double same_time = 0.02;
/// Edges are split no nearer to their ends than this share of their length.
constexpr double end_share = 0.1;
/// New edges may have to be split once more where three fronts arrive.
constexpr int rounds_of_division = 3;
constexpr int halvings = 24;

template <class Real>
class Division {
public:
    Division(TopologyWork<Real>& work, std::span<const Triangle> part,
             std::span<const Phase> takers)
        : work_(work), complex_(work.complex), takers_(takers), order_(part.begin(), part.end()),
          fronts_(work, part) {
        for (const Triangle t : part) {
            inside_.insert(t.id);
        }
    }

    std::vector<Share> run() {
        for (int round = 0; round < rounds_of_division && split_edges(); ++round) {
        }
        std::vector<Share> shares;
        shares.reserve(order_.size());
        for (const Triangle t : order_) {
            shares.push_back({t, takers_[first(centroid(complex_, t))]});
        }
        return shares;
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    [[nodiscard]] Real arrival(std::size_t taker, const Point<Real>& place) const {
        return fronts_.way_of(takers_[taker], place);
    }

    [[nodiscard]] std::size_t first(const Point<Real>& place) const {
        std::size_t best = 0;
        Real least = std::numeric_limits<Real>::infinity();
        for (std::size_t i = 0; i < takers_.size(); ++i) {
            if (const Real one = arrival(i, place); one < least) {
                least = one;
                best = i;
            }
        }
        return best;
    }

    // Splits each edge whose ends are reached by different fronts; returns whether there was any.
    bool split_edges() {
        bool is_split = false;
        // New triangles wait for the next round: the cuts of a strip between two fronts would come
        // nearer and nearer to its end without ever reaching it.
        const std::size_t size = order_.size();
        for (std::size_t i = 0; i < size; ++i) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const Corner c = corner_of(order_[i].id, k);
                const Corner across = complex_.twin(c);
                if (!is_sheet(complex_, c) &&
                    (c < across || !inside_.contains(triangle_of(across)))) {
                    is_split = split(c) || is_split;
                }
            }
        }
        return is_split;
    }

    bool split(Corner c) {
        const Point<Real> from = at(complex_.vertex(next(c)));
        const Point<Real> way = direction(complex_, c);
        const std::size_t one = first(from);
        const std::size_t other = first(from + way);
        const auto lead = [&](Real share) { // of the second front
            const Point<Real> place = from + share * way;
            return arrival(one, place) - arrival(other, place);
        };
        const Real slack = static_cast<Real>(same_time) * work_.edge_length;
        if (one == other || -lead(0) < slack || lead(1) < slack) {
            return false;
        }
        Real low = 0;
        Real high = 1;
        for (int i = 0; i < halvings; ++i) {
            const Real middle = (low + high) / 2;
            (lead(middle) < 0 ? low : high) = middle;
        }
        if (std::min(low, 1 - high) < static_cast<Real>(end_share)) {
            return false;
        }
        const std::array<std::uint32_t, 2> apexes{
            inside_.contains(triangle_of(c)) ? complex_.vertex(c) : no_id,
            inside_.contains(triangle_of(complex_.twin(c))) ? complex_.vertex(complex_.twin(c))
                                                            : no_id};
        const SplitResult split = edge_split(submesh_, c, Point<Real>(from + low * way));
        if (split.verdict != Verdict::legal) {
            return false;
        }
        for_each_corner(complex_, split.vertex, [&](Corner k) {
            for (const std::uint32_t apex : apexes) {
                if (apex != no_id &&
                    (complex_.vertex(next(k)) == apex || complex_.vertex(prev(k)) == apex) &&
                    inside_.insert(triangle_of(k)).second) {
                    order_.push_back(Triangle{triangle_of(k)});
                }
            }
        });
        return true;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_{complex_};
    std::span<const Phase> takers_;
    std::vector<Triangle> order_;
    std::unordered_set<std::uint32_t> inside_; ///< the same triangles
    Arrival<Real> fronts_;
};

} // namespace

template <class Real>
std::vector<Share> divide_by_arrival(TopologyWork<Real>& work, std::span<const Triangle> part,
                                     std::span<const Phase> takers) {
    return Division<Real>(work, part, takers).run();
}

template std::vector<Share> divide_by_arrival(TopologyWork<double>&, std::span<const Triangle>,
                                              std::span<const Phase>);
template std::vector<Share> divide_by_arrival(TopologyWork<float>&, std::span<const Triangle>,
                                              std::span<const Phase>);

} // namespace dsc
