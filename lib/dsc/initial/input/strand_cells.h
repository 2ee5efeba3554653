// SPDX-License-Identifier: MIT
// A search grid of the points and edges of strands, used while these are thinned.
#pragma once

#include "dsc/base/types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace dsc::initial {

/// A point of a strand, or a point that replaced two of them.
struct StrandNode {
    Point<double> place{0, 0};
    std::uint32_t previous = no_id; // none at the first end of an open strand
    std::uint32_t next = no_id;
    std::uint32_t strand = 0;
    std::uint32_t first = no_id; // first of the given points that it represents
    std::uint32_t last = no_id;
    std::uint32_t into = no_id; // the point that replaced this one, if any

    [[nodiscard]] bool is_there() const { return into == no_id; }
};

using Corners = std::array<Point<double>, 3>;

/// Points and the edges that began there when they were added, by the cells of a square grid that
/// these meet.
class StrandCells {
public:
    StrandCells(const std::vector<StrandNode>& nodes, double side) : nodes_(nodes), side_(side) {
        if (!nodes.empty()) {
            low_ = nodes.front().place;
        }
        for (const StrandNode& node : nodes) {
            low_ = low_.cwiseMin(node.place);
        }
        entries_.reserve(2 * nodes.size());
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            add(i);
        }
    }

    void add(std::uint32_t i) {
        const StrandNode& node = nodes_[i];
        const Point<double>& end = node.next == no_id ? node.place : nodes_[node.next].place;
        visit_cells({node.place, end, end}, [&](std::uint64_t key) {
            const auto number = static_cast<std::uint32_t>(entries_.size());
            const auto [cell, is_first] = first_.try_emplace(key, number);
            entries_.push_back({i, is_first ? no_id : std::exchange(cell->second, number)});
            return false;
        });
    }

    // Calls `visit` for all points in the cells that a triangle meets, and for those whose edges
    // meet these, until it returns true; returns whether it did.
    template <class Visit>
    bool any_near(const Corners& corners, Visit visit) const {
        return visit_cells(corners, [&](std::uint64_t key) {
            const auto cell = first_.find(key);
            std::uint32_t entry = cell == first_.end() ? no_id : cell->second;
            while (entry != no_id && !visit(entries_[entry][0])) {
                entry = entries_[entry][1];
            }
            return entry != no_id;
        });
    }

private:
    // Visits cells row by row, because a triangle may be long and thin.
    template <class Visit>
    bool visit_cells(const Corners& corners, Visit visit) const {
        Corners at;
        std::ranges::transform(corners, at.begin(), [&](const Point<double>& p) {
            return Point<double>((p - low_) / side_);
        });
        const auto [bottom, top] = std::minmax({at[0].y(), at[1].y(), at[2].y()});
        for (double row = std::floor(bottom); row <= std::floor(top); ++row) {
            const auto [left, right] = range_in_row(at, row);
            for (double column = std::floor(left); column <= std::floor(right); ++column) {
                if (visit(key(column, row))) {
                    return true;
                }
            }
        }
        return false;
    }

    static std::uint64_t key(double column, double row) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(column)) << 32U ^
               static_cast<std::uint64_t>(static_cast<std::int64_t>(row) & 0xffffffff);
    }

    // The range of a triangle in a row, slightly widened against rounding.
    static std::array<double, 2> range_in_row(const Corners& at, double row) {
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

    const std::vector<StrandNode>& nodes_;
    Point<double> low_{0, 0};
    double side_;
    std::unordered_map<std::uint64_t, std::uint32_t> first_; // entry of a cell
    std::vector<std::array<std::uint32_t, 2>> entries_;      // a point, and the cell's next entry
};

} // namespace dsc::initial
