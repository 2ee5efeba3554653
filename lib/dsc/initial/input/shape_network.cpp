// SPDX-License-Identifier: MIT
#include "dsc/initial/input/shape_network.h"

#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/noding.h"
#include "dsc/initial/input/thinning.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;
using Shapes = std::vector<std::uint32_t>; // those that cover a region, ascending

// --- which shapes cover the regions on both sides of each edge -----------------------------------

// One sweep from left to right over edges that meet at ends only (compare contacts.cpp).
class Coverage {
public:
    Coverage(const NodedShapes& noded) : points_(noded.points), edges_(noded.edges) {
        right_.resize(edges_.size());
        left_.resize(edges_.size());
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
            std::vector<std::uint32_t> begun;
            for (; after < events.size() && events[after][0] == events[i][0]; ++after) {
                const auto& [point, begins, e] = events[after];
                if (begins == 0) {
                    status.erase(places[e]);
                } else {
                    places[e] = status.insert(e).first;
                    begun.push_back(e);
                }
            }
            std::ranges::sort(begun, below);
            for (const std::uint32_t e : begun) {
                const auto place = places[e];
                right_[e] = place == status.begin() ? Shapes{} : left_[*std::prev(place)];
                std::ranges::set_symmetric_difference(right_[e], edges_[e].shapes,
                                                      std::back_inserter(left_[e]));
            }
            i = after;
        }
    }

    [[nodiscard]] const Shapes& left(std::uint32_t e) const { return left_[e]; }
    [[nodiscard]] const Shapes& right(std::uint32_t e) const { return right_[e]; }

private:
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
    std::vector<Shapes> left_;
    std::vector<Shapes> right_;
};

// --- phases
// ---------------------------------------------------------------------------------------

// The phase of each region: that of the innermost shape, by the even-odd rule among shapes of one
// phase.
class Phases {
public:
    Phases(std::span<const Shape> shapes, const NodedShapes& noded, const Coverage& coverage)
        : shapes_(shapes), sides_of_(shapes.size(), 0) {
        for (std::uint32_t e = 0; e < noded.edges.size(); ++e) {
            const Point<double> middle =
                midpoint(noded.points[noded.edges[e].from], noded.points[noded.edges[e].to]);
            count(coverage.left(e), middle);
            count(coverage.right(e), middle);
        }
        for (const auto& [pair, common] : common_) {
            if (common.sides < std::min(sides_of_[pair.first], sides_of_[pair.second])) {
                refuse(pair.first, pair.second);
            }
        }
    }

    // Of a region that these shapes cover.
    [[nodiscard]] Phase of(Shapes covering) const {
        std::ranges::sort(covering, [this](std::uint32_t a, std::uint32_t b) {
            return std::pair(sides_of_[b], a) < std::pair(sides_of_[a], b); // the outermost first
        });
        std::vector<Phase> around;
        for (std::size_t i = 0; i < covering.size(); ++i) {
            const auto is_around = [&](std::uint32_t k) {
                return !around.empty() && around.back() == shapes_[k].phase;
            };
            // Of two shapes with one region, one may be the hole that the other fills.
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

private:
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
                                     "border_tolerance joins borders that are near each other"});
    }

    void count(const Shapes& covering, const Point<double>& middle) {
        for (std::size_t i = 0; i < covering.size(); ++i) {
            ++sides_of_[covering[i]];
            for (std::size_t j = i + 1; j < covering.size(); ++j) {
                Common& common = common_[{covering[i], covering[j]}];
                ++common.sides;
                common.place = middle;
            }
        }
    }

    std::span<const Shape> shapes_;
    std::vector<std::size_t> sides_of_; // by shape: of edges that it covers
    std::map<std::pair<std::uint32_t, std::uint32_t>, Common> common_;
};

// --- curves
// ---------------------------------------------------------------------------------------

struct Border {
    std::uint32_t from;
    std::uint32_t to;
    Phase left;
    Phase right;
};

// The curves that borders make, cut where more than two of them meet, and on sides of the domain.
class Curves {
public:
    Curves(const Points& points, std::vector<Border> borders, const Lattice& lattice)
        : points_(points), borders_(std::move(borders)), at_(points.size()),
          is_end_(points.size(), 0), done_(borders_.size(), 0) {
        for (std::uint32_t e = 0; e < borders_.size(); ++e) {
            at_[borders_[e].from].push_back(e);
            at_[borders_[e].to].push_back(e);
        }
        for (std::uint32_t p = 0; p < points.size(); ++p) {
            is_end_[p] = at_[p].size() != 2 || is_along_side(lattice, points[p], points[p]) ? 1 : 0;
        }
        for (std::uint32_t p = 0; p < points.size(); ++p) {
            for (const std::uint32_t e : at_[p]) {
                if (is_end_[p] != 0) {
                    follow(p, e);
                }
            }
        }
        for (std::uint32_t e = 0; e < borders_.size(); ++e) {
            follow(borders_[e].from, e);
        }
    }

    std::vector<Line> lines;

private:
    void follow(std::uint32_t p, std::uint32_t e) {
        if (done_[e] != 0) {
            return;
        }
        const Border& first = borders_[e];
        const bool is_forth = first.from == p;
        Line& line = lines.emplace_back();
        line.path.left = is_forth ? first.left : first.right;
        line.path.right = is_forth ? first.right : first.left;
        line.path.name = "the border of phases " +
                         std::to_string(std::max(first.left, first.right)) + " and " +
                         std::to_string(std::min(first.left, first.right));
        line.given.push_back(points_[p]);
        for (const std::uint32_t begin = p;;) {
            done_[e] = 1;
            p = borders_[e].from == p ? borders_[e].to : borders_[e].from;
            line.given.push_back(points_[p]);
            if (p == begin || is_end_[p] != 0) {
                break;
            }
            e = at_[p][at_[p][0] == e ? 1 : 0];
        }
        line.numbers.resize(line.given.size());
        std::iota(line.numbers.begin(), line.numbers.end(), 0U);
    }

    const Points& points_;
    std::vector<Border> borders_;
    std::vector<std::vector<std::uint32_t>> at_; // by point: the borders that meet there
    std::vector<std::uint8_t> is_end_;           // by point
    std::vector<std::uint8_t> done_;             // by border
};

// --- the shapes
// -----------------------------------------------------------------------------------

template <class Real>
void add_loop(std::span<const Point<double>> points, std::uint32_t shape, const std::string& name,
              std::vector<Loop>& loops) {
    Loop& loop = loops.emplace_back();
    loop.shape = shape;
    loop.name = name;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Point<double> p = rounded<Real>(points[i]);
        if (!p.allFinite()) {
            throw InputError({.what = "a coordinate is not finite",
                              .where = name + ", point " + std::to_string(i),
                              .value = to_text(points[i]),
                              .allowed = "finite coordinates"});
        }
        if (loop.points.empty() || loop.points.back() != p) {
            loop.points.push_back(p);
            loop.numbers.push_back(i);
        }
    }
    while (loop.points.size() > 1 && loop.points.front() == loop.points.back()) {
        loop.points.pop_back();
        loop.numbers.pop_back();
    }
}

bool holds(const Points& polygon, const Point<double>& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point<double>& a = polygon[i];
        const Point<double>& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        if ((a.y() > p.y()) != (b.y() > p.y())) {
            const int way = orientation<double>(a, b, p);
            inside ^= a.y() < b.y() ? way > 0 : way < 0;
        }
    }
    return inside;
}

// Whether the innermost shape around another one has its phase. For loops that lie apart, one for
// each shape.
bool has_holes(std::span<const Shape> shapes, std::span<const Loop> loops) {
    struct Box {
        Point<double> low, high;
    };
    std::vector<Box> boxes;
    for (const Loop& loop : loops) {
        Box box{loop.points.front(), loop.points.front()};
        for (const Point<double>& p : loop.points) {
            box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
        }
        boxes.push_back(box);
    }
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const Loop* around = nullptr;
        double least = 0;
        for (std::size_t j = 0; j < loops.size(); ++j) {
            const Box& box = boxes[j];
            const double size = (box.high - box.low).prod();
            if (i != j && (box.low.array() <= boxes[i].low.array()).all() &&
                (boxes[i].high.array() <= box.high.array()).all() &&
                (around == nullptr || size < least) &&
                holds(loops[j].points, loops[i].points.front())) {
                around = &loops[j];
                least = size;
            }
        }
        if (around != nullptr && shapes[around->shape].phase == shapes[loops[i].shape].phase) {
            return true;
        }
    }
    return false;
}

// Closed curves that meet no other one are too small if no two points are an edge length apart.
void drop_small_loops(std::vector<Line>& lines, const InitialOptions& options,
                      InputReport& report) {
    std::map<std::pair<double, double>, int> ends;
    for (const Line& line : lines) {
        ++ends[{line.given.front().x(), line.given.front().y()}];
        ++ends[{line.given.back().x(), line.given.back().y()}];
    }
    std::erase_if(lines, [&](const Line& line) {
        const Points& points = line.given;
        return points.front() == points.back() &&
               ends[{points.front().x(), points.front().y()}] == 2 &&
               is_dropped(points, line.path.name, options, report);
    });
}

} // namespace

template <class Real>
std::optional<ShapeNetwork> network_of(std::span<const Shape> shapes, const Lattice& lattice,
                                       const InitialOptions& options, InputReport& report) {
    std::vector<Loop> loops;
    bool is_plain = true;
    for (std::uint32_t k = 0; k < shapes.size(); ++k) {
        const std::string name = name_of(shapes, k);
        add_loop<Real>(shapes[k].outline, k, name, loops);
        for (std::size_t i = 0; i < shapes[k].holes.size(); ++i) {
            is_plain = false;
            add_loop<Real>(shapes[k].holes[i], k, name + ", hole " + std::to_string(i), loops);
        }
    }
    std::vector<Loop> small;
    std::erase_if(loops, [&](const Loop& loop) {
        const bool is_line = loop.points.size() < 3;
        if (is_line) {
            small.push_back(loop);
        }
        return is_line;
    });
    const Point<double> first = loops.empty() ? lattice.low : loops.front().points.front();
    const NodedShapes noded =
        node_shapes<Real>(loops, lattice, options.border_tolerance * options.edge_length);
    if (loops.empty() && noded.clipped > 0) {
        throw InputError({.what = "all shapes lie outside the domain",
                          .where = name_of(shapes, 0),
                          .value = to_text(first),
                          .allowed = to_text(lattice.low) + " to " + to_text(lattice.high)});
    }
    if (is_plain && noded.is_as_given && !has_holes(shapes, loops)) {
        return std::nullopt;
    }
    for (const Shape& shape : shapes) {
        require(shape.phase != border_phase,
                name_of(shapes, static_cast<std::uint32_t>(&shape - shapes.data())), shape.phase,
                "phases from 0 to 4294967294; the next one is reserved");
    }
    report.clipped += noded.clipped;
    for (const Loop& loop : small) {
        (void)is_dropped(loop.points, loop.name, options, report);
    }
    Coverage coverage(noded);
    coverage.run();
    const Phases phases(shapes, noded, coverage);
    ShapeNetwork network;
    std::vector<Border> borders;
    for (std::uint32_t e = 0; e < noded.edges.size(); ++e) {
        const NodedEdge& edge = noded.edges[e];
        const Phase left = phases.of(coverage.left(e));
        const Phase right = phases.of(coverage.right(e));
        if (!is_along_side(lattice, noded.points[edge.from], noded.points[edge.to])) {
            if (left != right) {
                borders.push_back({edge.from, edge.to, left, right});
            }
        } else if (!coverage.left(e).empty() || !coverage.right(e).empty()) {
            network.background = coverage.left(e).empty() ? right : left;
        }
    }
    network.lines = std::move(Curves(noded.points, std::move(borders), lattice).lines);
    drop_small_loops(network.lines, options, report);
    return network;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::optional<ShapeNetwork> network_of<Real>(std::span<const Shape>, const Lattice&,  \
                                                          const InitialOptions&, InputReport&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::initial
