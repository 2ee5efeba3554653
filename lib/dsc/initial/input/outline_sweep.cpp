// SPDX-License-Identifier: MIT
#include "dsc/initial/input/outline_sweep.h"

#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace dsc::initial {

namespace {

// From left to right, and upwards for equal x: as if the plane were sheared a little.
bool precedes(const Point<double>& a, const Point<double>& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// Vertices of all polygons under one numbering; edge e begins at vertex e.
class Sweep {
public:
    explicit Sweep(std::span<const SweepPolygon> polygons)
        : polygons_(polygons), status_(Below{this}) {
        for (std::uint32_t k = 0; k < polygons.size(); ++k) {
            const auto first = static_cast<std::uint32_t>(points_.size());
            const auto n = static_cast<std::uint32_t>(polygons[k].points.size());
            first_.push_back(first);
            for (std::uint32_t i = 0; i < n; ++i) {
                points_.push_back(polygons[k].points[i]);
                polygon_.push_back(k);
                next_.push_back(first + (i + 1 < n ? i + 1 : 0));
                prev_.push_back(first + (i > 0 ? i - 1 : n - 1));
            }
        }
        places_.resize(points_.size(), status_.end());
        result_.parent.assign(polygons.size(), no_id);
    }

    SweepResult run() {
        std::vector<std::uint32_t> order(points_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return points_[a] != points_[b] ? precedes(points_[a], points_[b]) : a < b;
        });
        for (std::size_t i = 0; i < order.size() && !result_.contact; ++i) {
            if (i > 0 && points_[order[i - 1]] == points_[order[i]]) {
                report(order[i - 1], order[i]);
                break;
            }
            visit(order[i]);
        }
        return std::move(result_);
    }

private:
    struct Below {
        Sweep* sweep;
        bool operator()(std::uint32_t s, std::uint32_t t) const { return sweep->below(s, t); }
    };
    using Status = std::set<std::uint32_t, Below>;

    [[nodiscard]] bool runs_right(std::uint32_t e) const {
        return precedes(points_[e], points_[next_[e]]);
    }
    [[nodiscard]] std::uint32_t left(std::uint32_t e) const { return runs_right(e) ? e : next_[e]; }
    [[nodiscard]] std::uint32_t right(std::uint32_t e) const {
        return runs_right(e) ? next_[e] : e;
    }
    [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation<double>(points_[a], points_[b], points_[c]);
    }

    void report(std::uint32_t one, std::uint32_t other) {
        if (!result_.contact) {
            const auto [s, t] = std::minmax(one, other);
            result_.contact =
                Contact{polygon_[s], s - first_[polygon_[s]], polygon_[t], t - first_[polygon_[t]]};
        }
    }

    // The order of the edges that the sweep line meets, by the left end that came later.
    bool below(std::uint32_t s, std::uint32_t t) {
        if (s == t) {
            return false;
        }
        int sign = 0;
        if (left(s) == left(t)) {
            sign = side(left(t), right(t), right(s));
        } else if (precedes(points_[left(t)], points_[left(s)])) {
            sign = side(left(t), right(t), left(s));
        } else {
            sign = -side(left(s), right(s), left(t));
        }
        if (sign == 0) {
            report(s, t);
            return s < t;
        }
        return sign < 0;
    }

    [[nodiscard]] bool within(std::uint32_t e, std::uint32_t v) const {
        return !precedes(points_[v], points_[left(e)]) && !precedes(points_[right(e)], points_[v]);
    }

    void check(std::uint32_t s, std::uint32_t t) {
        if (next_[s] == t || next_[t] == s) {
            return; // overlap of successive edges: found where both begin or both end
        }
        if (segments_meet<double>(points_[s], points_[next_[s]], points_[t], points_[next_[t]])) {
            report(s, t);
        }
    }

    void remove(std::uint32_t e) {
        const auto place = places_[e];
        if (place != status_.begin() && std::next(place) != status_.end()) {
            check(*std::prev(place), *std::next(place));
        }
        status_.erase(place);
        places_[e] = status_.end();
    }

    void add(std::uint32_t e) {
        const auto place = status_.insert(e).first;
        places_[e] = place;
        if (place != status_.begin()) {
            check(*std::prev(place), e);
        }
        if (std::next(place) != status_.end()) {
            check(e, *std::next(place));
        }
    }

    void visit(std::uint32_t v) {
        const std::uint32_t in = prev_[v];
        const std::uint32_t out = v;
        const bool in_ends = precedes(points_[in], points_[v]);
        const bool out_ends = precedes(points_[next_[v]], points_[v]);
        if (in_ends == out_ends && side(in, v, next_[v]) == 0) {
            report(in, out); // a spike
            return;
        }
        if (in_ends) {
            remove(in);
        }
        if (out_ends) {
            remove(out);
        }
        if (!in_ends) {
            add(in);
        }
        if (!out_ends) {
            add(out);
        }
        if (!in_ends && !out_ends && !visited(v)) {
            find_parent(in, out);
        }
    }

    // The parent of a polygon is looked for at its first vertex.
    bool visited(std::uint32_t v) {
        const std::uint32_t k = polygon_[v];
        if (seen_.size() < polygons_.size()) {
            seen_.resize(polygons_.size(), 0);
        }
        const bool before = seen_[k] != 0;
        seen_[k] = 1;
        return before;
    }

    void find_parent(std::uint32_t one, std::uint32_t other) {
        auto lower = places_[below(one, other) ? one : other];
        if (lower == status_.begin()) {
            return;
        }
        const std::uint32_t e = *std::prev(lower);
        const std::uint32_t around = polygon_[e];
        const bool inside_above = runs_right(e) == polygons_[around].counter_clockwise;
        result_.parent[polygon_[one]] = inside_above ? around : result_.parent[around];
    }

    std::span<const SweepPolygon> polygons_;
    std::vector<Point<double>> points_;
    std::vector<std::uint32_t> polygon_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> prev_;
    std::vector<std::uint32_t> first_;
    std::vector<std::uint8_t> seen_;
    Status status_;
    std::vector<Status::iterator> places_;
    SweepResult result_;
};

} // namespace

SweepResult sweep(std::span<const SweepPolygon> polygons) { return Sweep(polygons).run(); }

} // namespace dsc::initial
