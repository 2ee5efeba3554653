// SPDX-License-Identifier: MIT
#include "dsc/initial/input/thinning.h"

#include "dsc/base/error.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/strand_cells.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;

// The mean distance of points, but not so small that a triangle meets very many cells.
double side_of_cells(std::span<const Strand> strands, double edge_length) {
    constexpr double min = 0.01; // of the edge length
    double length = 0;
    double points = 1;
    for (const Strand& strand : strands) {
        points += static_cast<double>(strand.points.size());
        for (std::size_t i = 1; i < strand.points.size(); ++i) {
            length += distance(strand.points[i - 1], strand.points[i]);
        }
    }
    return std::max(2 * length / points, min * edge_length);
}

template <class Real>
class Thinning {
public:
    Thinning(std::span<const Strand> strands, const Rectangle& box, double edge_length)
        : edge_length_(edge_length), box_(box), strands_(strands), nodes_(nodes_of(strands)),
          cells_(nodes_, side_of_cells(strands, edge_length)) {}

    void run() {
        for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
            offer(i);
        }
        while (!short_edges_.empty()) {
            const ShortEdge edge = short_edges_.top();
            short_edges_.pop();
            if (nodes_[edge.from].is_there() && nodes_[edge.from].next == edge.to) {
                shorten(edge);
            }
        }
    }

    std::vector<std::vector<Kept>> left(InputReport& report) const {
        std::vector<std::vector<Kept>> result(strands_.size());
        for (const StrandNode& node : nodes_) {
            if (node.is_there()) {
                const std::uint32_t begin = states_[node.strand].first;
                result[node.strand].push_back({node.first - begin, node.place});
            }
        }
        for (std::size_t k = 0; k < result.size(); ++k) {
            std::ranges::sort(result[k], {}, &Kept::index);
            report.thinned += states_[k].last - states_[k].first + 1 - result[k].size();
        }
        report.deviation = std::max(report.deviation, deviation_);
        for (const State& state : states_) {
            report.area_changed += std::abs(state.area_change);
        }
        return result;
    }

private:
    struct ShortEdge {
        double length;
        std::uint32_t from;
        std::uint32_t to;
        // The top of a priority queue is its last element.
        bool operator<(const ShortEdge& other) const {
            return std::tie(other.length, other.from) < std::tie(length, from);
        }
    };
    struct State { // of a strand
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        std::uint32_t may_go = 0; // vertices that can still be removed without losing the strand
        double max_area_change = 0;
        double area_change = 0; // on its left
    };
    struct Removal {
        std::uint32_t vertex = no_id;
        double deviation = 0;
        double area_change = 0;
        double cost = 0;
    };

    std::vector<StrandNode> nodes_of(std::span<const Strand> strands) {
        std::vector<StrandNode> nodes;
        for (std::uint32_t k = 0; k < strands.size(); ++k) {
            const auto& [points, keeps_ends] = strands[k];
            const bool is_free = !keeps_ends;
            State& state = states_.emplace_back();
            state.first = static_cast<std::uint32_t>(nodes.size());
            for (std::size_t i = 0; i + (is_free ? 1 : 0) < points.size(); ++i) {
                const auto number = static_cast<std::uint32_t>(nodes.size());
                nodes.push_back({points[i], number - 1, number + 1, k, number, number});
            }
            state.last = static_cast<std::uint32_t>(nodes.size()) - 1;
            nodes[state.first].previous = is_free ? state.last : no_id;
            nodes[state.last].next = is_free ? state.first : no_id;
            // Two curves between the same ends must not become the same edge, nor a closed one
            // vanish.
            const std::uint32_t min = is_free || points.front() != points.back() ? 3 : 4;
            const std::uint32_t count = state.last - state.first + 1;
            state.may_go = count - std::min(min, count);
            double length = 0;
            double area = 0; // inside a closed one
            for (std::size_t i = 1; i < points.size(); ++i) {
                length += distance(points[i - 1], points[i]);
                area += cross<double>(points[i - 1] - points[0], points[i] - points[0]) / 2;
            }
            const bool is_closed = points.front() == points.back();
            state.max_area_change =
                max_area_change * (is_closed ? std::min(edge_length_ * length, std::abs(area))
                                             : edge_length_ * length / 2);
        }
        return nodes;
    }

    void offer(std::uint32_t from) {
        if (const std::uint32_t to = nodes_[from].next; to != no_id) {
            const double length = distance(nodes_[from].place, nodes_[to].place);
            if (length < finest_edge * edge_length_) {
                short_edges_.push({length, from, to});
            }
        }
    }

    // Removes the end of a short edge with the lower cost, or merges both if neither may be
    // removed.
    void shorten(const ShortEdge& edge) {
        const Removal from = removal(edge.from);
        const Removal to = removal(edge.to);
        const Removal& best =
            from.vertex == no_id || (to.vertex != no_id && to.cost < from.cost) ? to : from;
        if (best.vertex == no_id) {
            merge(edge);
            return;
        }
        const StrandNode& node = nodes_[best.vertex];
        nodes_[best.vertex].into = node.previous;
        nodes_[node.previous].next = node.next;
        nodes_[node.next].previous = node.previous;
        note(node.strand, best);
        for (const std::uint32_t i : {nodes_[node.previous].previous, node.previous, node.next}) {
            if (i != no_id) {
                offer(i);
            }
        }
    }

    void note(std::uint32_t strand, const Removal& done) {
        State& state = states_[strand];
        --state.may_go;
        state.area_change += done.area_change;
        deviation_ = std::max(deviation_, done.deviation);
    }

    // Replaces both ends of a short edge by one vertex, at a distance from the edge that restores
    // the given areas (compare B. Kronenfeld, L. V. Stanislawski, B. P. Buttenfield, T. Brockmeyer,
    // "Simplification of polylines by segment collapse", 2020).
    void merge(const ShortEdge& edge) {
        const StrandNode from = nodes_[edge.from];
        const StrandNode to = nodes_[edge.to];
        if (from.previous == no_id || to.next == no_id || from.previous == to.next ||
            states_[from.strand].may_go == 0) {
            return;
        }
        const Point<double> a = nodes_[from.previous].place; // a, from, to, d in this order
        const Point<double> d = nodes_[to.next].place;
        if (a == d) {
            return;
        }
        const Point<double> along = d - a;
        const double left_of_edges =
            cross<double>(along, to.place - a) + cross<double>(to.place - a, from.place - a);
        const Point<double> middle = midpoint(from.place, to.place);
        const double missing =
            left_of_edges + 2 * states_[from.strand].area_change - cross<double>(along, middle - a);
        const Point<double> place = rounded<Real>(Point<double>(
            middle + missing / along.squaredNorm() * Point<double>(-along.y(), along.x())));
        Removal merged{.area_change = (left_of_edges - cross<double>(along, place - a)) / 2};
        merged.deviation =
            std::min({distance(place, a, from.place), distance(place, from.place, to.place),
                      distance(place, to.place, d)});
        merged.deviation =
            std::max(merged.deviation, deviation_from({a, place, d}, from.previous, to.next));
        if (!(merged.deviation <= max_deviation * edge_length_) ||
            (place.array() < box_.low.array()).any() || (place.array() > box_.high.array()).any() ||
            place == a || place == d || is_any_in({a, from.place, place}) ||
            is_any_in({from.place, to.place, place}) || is_any_in({to.place, d, place}) ||
            is_crossed(from.place, place)) {
            return;
        }
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({place, from.previous, to.next, from.strand, from.first, to.last});
        nodes_[edge.from].into = nodes_[edge.to].into = number;
        nodes_[from.previous].next = nodes_[to.next].previous = number;
        cells_.add(number);
        note(from.strand, merged);
        for (const std::uint32_t i :
             {nodes_[from.previous].previous, from.previous, number, to.next}) {
            if (i != no_id) {
                offer(i);
            }
        }
    }

    // The effect of removing a vertex; `vertex` is no_id if it must stay.
    [[nodiscard]] Removal removal(std::uint32_t vertex) const {
        const StrandNode& node = nodes_[vertex];
        const State& state = states_[node.strand];
        if (node.previous == no_id || node.next == no_id || state.may_go == 0) {
            return {};
        }
        const Point<double>& a = nodes_[node.previous].place;
        const Point<double>& b = nodes_[node.next].place;
        Removal result{.vertex = vertex, .area_change = cross<double>(b - a, node.place - a) / 2};
        const double area_change = std::abs(state.area_change + result.area_change);
        if (area_change > state.max_area_change && area_change > std::abs(state.area_change)) {
            return {};
        }
        result.deviation = deviation_from({a, b}, node.previous, node.next);
        if (result.deviation > max_deviation * edge_length_ || a == b ||
            is_any_in({a, node.place, b})) {
            return {};
        }
        // A removal that adds to the area change so far costs twice as much, so that area lost at
        // one point is gained at another.
        const bool is_lost_again = state.area_change * result.area_change > 0;
        result.cost = is_lost_again ? 2 * result.deviation : result.deviation;
        return result;
    }

    // The largest distance of the given points from the edges that will join two vertices. A merged
    // vertex represents some given points that may be near its other edge.
    [[nodiscard]] double deviation_from(Points path, std::uint32_t from, std::uint32_t to) const {
        const StrandNode& first = nodes_[from];
        const StrandNode& last = nodes_[to];
        if (first.first != first.last && first.previous != no_id) {
            path.insert(path.begin(), nodes_[first.previous].place);
        }
        if (last.first != last.last && last.next != no_id) {
            path.push_back(nodes_[last.next].place);
        }
        double farthest = 0;
        const State& state = states_[first.strand];
        for (std::uint32_t i = first.first;; i = i == state.last ? state.first : i + 1) {
            double nearest = distance(nodes_[i].place, path[0], path[1]);
            for (std::size_t k = 2; k < path.size(); ++k) {
                nearest = std::min(nearest, distance(nodes_[i].place, path[k - 1], path[k]));
            }
            farthest = std::max(farthest, nearest);
            if (i == last.last) {
                return farthest;
            }
        }
    }

    // Whether a point other than its corners lies in a triangle. If two of its sides are edges and
    // no point does, nothing meets the third one.
    [[nodiscard]] bool is_any_in(Corners corners) const {
        const int way = orientation<double>(corners[0], corners[1], corners[2]);
        if (way < 0) {
            std::swap(corners[0], corners[1]);
        }
        return way != 0 && cells_.any_near(corners, [&](std::uint32_t i) {
            const Point<double>& p = nodes_[i].place;
            const auto is_left_of = [&](std::size_t from, std::size_t to) {
                return orientation<double>(corners[from], corners[to], p) >= 0;
            };
            return nodes_[i].is_there() && std::ranges::find(corners, p) == corners.end() &&
                   is_left_of(0, 1) && is_left_of(1, 2) && is_left_of(2, 0);
        });
    }

    // Whether an edge, other than those at the vertex, meets the way of a vertex from `a` to `b`.
    // Edges are searched by the given edges that they replace, which are no farther away than
    // points have been moved and left out.
    bool is_crossed(const Point<double>& a, const Point<double>& b) {
        const auto meets = [&](std::uint32_t i) {
            if (i == no_id || nodes_[i].next == no_id) {
                return false;
            }
            const Point<double>& p = nodes_[i].place;
            const Point<double>& q = nodes_[nodes_[i].next].place;
            return p != a && q != a &&
                   orientation<double>(a, b, p) * orientation<double>(a, b, q) <= 0 &&
                   orientation<double>(p, q, a) * orientation<double>(p, q, b) <= 0;
        };
        const auto any_meets = [&](std::uint32_t given) {
            const std::uint32_t i = left_of(given);
            return meets(i) || meets(nodes_[i].previous);
        };
        const Point<double> margin = Point<double>::Constant(2 * deviation_);
        const Point<double> low = a.cwiseMin(b) - margin;
        const Point<double> high = a.cwiseMax(b) + margin;
        return cells_.any_near({low, Point<double>(high.x(), low.y()), high}, any_meets) ||
               cells_.any_near({low, high, Point<double>(low.x(), high.y())}, any_meets);
    }

    // The vertex at which the edge begins that now represents a given point.
    std::uint32_t left_of(std::uint32_t i) {
        while (nodes_[i].into != no_id) {
            if (const std::uint32_t after = nodes_[nodes_[i].into].into; after != no_id) {
                nodes_[i].into = after;
            }
            i = nodes_[i].into;
        }
        return i;
    }

    double edge_length_;
    Rectangle box_;
    std::span<const Strand> strands_;
    std::vector<State> states_;
    std::vector<StrandNode> nodes_;
    StrandCells cells_;
    std::priority_queue<ShortEdge> short_edges_;
    double deviation_ = 0;
};

} // namespace

template <class Real>
std::vector<std::vector<Kept>> thin(std::span<const Strand> strands, const Rectangle& box,
                                    double edge_length, InputReport& report) {
    Thinning<Real> thinning(strands, box, edge_length);
    thinning.run();
    return thinning.left(report);
}

template std::vector<std::vector<Kept>> thin<double>(std::span<const Strand>, const Rectangle&,
                                                     double, InputReport&);
template std::vector<std::vector<Kept>> thin<float>(std::span<const Strand>, const Rectangle&,
                                                    double, InputReport&);

bool is_dropped(std::span<const Point<double>> outline, const std::string& name,
                const InitialOptions& options, InputReport& report) {
    double doubled_area = 0;
    Point<double> low = outline.front();
    Point<double> high = low;
    for (std::size_t i = 1; i < outline.size(); ++i) {
        doubled_area += cross<double>(outline[i - 1] - outline[0], outline[i] - outline[0]);
        low = low.cwiseMin(outline[i]);
        high = high.cwiseMax(outline[i]);
    }
    const double size = distance(low, high);
    const bool is_line = outline.size() < (outline.front() == outline.back() ? 4 : 3);
    if (!is_line && size >= finest_on_interface(options.sizes, options.edge_length)) {
        return false;
    }
    if (options.detail == Detail::keep) {
        throw InputError(
            {.what = is_line ? "too few points" : "the shape is smaller than the edge length",
             .where = name,
             .value = is_line ? std::to_string(outline.size()) : to_text(size),
             .allowed = is_line ? "3 or more different ones around a region"
                                : "an edge length of at most this size, or detail left out"});
    }
    ++report.dropped;
    report.area_dropped += std::abs(doubled_area) / 2;
    return true;
}

} // namespace dsc::initial
