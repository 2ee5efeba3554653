// SPDX-License-Identifier: MIT
#include "dsc/geometry/contacts.h"

#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace dsc {

namespace {

// The order from left to right, and upwards for equal x, as if the plane were slightly sheared.
bool precedes(const Point<double>& a, const Point<double>& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// Whether p and q lie in the same direction from c; exact, for three points on one line.
bool same_direction(const Point<double>& c, const Point<double>& p, const Point<double>& q) {
    return precedes(c, p) == precedes(c, q);
}

class Sweep {
public:
    Sweep(std::span<const Point<double>> points, std::span<const NetworkLine> lines)
        : points_(points), lines_(lines), status_(Below{this}),
          places_(lines.size(), status_.end()) {}

    std::optional<LineContact> run() {
        const std::vector<End> ends = sorted_ends();
        for (std::size_t i = 0; i < ends.size() && !contact_;) {
            std::size_t after = i + 1;
            while (after < ends.size() && ends[after].point == ends[i].point) {
                ++after;
            }
            visit(std::span(ends).subspan(i, after - i));
            if (after < ends.size() && at(ends[after].point) == at(ends[i].point)) {
                report(ends[i].line, ends[after].line);
            }
            i = after;
        }
        return contact_;
    }

private:
    struct End {
        std::uint32_t point;
        std::uint32_t line;
    };
    struct Below {
        const Sweep* sweep;
        bool operator()(std::uint32_t s, std::uint32_t t) const { return sweep->below(s, t); }
    };
    using Status = std::set<std::uint32_t, Below>;

    [[nodiscard]] const Point<double>& at(std::uint32_t point) const { return points_[point]; }
    [[nodiscard]] bool runs_right(std::uint32_t line) const {
        return precedes(at(lines_[line].from), at(lines_[line].to));
    }
    [[nodiscard]] std::uint32_t left(std::uint32_t line) const {
        return runs_right(line) ? lines_[line].from : lines_[line].to;
    }
    [[nodiscard]] std::uint32_t right(std::uint32_t line) const {
        return runs_right(line) ? lines_[line].to : lines_[line].from;
    }
    [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation<double>(at(a), at(b), at(c));
    }

    // The ends of all lines from left to right; those at one point follow each other.
    [[nodiscard]] std::vector<End> sorted_ends() const {
        std::vector<End> ends;
        ends.reserve(2 * lines_.size());
        for (std::uint32_t k = 0; k < lines_.size(); ++k) {
            ends.push_back({lines_[k].from, k});
            ends.push_back({lines_[k].to, k});
        }
        std::sort(ends.begin(), ends.end(), [this](const End& a, const End& b) {
            const auto key = [this](const End& e) {
                return std::tuple(at(e.point).x(), at(e.point).y(), e.point, e.line);
            };
            return key(a) < key(b);
        });
        return ends;
    }

    // The vertical order of two lines on the sweep line, at the later of their left ends. If the
    // other line passes through that end, either order is correct, because the two become
    // neighbours and are compared.
    [[nodiscard]] bool below(std::uint32_t s, std::uint32_t t) const {
        int sign = 0;
        if (left(s) == left(t)) {
            sign = side(left(t), right(t), right(s));
        } else if (precedes(at(left(t)), at(left(s)))) {
            sign = side(left(t), right(t), left(s));
        } else {
            sign = -side(left(s), right(s), left(t));
        }
        return sign != 0 ? sign < 0 : s < t;
    }

    // Removes the lines that end at a point, and adds those that begin there.
    void visit(std::span<const End> ends) {
        for (const auto& [point, line] : ends) {
            if (point == right(line)) {
                const auto place = places_[line];
                if (place != status_.begin() && std::next(place) != status_.end()) {
                    compare(*std::prev(place), *std::next(place));
                }
                status_.erase(place);
            }
        }
        for (const auto& [point, line] : ends) {
            if (point == left(line)) {
                const auto place = status_.insert(line).first;
                places_[line] = place;
                if (place != status_.begin()) {
                    compare(*std::prev(place), line);
                }
                if (std::next(place) != status_.end()) {
                    compare(line, *std::next(place));
                }
            }
        }
    }

    void compare(std::uint32_t one, std::uint32_t other) {
        if (meet(lines_[one], lines_[other])) {
            report(one, other);
        }
    }

    void report(std::uint32_t one, std::uint32_t other) {
        if (!contact_) {
            contact_ = {std::min(one, other), std::max(one, other)};
        }
    }

    // Whether two lines have a point in common, other than an end with the same number.
    [[nodiscard]] bool meet(const NetworkLine& s, const NetworkLine& t) const {
        const bool from_shared = s.from == t.from || s.from == t.to;
        const bool to_shared = s.to == t.from || s.to == t.to;
        if (from_shared && to_shared) {
            return true;
        }
        if (!from_shared && !to_shared) {
            return segments_meet<double>(at(s.from), at(s.to), at(t.from), at(t.to));
        }
        const std::uint32_t common = from_shared ? s.from : s.to;
        const std::uint32_t p = from_shared ? s.to : s.from;
        const std::uint32_t q = t.from == common ? t.to : t.from;
        return side(p, common, q) == 0 && same_direction(at(common), at(p), at(q));
    }

    std::span<const Point<double>> points_;
    std::span<const NetworkLine> lines_;
    Status status_;
    std::vector<Status::iterator> places_; // by line, while the sweep meets it
    std::optional<LineContact> contact_;
};

} // namespace

std::optional<LineContact> find_contact(std::span<const Point<double>> points,
                                        std::span<const NetworkLine> lines) {
    return Sweep(points, lines).run();
}

} // namespace dsc
