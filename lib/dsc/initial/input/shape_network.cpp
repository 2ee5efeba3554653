// SPDX-License-Identifier: MIT
#include "dsc/initial/input/shape_network.h"

#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/contraction.h"
#include "dsc/initial/input/noding.h"
#include "dsc/initial/input/region_phases.h"
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

// --- curves --------------------------------------------------------------------------------------

struct Border {
    std::uint32_t from;
    std::uint32_t to;
    Phase left;
    Phase right;
};

// The curves that consist of borders, cut where more than two borders meet, and on sides of the
// domain.
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
        const auto [lower, higher] = std::minmax(first.left, first.right);
        line.path.name = higher == border_phase ? "the domain boundary"
                                                : "the border of phases " + std::to_string(higher) +
                                                      " and " + std::to_string(lower);
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

// --- the shapes ----------------------------------------------------------------------------------

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

std::string ring_of_domain(std::size_t i) {
    return i == 0 ? "the outline of the domain" : "the domain, hole " + std::to_string(i - 1);
}

// The sides of the domain, which bound gaps like a shape does.
Loop domain_loop(const Lattice& lattice, std::size_t shape) {
    const auto& [low, high] = std::pair(lattice.low, lattice.high);
    Loop loop;
    loop.shape = static_cast<std::uint32_t>(shape);
    loop.name = "the domain";
    loop.points = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    loop.numbers = {0, 1, 2, 3};
    return loop;
}

// Points of shapes within the tolerance of the domain boundary are moved onto it, so that joining
// them does not bend it. O((n + m) log n) for n points and m edges, if few are near each other.
template <class Real>
void move_to_boundary(std::vector<Loop>& loops, std::uint32_t outside, double tolerance) {
    std::vector<Point<double>*> points;
    for (Loop& loop : loops) {
        for (Point<double>& p : loop.points) {
            if (loop.shape != outside) {
                points.push_back(&p);
            }
        }
    }
    std::ranges::stable_sort(points, {}, [](const Point<double>* p) { return p->x(); });
    std::vector<double> left;
    std::ranges::transform(points, std::back_inserter(left),
                           [](const Point<double>* p) { return p->x(); });
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; loop.shape == outside && i < loop.points.size(); ++i) {
            const Point<double>& a = loop.points[i];
            const Point<double>& b = loop.points[i + 1 == loop.points.size() ? 0 : i + 1];
            auto at = std::ranges::lower_bound(left, std::min(a.x(), b.x()) - tolerance);
            for (; at != left.end() && *at <= std::max(a.x(), b.x()) + tolerance; ++at) {
                Point<double>& p = *points[static_cast<std::size_t>(at - left.begin())];
                if (distance<double>(p, a, b) <= tolerance) {
                    p = distance<double>(p, a) <= tolerance ? a
                        : distance<double>(p, b) <= tolerance
                            ? b
                            : rounded<Real>(nearest_point(p, a, b));
                }
            }
        }
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

// Whether a shape has the same phase as the innermost shape around it. For loops that lie apart,
// one for each shape.
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
        double smallest = 0;
        for (std::size_t j = 0; j < loops.size(); ++j) {
            const Box& box = boxes[j];
            const double size = (box.high - box.low).prod();
            if (i != j && (box.low.array() <= boxes[i].low.array()).all() &&
                (boxes[i].high.array() <= box.high.array()).all() &&
                (around == nullptr || size < smallest) &&
                holds(loops[j].points, loops[i].points.front())) {
                around = &loops[j];
                smallest = size;
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
    const bool has_outside = !shapes.empty() && is_outside(shapes.back());
    for (std::uint32_t k = 0; k < shapes.size(); ++k) {
        const std::string name = name_of(shapes, k);
        add_loop<Real>(shapes[k].outline, k, name, loops);
        for (std::size_t i = 0; i < shapes[k].holes.size(); ++i) {
            is_plain = false;
            const std::string ring = ", hole " + std::to_string(i);
            add_loop<Real>(shapes[k].holes[i], k,
                           !is_outside(shapes[k]) ? name + ring : ring_of_domain(i), loops);
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
    const bool is_open = options.coverage == Coverage::open;
    const double tolerance = options.border_tolerance * options.edge_length;
    if (has_outside) {
        move_to_boundary<Real>(loops, static_cast<std::uint32_t>(shapes.size() - 1), tolerance);
    }
    if (!is_open && !loops.empty()) {
        loops.push_back(domain_loop(lattice, shapes.size()));
    }
    const NodedShapes noded =
        node_shapes<Real>(loops, lattice, tolerance,
                          has_outside || options.coverage == Coverage::first ||
                              options.coverage == Coverage::longest_border);
    if (loops.size() == (is_open ? 0U : 1U) && noded.clipped > 0) {
        throw InputError({.what = "all shapes lie outside the domain",
                          .where = name_of(shapes, 0),
                          .value = to_text(first),
                          .allowed = to_text(lattice.low) + " to " + to_text(lattice.high)});
    }
    if (is_plain && noded.is_as_given && is_open && !has_holes(shapes, loops)) {
        return std::nullopt;
    }
    report.clipped += noded.clipped;
    for (const Loop& loop : small) {
        (void)is_dropped(loop.points, loop.name, options, report);
    }
    const std::vector<std::array<Phase, 2>> phases = phases_beside(noded, shapes, options);
    ShapeNetwork network;
    network.has_outside = has_outside;
    std::vector<Border> borders;
    for (std::uint32_t e = 0; e < noded.edges.size(); ++e) {
        const NodedEdge& edge = noded.edges[e];
        const auto [left, right] = phases[e];
        if (!is_along_side(lattice, noded.points[edge.from], noded.points[edge.to])) {
            if (left != right) {
                borders.push_back({edge.from, edge.to, left, right});
            }
        } else if (left != right) { // outside is the exterior phase
            network.background = left == exterior_phase ? right : left;
        }
    }
    network.lines = std::move(Curves(noded.points, std::move(borders), lattice).lines);
    if (options.detail == Detail::thin) {
        contract_short_lines<Real>(network.lines, lattice,
                                   finest_on_interface(options.sizes, options.edge_length), report);
    }
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
