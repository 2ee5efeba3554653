// SPDX-License-Identifier: MIT
#include "dsc/initial/input/contraction.h"

#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/noding.h"
#include "dsc/initial/input/thinning.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;

template <class Real>
class Contraction {
public:
    Contraction(std::vector<Line>& lines, const Lattice& lattice, double edge_length,
                InputReport& report)
        : lines_(lines), lattice_(lattice), edge_length_(edge_length), report_(report),
          is_gone_(lines.size(), 0) {
        std::map<std::pair<double, double>, std::uint32_t> numbers;
        for (std::uint32_t k = 0; k < lines.size(); ++k) {
            const Points& points = lines[k].given;
            std::array<std::uint32_t, 2>& ends = ends_.emplace_back();
            for (std::size_t i = 0; i < 2; ++i) {
                const Point<double>& p = i == 0 ? points.front() : points.back();
                const auto number = static_cast<std::uint32_t>(junctions_.size());
                const auto [at, is_new] = numbers.try_emplace({p.x(), p.y()}, number);
                if (is_new) {
                    junctions_.push_back({p, {p}, {}});
                }
                ends[i] = at->second;
                junctions_[at->second].lines.push_back(k);
            }
            for (std::size_t i = 1; i + 1 < points.size(); ++i) {
                inner_.push_back(points[i]);
            }
        }
        std::ranges::sort(inner_, {}, [](const auto& p) { return std::pair(p.x(), p.y()); });
        for (std::uint32_t j = 0; j < junctions_.size(); ++j) {
            from_left_.emplace_back(junctions_[j].place.x(), j);
        }
        std::ranges::sort(from_left_);
    }

    void run() {
        for (std::uint32_t k = 0; k < lines_.size(); ++k) {
            offer(k);
        }
        while (!short_lines_.empty()) {
            const auto [length, k] = short_lines_.top();
            short_lines_.pop();
            if (is_gone_[k] == 0 && length == length_of(k)) { // otherwise it is queued again with
                                                              // its new length
                contract(k);
            }
        }
        std::vector<Line> left;
        for (std::uint32_t k = 0; k < lines_.size(); ++k) {
            if (is_gone_[k] == 0) {
                left.push_back(std::move(lines_[k]));
            }
        }
        lines_.swap(left);
    }

private:
    struct Junction {
        Point<double> place{0, 0};
        Points given;                     // the junctions merged into this one; none: it was merged
                                          // itself
        std::vector<std::uint32_t> lines; // lines that end here; closed ones twice
    };
    using Short = std::pair<double, std::uint32_t>;

    [[nodiscard]] double length_of(std::uint32_t k) const {
        const Points& points = lines_[k].given;
        double length = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            length += distance(points[i - 1], points[i]);
        }
        return length;
    }

    void offer(std::uint32_t k) {
        if (const double length = length_of(k);
            ends_[k][0] != ends_[k][1] && length < finest_edge * edge_length_) {
            short_lines_.emplace(length, k);
        }
    }

    [[nodiscard]] bool is_on_side(const Point<double>& p) const {
        return is_along_side(lattice_, p, p);
    }

    // Whether a line belongs to the boundary of a domain that is no rectangle.
    [[nodiscard]] bool is_side(std::uint32_t line) const {
        return lines_[line].path.left == border_phase || lines_[line].path.right == border_phase;
    }
    // Whether the domain boundary turns at a junction on it.
    [[nodiscard]] bool turns_at(const Junction& junction) const {
        std::vector<Point<double>> beside;
        for (const std::uint32_t line : junction.lines) {
            const Points& points = lines_[line].given;
            if (is_side(line)) {
                beside.push_back(points.front() == junction.place ? points[1]
                                                                  : points[points.size() - 2]);
            }
        }
        constexpr double straight = 0.01; // radians
        return beside.size() == 2 &&
               std::abs(turn_angle<double>(beside[0], junction.place, beside[1])) > straight;
    }

    // Whether the junction is on a side of the rectangle, or on the boundary of a domain that is no
    // rectangle.
    [[nodiscard]] bool is_on_boundary(const Junction& junction) const {
        return is_on_side(junction.place) ||
               std::ranges::any_of(junction.lines,
                                   [this](std::uint32_t line) { return is_side(line); });
    }

    void contract(std::uint32_t k) {
        const auto [one, other] = ends_[k];
        Junction& kept = junctions_[one];
        Junction& lost = junctions_[other];
        const bool is_held = is_on_boundary(kept);
        const bool is_other_held = is_on_boundary(lost);
        // Two ends on one straight piece of a polygon's side become one.
        const bool is_side_between = is_side(k) && lines_[k].given.size() == 2;
        if (is_held && is_other_held && !is_side_between) {
            return;
        }
        Point<double> target =
            is_held && !(is_side_between && turns_at(lost)) ? kept.place : lost.place;
        if (!is_held && !is_other_held) {
            const auto share = static_cast<double>(lost.given.size()) /
                               static_cast<double>(kept.given.size() + lost.given.size());
            target = rounded<Real>(Point<double>(kept.place + share * (lost.place - kept.place)));
        }
        // An end on a side stays, and the other end moves all the way to it.
        const double farthest =
            (is_held || is_other_held ? finest_edge : max_deviation) * edge_length_;
        if (is_side_between && turns_at(kept) && turns_at(lost)) {
            return; // both are corners of the domain
        }
        double deviation = 0;
        for (const Junction* junction : {&kept, &lost}) {
            for (const Point<double>& p : junction->given) {
                deviation = std::max(deviation, distance(p, target));
            }
        }
        if (deviation > farthest || !is_free(one, other, k, target)) {
            return;
        }
        report_.deviation = std::max(report_.deviation, deviation);
        ++report_.thinned;
        is_gone_[k] = 1;
        for (const std::uint32_t j : {one, other}) {
            for (const std::uint32_t line : junctions_[j].lines) {
                move_end(line, j, target);
            }
        }
        for (const std::uint32_t line : lost.lines) {
            std::ranges::replace(ends_[line], other, one);
        }
        kept.place = target;
        kept.lines.insert(kept.lines.end(), lost.lines.begin(), lost.lines.end());
        kept.given.insert(kept.given.end(), lost.given.begin(), lost.given.end());
        lost = {};
        std::erase_if(kept.lines, [this](std::uint32_t line) {
            drop_small_loop(line);
            return is_gone_[line] != 0;
        });
        for (const std::uint32_t line : kept.lines) {
            join_with_twin(line, kept.lines);
            drop_along_side(line);
            if (is_gone_[line] == 0) {
                offer(line);
            }
        }
    }

    void move_end(std::uint32_t line, std::uint32_t junction, const Point<double>& target) {
        if (is_gone_[line] != 0) {
            return;
        }
        Points& points = lines_[line].given;
        const Point<double> place = junctions_[junction].place;
        for (std::size_t i = 0; i < 2; ++i) {
            Point<double>& end = i == 0 ? points.front() : points.back();
            if (ends_[line][i] == junction && end == place) {
                const Point<double>& next = i == 0 ? points[1] : points[points.size() - 2];
                report_.area_changed += std::abs(cross<double>(target - next, end - next)) / 2;
                end = target;
            }
        }
    }

    // Drops a line from a junction to itself that is too small for the mesh: its region has shrunk
    // by contractions.
    void drop_small_loop(std::uint32_t line) {
        const Points& points = lines_[line].given;
        if (is_gone_[line] != 0 || ends_[line][0] != ends_[line][1] ||
            (points.size() > 3 && length_of(line) >= finest_edge * edge_length_)) {
            return;
        }
        is_gone_[line] = 1;
        double doubled_area = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            doubled_area += cross<double>(points[i - 1] - points[0], points[i] - points[0]);
        }
        ++report_.dropped;
        report_.area_dropped += std::abs(doubled_area) / 2;
    }

    // Drops an edge that has come to lie along a side of the rectangle: the corner of a shape that
    // reached into the domain there has vanished.
    void drop_along_side(std::uint32_t line) {
        const Points& points = lines_[line].given;
        if (is_gone_[line] == 0 && points.size() == 2 &&
            is_along_side(lattice_, points[0], points[1])) {
            is_gone_[line] = 1;
            ++report_.dropped;
        }
    }

    // Merges two edges between the same junctions, whose region in between has vanished, into one,
    // or into none if the phases on both sides are equal.
    void join_with_twin(std::uint32_t line, const std::vector<std::uint32_t>& others) {
        for (const std::uint32_t twin : others) {
            const bool is_forth = ends_[twin] == ends_[line];
            const bool is_back =
                ends_[twin][0] == ends_[line][1] && ends_[twin][1] == ends_[line][0];
            if (twin <= line || is_gone_[line] != 0 || is_gone_[twin] != 0 ||
                (!is_forth && !is_back) || lines_[line].given.size() > 2 ||
                lines_[twin].given.size() > 2) {
                continue;
            }
            CheckedPath& path = lines_[line].path;
            Phase left = lines_[twin].path.left;
            Phase right = *lines_[twin].path.right;
            if (is_back) {
                std::swap(left, right);
            }
            if (*path.right == left) {
                path.right = right;
            } else {
                path.left = left;
            }
            is_gone_[twin] = 1;
            is_gone_[line] = path.left == *path.right ? 1 : 0;
            ++report_.dropped;
        }
    }

    // Whether the two junctions can move to the target without any other point in the area that
    // their lines sweep, or beside the line between them.
    [[nodiscard]] bool is_free(std::uint32_t one, std::uint32_t other, std::uint32_t between,
                               const Point<double>& target) const {
        const Point<double>& a = junctions_[one].place;
        const Point<double>& b = junctions_[other].place;
        const Points& inside = lines_[between].given;
        const auto is_feature = [&](const Point<double>& p) {
            return p == a || p == b || std::ranges::find(inside, p) != inside.end();
        };
        for (std::size_t i = 1; i + 1 < inside.size(); ++i) {
            if (any_in({a, b, inside[i]}, is_feature)) {
                return false;
            }
        }
        for (const std::uint32_t j : {one, other}) {
            const Point<double>& from = junctions_[j].place;
            for (const std::uint32_t line : junctions_[j].lines) {
                const Points& points = lines_[line].given;
                if (line == between) {
                    continue;
                }
                for (std::size_t i = 0; i < 2; ++i) {
                    const Point<double>& next = i == 0 ? points[1] : points[points.size() - 2];
                    if (ends_[line][i] == j && any_in({from, target, next}, [&](const auto& p) {
                            return p == next || is_feature(p);
                        })) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    template <class IsCorner>
    [[nodiscard]] bool any_in(std::array<Point<double>, 3> corners, IsCorner is_feature) const {
        const int way = orientation<double>(corners[0], corners[1], corners[2]);
        if (way == 0) {
            return false;
        }
        if (way < 0) {
            std::swap(corners[0], corners[1]);
        }
        const auto is_in = [&](const Point<double>& p) {
            return !is_feature(p) && orientation<double>(corners[0], corners[1], p) >= 0 &&
                   orientation<double>(corners[1], corners[2], p) >= 0 &&
                   orientation<double>(corners[2], corners[0], p) >= 0;
        };
        const auto [low, high] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
        for (auto at =
                 std::ranges::lower_bound(inner_, low, {}, [](const auto& p) { return p.x(); });
             at != inner_.end() && at->x() <= high; ++at) {
            if (is_in(*at)) {
                return true;
            }
        }
        // Junctions are sorted by their original positions.
        const double moved = finest_edge * edge_length_;
        for (auto at = std::ranges::lower_bound(from_left_, std::pair(low - moved, 0U));
             at != from_left_.end() && at->first <= high + moved; ++at) {
            const Junction& junction = junctions_[at->second];
            if (!junction.given.empty() && is_in(junction.place)) {
                return true;
            }
        }
        return false;
    }

    std::vector<Line>& lines_;
    const Lattice& lattice_;
    double edge_length_;
    InputReport& report_;
    std::vector<std::uint8_t> is_gone_;              // by line
    std::vector<std::array<std::uint32_t, 2>> ends_; // junctions, by line
    std::vector<Junction> junctions_;
    Points inner_;                                            // of lines, from left to right
    std::vector<std::pair<double, std::uint32_t>> from_left_; // junctions
    std::priority_queue<Short, std::vector<Short>, std::greater<>> short_lines_;
};

} // namespace

template <class Real>
void contract_short_lines(std::vector<Line>& lines, const Lattice& lattice, double edge_length,
                          InputReport& report) {
    Contraction<Real>(lines, lattice, edge_length, report).run();
}

template void contract_short_lines<double>(std::vector<Line>&, const Lattice&, double,
                                           InputReport&);
template void contract_short_lines<float>(std::vector<Line>&, const Lattice&, double, InputReport&);

} // namespace dsc::initial
