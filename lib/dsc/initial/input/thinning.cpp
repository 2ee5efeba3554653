// SPDX-License-Identifier: MIT
#include "dsc/initial/input/thinning.h"

#include "dsc/base/error.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace dsc::initial {

namespace {

// All points of all strands by number; those of a strand follow each other.
struct Node {
    Point<double> place{0, 0};
    std::uint32_t previous = no_id; // none at the first end of an open strand
    std::uint32_t next = no_id;
    std::uint32_t strand = 0;
    bool is_there = true;
};

// Points by the cell of a square grid that they lie in.
class Cells {
public:
    Cells(std::span<const Node> nodes, double side) : nodes_(nodes), side_(side) {
        if (!nodes.empty()) {
            low_ = nodes.front().place;
        }
        for (const Node& node : nodes) {
            low_ = low_.cwiseMin(node.place);
        }
        following_.reserve(nodes.size());
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            const Point<double> at = (nodes[i].place - low_) / side_;
            const auto [cell, is_first] =
                first_.try_emplace(key(std::floor(at.x()), std::floor(at.y())), i);
            following_.push_back(is_first ? no_id : std::exchange(cell->second, i));
        }
    }

    // Calls `visit` for all points in the cells that a triangle meets, until it returns true;
    // returns whether it did. Row by row, since a triangle may be long and thin.
    template <class Visit>
    bool any_near(const std::array<Point<double>, 3>& corners, Visit visit) const {
        std::array<Point<double>, 3> at;
        std::ranges::transform(corners, at.begin(), [&](const Point<double>& p) {
            return Point<double>((p - low_) / side_);
        });
        const auto [bottom, top] = std::minmax({at[0].y(), at[1].y(), at[2].y()});
        for (double row = std::floor(bottom); row <= std::floor(top); ++row) {
            const auto [left, right] = range_in_row(at, row);
            for (double column = std::floor(left); column <= std::floor(right); ++column) {
                const auto cell = first_.find(key(column, row));
                std::uint32_t i = cell == first_.end() ? no_id : cell->second;
                for (; i != no_id; i = following_[i]) {
                    if (nodes_[i].is_there && visit(i)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

private:
    static std::uint64_t key(double column, double row) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(column)) << 32U ^
               static_cast<std::uint64_t>(static_cast<std::int64_t>(row) & 0xffffffff);
    }

    // The range of a triangle in a row, slightly widened against rounding.
    static std::array<double, 2> range_in_row(const std::array<Point<double>, 3>& at, double row) {
        constexpr double slack = 1e-6;
        double left = std::numeric_limits<double>::infinity();
        double right = -left;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [a, b] = std::minmax(
                at[i], at[(i + 1) % 3], [](const auto& p, const auto& q) { return p.y() < q.y(); });
            const double from = std::max(a.y(), row - slack);
            const double to = std::min(b.y(), row + 1 + slack);
            if (from <= to) {
                const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0;
                const double at_from = a.x() + slope * (from - a.y());
                const double at_to = b.y() > a.y() ? a.x() + slope * (to - a.y()) : b.x();
                left = std::min({left, at_from - slack, at_to - slack});
                right = std::max({right, at_from + slack, at_to + slack});
            }
        }
        return {left, right};
    }

    std::span<const Node> nodes_;
    Point<double> low_{0, 0};
    double side_;
    std::unordered_map<std::uint64_t, std::uint32_t> first_;
    std::vector<std::uint32_t> following_;
};

// The mean distance of points, but not so small that a triangle meets very many cells.
double side_of_cells(std::span<const Strand> strands, double edge_length) {
    constexpr double least = 0.01; // of the edge length
    double length = 0;
    double points = 1;
    for (const Strand& strand : strands) {
        points += static_cast<double>(strand.points.size());
        for (std::size_t i = 1; i < strand.points.size(); ++i) {
            length += distance(strand.points[i - 1], strand.points[i]);
        }
    }
    return std::max(2 * length / points, least * edge_length);
}

class Thinning {
public:
    Thinning(std::span<const Strand> strands, double edge_length)
        : edge_length_(edge_length), strands_(strands), nodes_(nodes_of(strands)),
          cells_(nodes_, side_of_cells(strands, edge_length)) {}

    void run() {
        for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
            offer(i);
        }
        while (!short_edges_.empty()) {
            const ShortEdge edge = short_edges_.top();
            short_edges_.pop();
            if (nodes_[edge.from].is_there && nodes_[edge.from].next == edge.to) {
                shorten(edge);
            }
        }
    }

    std::vector<std::vector<std::uint32_t>> left(InputReport& report) const {
        std::vector<std::vector<std::uint32_t>> result(strands_.size());
        for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
            const std::uint32_t k = nodes_[i].strand;
            if (nodes_[i].is_there) {
                result[k].push_back(i - states_[k].first);
            } else {
                ++report.thinned;
            }
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

    std::vector<Node> nodes_of(std::span<const Strand> strands) {
        std::vector<Node> nodes;
        for (std::uint32_t k = 0; k < strands.size(); ++k) {
            const auto& [points, keeps_ends] = strands[k];
            const bool is_free = !keeps_ends;
            State& state = states_.emplace_back();
            state.first = static_cast<std::uint32_t>(nodes.size());
            for (std::size_t i = 0; i + (is_free ? 1 : 0) < points.size(); ++i) {
                const auto number = static_cast<std::uint32_t>(nodes.size());
                nodes.push_back({points[i], number - 1, number + 1, k});
            }
            state.last = static_cast<std::uint32_t>(nodes.size()) - 1;
            nodes[state.first].previous = is_free ? state.last : no_id;
            nodes[state.last].next = is_free ? state.first : no_id;
            // Two curves between the same ends must not become the same edge, nor a closed one
            // vanish.
            const std::uint32_t least = is_free || points.front() != points.back() ? 3 : 4;
            const std::uint32_t count = state.last - state.first + 1;
            state.may_go = count - std::min(least, count);
            double length = 0;
            double area = 0; // inside a closed one
            for (std::size_t i = 1; i < points.size(); ++i) {
                length += distance(points[i - 1], points[i]);
                area += cross<double>(points[i - 1] - points[0], points[i] - points[0]) / 2;
            }
            const bool is_closed = points.front() == points.back();
            state.max_area_change =
                max_area_change *
                std::min(edge_length_ * length, is_closed ? std::abs(area) : edge_length_ * length);
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

    // Removes the end of a short edge that costs less, if either may be removed.
    void shorten(const ShortEdge& edge) {
        const Removal from = removal(edge.from);
        const Removal to = removal(edge.to);
        const Removal& best =
            from.vertex == no_id || (to.vertex != no_id && to.cost < from.cost) ? to : from;
        if (best.vertex == no_id) {
            return;
        }
        Node& node = nodes_[best.vertex];
        State& state = states_[node.strand];
        node.is_there = false;
        nodes_[node.previous].next = node.next;
        nodes_[node.next].previous = node.previous;
        --state.may_go;
        state.area_change += best.area_change;
        deviation_ = std::max(deviation_, best.deviation);
        for (const std::uint32_t i : {nodes_[node.previous].previous, node.previous, node.next}) {
            if (i != no_id) {
                offer(i);
            }
        }
    }

    // The effect of removing a vertex; `vertex` is no_id if it must stay.
    [[nodiscard]] Removal removal(std::uint32_t vertex) const {
        const Node& node = nodes_[vertex];
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
        const auto after = [&](std::uint32_t i) { return i == state.last ? state.first : i + 1; };
        for (std::uint32_t i = after(node.previous); i != node.next; i = after(i)) {
            result.deviation = std::max(result.deviation, distance(nodes_[i].place, a, b));
        }
        if (result.deviation > max_deviation * edge_length_ || is_in_the_way(vertex)) {
            return {};
        }
        // The area that is lost here is gained there.
        const bool is_lost_again = state.area_change * result.area_change > 0;
        result.cost = is_lost_again ? 2 * result.deviation : result.deviation;
        return result;
    }

    // Whether a point lies in the triangle that a vertex makes with its neighbours. If none does,
    // nothing else meets the edge between these.
    [[nodiscard]] bool is_in_the_way(std::uint32_t vertex) const {
        const Node& node = nodes_[vertex];
        Point<double> a = nodes_[node.previous].place;
        Point<double> b = nodes_[node.next].place;
        if (a == b) {
            return true;
        }
        const int way = orientation<double>(a, node.place, b);
        if (way < 0) {
            std::swap(a, b);
        }
        return way != 0 && cells_.any_near({a, node.place, b}, [&](std::uint32_t i) {
            const Point<double>& p = nodes_[i].place;
            return i != vertex && p != a && p != b && orientation<double>(a, node.place, p) >= 0 &&
                   orientation<double>(node.place, b, p) >= 0 && orientation<double>(b, a, p) >= 0;
        });
    }

    double edge_length_;
    std::span<const Strand> strands_;
    std::vector<State> states_;
    std::vector<Node> nodes_;
    Cells cells_;
    std::priority_queue<ShortEdge> short_edges_;
    double deviation_ = 0;
};

} // namespace

std::vector<std::vector<std::uint32_t>> thin(std::span<const Strand> strands, double edge_length,
                                             InputReport& report) {
    Thinning thinning(strands, edge_length);
    thinning.run();
    return thinning.left(report);
}

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
