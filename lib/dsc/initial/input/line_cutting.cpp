// SPDX-License-Identifier: MIT
#include "dsc/initial/input/line_cutting.h"

#include "dsc/base/error.h"
#include "dsc/geometry/contacts.h"
#include "dsc/geometry/points.h"
#include "dsc/initial/input/thinning.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <deque>
#include <tuple>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;

// Numbers the points of the interface; equal ends of curves are one point. Outlines share no
// points.
class Network {
public:
    Network(std::span<const Line> lines, const Lattice& lattice, double h)
        : lines_(lines), lattice_(lattice), h_(h), ends_(lines.size()),
          is_loop_(lines.size(), false) {}

    // An end inside the domain must meet another one.
    void join_ends() {
        std::vector<End> ends;
        for (std::uint32_t k = 0; k < lines_.size(); ++k) {
            const Points& given = lines_[k].given;
            const Points& points = lines_[k].path.points;
            if (lines_[k].is_outline()) {
                ends_[k].fill(number(points.front()));
                is_loop_[k] = true;
            } else {
                ends.push_back({points.front(), given.front(), k, 0});
                ends.push_back({points.back(), given.back(), k, 1});
            }
        }
        std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
            const auto key = [](const End& e) {
                return std::tuple(e.place.x(), e.place.y(), e.line, e.index);
            };
            return key(a) < key(b);
        });
        for (std::size_t i = 0; i < ends.size();) {
            std::size_t after = i;
            const std::uint32_t point = number(ends[i].place);
            for (; after < ends.size() && ends[after].place == ends[i].place; ++after) {
                check_same(ends[i], ends[after]);
                ends_[ends[after].line][ends[after].index] = point;
            }
            if (after == i + 1) {
                check_single(ends[i]);
            }
            const std::uint32_t k = ends[i].line;
            is_loop_[k] = is_loop_[k] || (after == i + 2 && ends[i + 1].line == k);
            i = after;
        }
    }

    // Whether a line is closed and meets no other one.
    [[nodiscard]] bool is_loop(std::uint32_t k) const { return is_loop_[k]; }

    // The points of a line and of the pieces that its edges are cut into, rounded.
    template <class Real>
    Points cut(std::uint32_t k) {
        const Line& line = lines_[k];
        const Points& points = line.path.points;
        Points result;
        std::uint32_t from = ends_[k][0];
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Point<double>& a = points[i];
            const Point<double>& b = points[i + 1];
            const std::uint32_t to = i + 2 < points.size() ? number(b) : ends_[k][1];
            const auto pieces = static_cast<std::uint32_t>(piece_count(line, i, h_));
            if (distance_to_sides(lattice_, midpoint<double>(a, b)) == 0) {
                refuse_along_side(line, i, midpoint<double>(a, b));
            }
            edges_.push_back({from, to});
            edge_names_.push_back({k, static_cast<std::uint32_t>(i)});
            result.push_back(a);
            for (std::uint32_t j = 1; j < pieces; ++j) {
                const double fraction = static_cast<double>(j) / pieces;
                const Point<double> p = rounded<Real>(a + fraction * (b - a));
                if (!(distance_to_sides(lattice_, p) >= min_margin * h_)) {
                    refuse_along_side(line, i, p);
                }
                result.push_back(p);
                const std::uint32_t next = number(p);
                add_piece(from, next);
                from = next;
            }
            add_piece(from, to);
            from = to;
        }
        result.push_back(points.back());
        return result;
    }

    // Rounding moves the points that cut an edge, so the pieces must be checked for contacts too.
    void check_contacts() const {
        if (const auto contact = find_contact(points_, edges_)) {
            refuse_contact(contact->line, contact->other);
        }
        if (pieces_.size() == edges_.size()) {
            return;
        }
        if (const auto contact = find_contact(points_, pieces_)) {
            refuse_contact(edge_of_piece_[contact->line], edge_of_piece_[contact->other]);
        }
    }

private:
    struct End {
        Point<double> place;
        Point<double> given;
        std::uint32_t line;
        std::uint32_t index; // 0: the first end, 1: the last one
    };

    std::uint32_t number(const Point<double>& point) {
        points_.push_back(point);
        return static_cast<std::uint32_t>(points_.size() - 1);
    }

    void add_piece(std::uint32_t from, std::uint32_t to) {
        pieces_.push_back({from, to});
        edge_of_piece_.push_back(static_cast<std::uint32_t>(edges_.size() - 1));
    }

    void check_same(const End& one, const End& other) const {
        if (one.given != other.given) {
            throw InputError({.what = "ends of curves collide when rounded to the scalar of the "
                                      "complex",
                              .where = lines_[other.line].path.name,
                              .value = to_text(other.given) + ", with " + to_text(one.given) +
                                       " of " + lines_[one.line].path.name,
                              .allowed = "ends that are equal, or differ after rounding"});
        }
    }

    void check_single(const End& end) const {
        if (distance_to_sides(lattice_, end.place) != 0) {
            const Line& line = lines_[end.line];
            throw InputError({.what = "the curve ends inside the domain",
                              .where = line.point(end.index == 0 ? 0 : line.given.size() - 1),
                              .value = to_text(end.place),
                              .allowed = "ends on a side of the domain, or exactly at other ends"});
        }
    }

    [[noreturn]] void refuse_along_side(const Line& line, std::size_t edge,
                                        const Point<double>& p) const {
        throw InputError({.what = "the edge runs along a side of the domain",
                          .where = line.edge(edge),
                          .value = line.ends_of_edge(edge),
                          .allowed = "a distance of at least " + to_text(min_margin * h_) +
                                     " between its ends, as at " + to_text(p)});
    }

    [[noreturn]] void refuse_contact(std::uint32_t edge, std::uint32_t other) const {
        const auto name = [this](std::uint32_t e) {
            return lines_[edge_names_[e][0]].edge(edge_names_[e][1]);
        };
        const auto [first, second] = std::minmax(edge, other);
        throw InputError(
            {.what = "two edges cross, touch or overlap",
             .where = name(first),
             .value = "contact with " + name(second),
             .allowed = "simple, disjoint outlines; curves that meet only at common ends"});
    }

    std::span<const Line> lines_;
    const Lattice& lattice_;
    double h_;
    std::vector<std::array<std::uint32_t, 2>> ends_; // by line: its first and last points
    std::deque<bool> is_loop_;                       // by line
    Points points_;
    std::vector<NetworkLine> edges_;
    std::vector<std::array<std::uint32_t, 2>>
        edge_names_; // by edge: its line, and its number there
    std::vector<NetworkLine> pieces_;
    std::vector<std::uint32_t> edge_of_piece_;
};

void check_detail(const Line& line, double h) {
    for (std::size_t i = 0; i + 1 < line.path.points.size(); ++i) {
        const double length = distance(line.path.points[i], line.path.points[i + 1]);
        if (length < shortest_kept_edge * h) {
            throw InputError({.what = "the edge is too short for the mesh",
                              .where = line.edge(i),
                              .value = to_text(length),
                              .allowed = "an edge length of the mesh of at most " +
                                         to_text(length / shortest_kept_edge) +
                                         ", or detail left out"});
        }
    }
}

// Leaves out detail that is finer than the mesh. Returns whether there was any.
template <class Real>
bool thin_lines(std::vector<Line>& lines, const Network& network, const Lattice& lattice,
                const InitialOptions& options, InputReport& report) {
    std::vector<Strand> strands;
    for (std::uint32_t k = 0; k < lines.size(); ++k) {
        strands.push_back({lines[k].path.points, !network.is_loop(k)});
    }
    const Point<double> margin = Point<double>::Constant(2 * min_margin * options.edge_length);
    const std::size_t before = report.thinned;
    std::vector<std::vector<Kept>> kept =
        thin<Real>(strands, {lattice.low + margin, lattice.high - margin},
                   finest_on_interface(options.sizes, options.edge_length), report);
    for (std::uint32_t k = 0; k < lines.size(); ++k) {
        if (network.is_loop(k)) {
            kept[k].push_back(kept[k].front());
        }
        std::vector<std::uint32_t> indices(kept[k].size());
        std::ranges::transform(kept[k], indices.begin(), &Kept::index);
        keep_points(lines[k], indices);
        for (std::size_t i = 0; i < kept[k].size(); ++i) {
            if (Point<double>& p = lines[k].path.points[i]; p != kept[k][i].place) {
                p = lines[k].given[i] = kept[k][i].place;
            }
        }
    }
    return report.thinned > before;
}

} // namespace

template <class Real>
std::vector<Points> cut_apart(std::vector<Line>& lines, const Lattice& lattice,
                              const InitialOptions& options, InputReport& report) {
    const double scale = finest_on_interface(options.sizes, options.edge_length);
    for (bool is_thinned = options.detail == Detail::keep;; is_thinned = true) {
        Network network(lines, lattice, options.edge_length);
        network.join_ends();
        std::vector<Points> cut;
        for (std::uint32_t k = 0; k < lines.size(); ++k) {
            cut.push_back(network.cut<Real>(k));
        }
        network.check_contacts();
        if (is_thinned || !thin_lines<Real>(lines, network, lattice, options, report)) {
            if (options.detail == Detail::keep) {
                for (const Line& line : lines) {
                    check_detail(line, scale);
                }
            }
            return cut;
        }
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::vector<Points> cut_apart<Real>(std::vector<Line>&, const Lattice&,               \
                                                 const InitialOptions&, InputReport&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::initial
