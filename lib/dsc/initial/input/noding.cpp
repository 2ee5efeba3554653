// SPDX-License-Identifier: MIT
#include "dsc/initial/input/noding.h"

#include "dsc/base/error.h"
#include "dsc/geometry/contacts.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/clipping.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace dsc::initial {

namespace {

// --- points and edges ----------------------------------------------------------------------------

class Noding {
public:
    Noding(std::span<const Loop> loops, const Lattice& lattice, double tolerance)
        : loops_(loops), lattice_(lattice), tolerance_(tolerance) {
        for (const Loop& loop : loops) {
            points_.insert(points_.end(), loop.points.begin(), loop.points.end());
        }
        const std::size_t total = points_.size();
        std::ranges::sort(points_, is_left_of);
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        touches_ = points_.size() < total;
        loops_at_.resize(points_.size());
        for (std::uint32_t k = 0; k < loops.size(); ++k) {
            Way& chain = chains_.emplace_back();
            for (std::uint32_t i = 0; i < loops[k].points.size(); ++i) {
                const auto at = std::ranges::lower_bound(points_, loops[k].points[i], is_left_of);
                const auto id = static_cast<std::uint32_t>(at - points_.begin());
                chain.push_back({id, loops[k].numbers[i]});
                add_loop(id, k);
            }
        }
    }

    // Merges points of different loops within the tolerance.
    void join_points() {
        struct Near {
            double distance;
            std::uint32_t one;
            std::uint32_t other;
        };
        std::vector<Near> all;
        for (std::uint32_t i = 0; i < points_.size(); ++i) {
            for (std::uint32_t j = i + 1;
                 j < points_.size() && points_[j].x() - points_[i].x() <= tolerance_; ++j) {
                if (const double d = distance(points_[i], points_[j]); d <= tolerance_) {
                    all.push_back({d, i, j});
                }
            }
        }
        std::ranges::sort(all, [](const Near& a, const Near& b) {
            return std::tie(a.distance, a.one, a.other) < std::tie(b.distance, b.one, b.other);
        });
        std::vector<std::uint32_t> root(points_.size());
        std::iota(root.begin(), root.end(), 0U);
        const auto root_of = [&](std::uint32_t i) {
            while (root[i] != i) {
                i = root[i];
            }
            return i;
        };
        for (const auto& [d, one, other] : all) {
            std::uint32_t a = root_of(one);
            std::uint32_t b = root_of(other);
            std::vector<std::uint32_t> common;
            std::ranges::set_intersection(loops_at_[a], loops_at_[b], std::back_inserter(common));
            if (a == b || !common.empty()) {
                continue;
            }
            if (is_on_side(points_[b]) && !is_on_side(points_[a])) {
                std::swap(a, b);
            }
            for (const std::uint32_t k : loops_at_[b]) {
                add_loop(a, k);
            }
            loops_at_[b].clear();
            root[b] = a;
            touches_ = true;
        }
        for (Way& chain : chains_) {
            for (auto& [id, number] : chain) {
                id = root_of(id);
            }
        }
    }

    // Inserts points into edges: points on an edge, and points of another loop within the tolerance
    // of it. An edge that is bent by this may then lie on further points.
    void join_edges() {
        bool any = true;
        while (any) {
            any = false;
            for (std::uint32_t k = 0; k < chains_.size(); ++k) {
                Way whole;
                for (std::size_t i = 0; i < chains_[k].size(); ++i) {
                    whole.push_back(chains_[k][i]);
                    const std::uint32_t next =
                        chains_[k][i + 1 == chains_[k].size() ? 0 : i + 1].id;
                    for (const std::uint32_t id : on_edge(k, chains_[k][i].id, next)) {
                        whole.push_back({id, chains_[k][i].number});
                        add_loop(id, k);
                        any = true;
                    }
                }
                chains_[k].swap(whole);
            }
            touches_ = touches_ || any;
        }
    }

    // The loops with the points where edges of different shapes cross; none if no edges do.
    template <class Real>
    [[nodiscard]] std::optional<std::vector<Loop>> crossed() const {
        std::vector<ChainEdge> edges;
        for (std::uint32_t k = 0; k < chains_.size(); ++k) {
            for (std::uint32_t i = 0; i < chains_[k].size(); ++i) {
                const std::uint32_t from = chains_[k][i].id;
                const std::uint32_t to = chains_[k][i + 1 == chains_[k].size() ? 0 : i + 1].id;
                if (from != to) {
                    edges.push_back({from, to, k, i});
                }
            }
        }
        const auto low = [this](const ChainEdge& edge) {
            return std::min(points_[edge.from].x(), points_[edge.to].x());
        };
        std::ranges::sort(edges, {}, [&](const ChainEdge& edge) {
            return std::tuple(low(edge), edge.loop, edge.at);
        });
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Point<double>>> found;
        std::vector<ChainEdge> status;
        for (const ChainEdge& edge : edges) {
            std::erase_if(status, [&](const ChainEdge& other) {
                return std::max(points_[other.from].x(), points_[other.to].x()) < low(edge);
            });
            for (const ChainEdge& other : status) {
                if (loops_[edge.loop].shape != loops_[other.loop].shape && cross(edge, other)) {
                    const Point<double> place = rounded<Real>(crossing_of(other, edge));
                    found[{edge.loop, edge.at}].push_back(place);
                    found[{other.loop, other.at}].push_back(place);
                }
            }
            status.push_back(edge);
        }
        if (found.empty()) {
            return std::nullopt;
        }
        std::vector<Loop> loops(loops_.begin(), loops_.end());
        for (std::uint32_t k = 0; k < loops.size(); ++k) {
            loops[k].points.clear();
            loops[k].numbers.clear();
            for (std::uint32_t i = 0; i < chains_[k].size(); ++i) {
                const auto& [id, number] = chains_[k][i];
                const Point<double>& begin = points_[id];
                std::vector<Point<double>>& places = found[{k, i}];
                std::ranges::sort(places, {},
                                  [&](const Point<double>& p) { return distance(p, begin); });
                places.insert(places.begin(), begin);
                for (const Point<double>& p : places) {
                    if (loops[k].points.empty() || loops[k].points.back() != p) {
                        loops[k].points.push_back(p);
                        loops[k].numbers.push_back(number);
                    }
                }
            }
        }
        return loops;
    }

    NodedShapes result() {
        std::vector<std::array<std::uint32_t, 5>> all; // ends, shape, loop, number
        for (std::uint32_t k = 0; k < chains_.size(); ++k) {
            for (std::size_t i = 0; i < chains_[k].size(); ++i) {
                const auto& [from, number] = chains_[k][i];
                const std::uint32_t to = chains_[k][i + 1 == chains_[k].size() ? 0 : i + 1].id;
                if (from != to) {
                    all.push_back(
                        {std::min(from, to), std::max(from, to), loops_[k].shape, k, number});
                }
            }
        }
        std::ranges::sort(all);
        NodedShapes shapes;
        for (const auto& [from, to, shape, loop, number] : all) {
            if (shapes.edges.empty() || shapes.edges.back().from != from ||
                shapes.edges.back().to != to) {
                shapes.edges.push_back({from, to, {}, loop, number});
            }
            std::vector<std::uint32_t>& list = shapes.edges.back().shapes;
            if (!list.empty() && list.back() == shape) {
                list.pop_back(); // in both directions: no border of the shape
            } else {
                list.push_back(shape);
            }
        }
        std::erase_if(shapes.edges, [](const NodedEdge& edge) { return edge.shapes.empty(); });
        shapes.points = std::move(points_);
        check(shapes);
        shapes.is_as_given = !touches_;
        return shapes;
    }

private:
    struct Place {
        std::uint32_t id;
        std::uint32_t number; // of the edge that begins there
    };
    using Way = std::vector<Place>;
    struct ChainEdge {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t loop;
        std::uint32_t at; // in its chain
    };

    [[nodiscard]] bool cross(const ChainEdge& one, const ChainEdge& other) const {
        const auto are_apart = [this](const ChainEdge& line, const ChainEdge& ends) {
            const Point<double>& a = points_[line.from];
            const Point<double>& b = points_[line.to];
            return orientation<double>(a, b, points_[ends.from]) *
                       orientation<double>(a, b, points_[ends.to]) <
                   0;
        };
        return are_apart(one, other) && are_apart(other, one);
    }

    // The result is bitwise the same for both edges of a border between two shapes.
    [[nodiscard]] Point<double> crossing_of(const ChainEdge& one, const ChainEdge& other) const {
        std::array<std::pair<std::uint32_t, std::uint32_t>, 2> edges{
            std::minmax({one.from, one.to}), std::minmax({other.from, other.to})};
        std::ranges::sort(edges);
        return place_of(points_, ChainEdge{edges[0].first, edges[0].second, 0, 0},
                        ChainEdge{edges[1].first, edges[1].second, 0, 0});
    }

    void add_loop(std::uint32_t id, std::uint32_t loop) {
        std::vector<std::uint32_t>& list = loops_at_[id];
        const auto at = std::ranges::lower_bound(list, loop);
        if (at == list.end() || *at != loop) {
            list.insert(at, loop);
        }
    }

    [[nodiscard]] bool is_on_side(const Point<double>& p) const {
        return is_along_side(lattice_, p, p);
    }

    // The points to be inserted into an edge of a loop, in their order along it.
    [[nodiscard]] std::vector<std::uint32_t> on_edge(std::uint32_t loop, std::uint32_t from,
                                                     std::uint32_t to) const {
        const Point<double>& a = points_[from];
        const Point<double>& b = points_[to];
        const Point<double> low = a.cwiseMin(b).array() - tolerance_;
        const Point<double> high = a.cwiseMax(b).array() + tolerance_;
        std::vector<std::pair<double, std::uint32_t>> found;
        auto at =
            std::ranges::lower_bound(points_, low.x(), {}, [](const auto& p) { return p.x(); });
        for (; at != points_.end() && at->x() <= high.x(); ++at) {
            const auto id = static_cast<std::uint32_t>(at - points_.begin());
            if (at->y() >= low.y() && at->y() <= high.y() && id != from && id != to &&
                !loops_at_[id].empty() && is_part_of(*at, a, b, loop, id)) {
                found.emplace_back((*at - a).dot(b - a), id);
            }
        }
        std::ranges::sort(found);
        std::vector<std::uint32_t> ids;
        std::ranges::transform(found, std::back_inserter(ids),
                               [](const auto& one) { return one.second; });
        return ids;
    }

    [[nodiscard]] bool is_part_of(const Point<double>& p, const Point<double>& a,
                                  const Point<double>& b, std::uint32_t loop,
                                  std::uint32_t id) const {
        if (distance(p, a, b) > tolerance_) {
            return false;
        }
        if (orientation<double>(a, b, p) == 0 && box_contains<double>(a, b, p)) {
            return true;
        }
        return distance(p, a) > tolerance_ && distance(p, b) > tolerance_ &&
               !std::ranges::binary_search(loops_at_[id], loop);
    }

    void check(const NodedShapes& shapes) const {
        std::vector<NetworkLine> lines;
        for (const NodedEdge& edge : shapes.edges) {
            lines.push_back({edge.from, edge.to});
        }
        const auto contact = find_contact(shapes.points, lines);
        if (!contact) {
            return;
        }
        const NodedEdge* first = &shapes.edges[contact->line];
        const NodedEdge* second = &shapes.edges[contact->other];
        if (std::tie(second->loop, second->number) < std::tie(first->loop, first->number)) {
            std::swap(first, second);
        }
        const auto name = [this](const NodedEdge& edge) {
            return loops_[edge.loop].name + ", edge " + std::to_string(edge.number);
        };
        throw InputError(
            {.what = "two edges cross, touch or overlap",
             .where = name(*first),
             .value = "contact with " + name(*second) + " at " +
                      to_text(place_of(shapes.points, *first, *second)),
             .allowed = std::string("outlines that do not cross themselves or each other") +
                        (loops_[first->loop].shape == loops_[second->loop].shape
                             ? ""
                             : "; coverage first or longest_border gives overlaps to one shape")});
    }

    // Approximately where two edges cross.
    static Point<double> place_of(std::span<const Point<double>> points, const auto& one,
                                  const auto& other) {
        const Point<double>& a = points[one.from];
        const Point<double> along = points[one.to] - a;
        const Point<double>& c = points[other.from];
        const Point<double> across = points[other.to] - c;
        const double turn = dsc::cross<double>(along, across);
        const double share = turn == 0 ? 0.5 : dsc::cross<double>(c - a, across) / turn;
        return a + std::clamp(share, 0.0, 1.0) * along;
    }

    std::span<const Loop> loops_;
    const Lattice& lattice_;
    double tolerance_;
    std::vector<Point<double>> points_;                // from left to right
    std::vector<std::vector<std::uint32_t>> loops_at_; // by point, ascending; empty: it was joined
    std::vector<Way> chains_;                          // by loop
    bool touches_ = false;
};

} // namespace

template <class Real>
NodedShapes node_shapes(std::vector<Loop>& loops, const Lattice& lattice, double tolerance,
                        bool may_cross) {
    std::erase_if(loops, [](const Loop& loop) { return loop.points.empty(); });
    const Clipped clipped = clip_to_domain<Real>(loops, lattice, tolerance);
    std::optional<Noding> noding;
    // Joined edges may cross others, so one or two rounds are needed.
    for (int rounds = 8;; --rounds) {
        noding.emplace(loops, lattice, tolerance);
        noding->join_points();
        noding->join_edges();
        auto crossed = may_cross && rounds > 0 ? noding->crossed<Real>() : std::nullopt;
        if (!crossed) {
            break;
        }
        loops.swap(*crossed);
    }
    NodedShapes result = noding->result();
    result.clipped = clipped.loops;
    result.is_as_given = result.is_as_given && !clipped.is_at_side;
    return result;
}

template NodedShapes node_shapes<double>(std::vector<Loop>&, const Lattice&, double, bool);
template NodedShapes node_shapes<float>(std::vector<Loop>&, const Lattice&, double, bool);

} // namespace dsc::initial
