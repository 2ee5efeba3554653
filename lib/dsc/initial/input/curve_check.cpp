// SPDX-License-Identifier: MIT
#include "dsc/initial/input/curve_check.h"

#include "dsc/base/error.h"
#include "dsc/initial/input/curve_contacts.h"
#include "dsc/initial/input/cutting.h"
#include "dsc/initial/input/text.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <string>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;

std::string curve_name(std::size_t curve) { return "curve " + std::to_string(curve); }

std::string point_name(std::size_t curve, std::size_t point) {
    return curve_name(curve) + ", point " + std::to_string(point);
}

std::string curve_edge_name(std::size_t curve, std::size_t edge) {
    return curve_name(curve) + ", edge " + std::to_string(edge);
}

void check_phases(const Curve& curve, std::size_t k) {
    for (const Phase phase : {curve.left, curve.right}) {
        if (phase == border_phase) {
            throw InputError({.what = "the phase is reserved",
                              .where = curve_name(k),
                              .value = std::to_string(phase),
                              .allowed = "0 to 4294967294"});
        }
    }
    if (curve.left == curve.right) {
        throw InputError({.what = "the curve has one phase on both sides",
                          .where = curve_name(k),
                          .value = std::to_string(curve.left),
                          .allowed = "two phases that differ"});
    }
}

// Rounds the points of a curve; all are finite, and no two that follow each other the same.
template <class Real>
Points check_points(const Points& given, std::size_t k) {
    if (given.size() < 2) {
        throw InputError({.what = "the curve has too few points",
                          .where = curve_name(k),
                          .value = std::to_string(given.size()),
                          .allowed = "2 or more"});
    }
    Points points;
    points.reserve(given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        points.push_back(rounded<Real>(given[i]));
        if (!is_finite(given[i]) || !is_finite(points.back())) {
            throw InputError({.what = "a coordinate is not finite",
                              .where = point_name(k, i),
                              .value = text(given[i]),
                              .allowed = "finite coordinates"});
        }
        if (i > 0 && points[i - 1] == points[i]) {
            const bool zero = given[i - 1] == given[i];
            throw InputError(
                {.what = zero ? "the edge has no length"
                              : "points collide when rounded to the scalar of the complex",
                 .where = curve_edge_name(k, i - 1),
                 .value = text(given[i - 1]) + " to " + text(given[i]),
                 .allowed = "points that differ from the one before"});
        }
    }
    if (points.front() == points.back() && points.size() < 4) {
        throw InputError({.what = "the closed curve has too few points",
                          .where = curve_name(k),
                          .value = std::to_string(points.size()),
                          .allowed = "4 or more, with the first one again at the end"});
    }
    return points;
}

bool is_on_side(const Lattice& lattice, const Point<double>& p) {
    return distance_to_sides(lattice, p) == 0;
}

// Whether one side of the domain contains both points.
bool on_one_side(const Lattice& lattice, const Point<double>& p, const Point<double>& q) {
    const auto both = [](double a, double b, double side) { return a == side && b == side; };
    return both(p.x(), q.x(), lattice.low.x()) || both(p.x(), q.x(), lattice.high.x()) ||
           both(p.y(), q.y(), lattice.low.y()) || both(p.y(), q.y(), lattice.high.y());
}

void check_places(const Points& points, std::size_t k, const Lattice& lattice, double h) {
    const std::string sides = text(lattice.low) + " to " + text(lattice.high);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == points.size();
        const double distance = distance_to_sides(lattice, points[i]);
        if (distance < 0) {
            throw InputError({.what = "the point is outside the domain",
                              .where = point_name(k, i),
                              .value = text(points[i]),
                              .allowed = "points in " + sides});
        }
        if (!(distance >= least_margin * h) && !(is_end && distance == 0)) {
            throw InputError({.what = "the point is too close to a side of the domain",
                              .where = point_name(k, i),
                              .value = text(points[i]),
                              .allowed = "a distance of at least " + text(least_margin * h) +
                                         " to the sides of " + sides +
                                         "; the ends of a curve may lie on them exactly"});
        }
    }
    if (points.size() == 2 && on_one_side(lattice, points.front(), points.back())) {
        throw InputError({.what = "the edge lies in a side of the domain",
                          .where = curve_edge_name(k, 0),
                          .value = text(points.front()) + " to " + text(points.back()),
                          .allowed = "edges that lead into the domain"});
    }
}

// The network by numbers: equal ends of curves are one point.
struct Network {
    Points points;
    std::vector<NetworkEdge> edges;
    std::vector<NetworkPiece> pieces;
    std::vector<std::uint32_t> first_edge; // by curve
};

struct End {
    Point<double> place;
    Point<double> given;
    std::uint32_t curve;
    std::uint32_t index; // 0: the first end, 1: the last one
};

// The numbers of the ends of each curve, and their points. An end inside the domain must meet
// another one.
std::vector<std::array<std::uint32_t, 2>> join_ends(std::span<const Curve> given,
                                                    const std::vector<Points>& curves,
                                                    const Lattice& lattice, Network& network) {
    std::vector<End> ends;
    for (std::uint32_t k = 0; k < curves.size(); ++k) {
        ends.push_back({curves[k].front(), given[k].points.front(), k, 0});
        ends.push_back({curves[k].back(), given[k].points.back(), k, 1});
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
        const auto key = [](const End& e) {
            return std::tuple(e.place.x(), e.place.y(), e.curve, e.index);
        };
        return key(a) < key(b);
    });
    std::vector<std::array<std::uint32_t, 2>> numbers(curves.size());
    std::vector<std::uint32_t> meeting; // by point: how many ends
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (i == 0 || ends[i - 1].place != ends[i].place) {
            network.points.push_back(ends[i].place);
            meeting.push_back(0);
        } else if (ends[i - 1].given != ends[i].given) {
            throw InputError({.what = "ends of curves collide when rounded to the scalar of the "
                                      "complex",
                              .where = curve_name(ends[i].curve),
                              .value = text(ends[i].given) + ", with " + text(ends[i - 1].given) +
                                       " of " + curve_name(ends[i - 1].curve),
                              .allowed = "ends that are equal, or differ after rounding"});
        }
        ++meeting.back();
        numbers[ends[i].curve][ends[i].index] =
            static_cast<std::uint32_t>(network.points.size() - 1);
    }
    for (std::size_t k = 0; k < curves.size(); ++k) {
        for (const std::size_t index : {0U, 1U}) {
            const Point<double>& place = network.points[numbers[k][index]];
            if (meeting[numbers[k][index]] == 1 && !is_on_side(lattice, place)) {
                throw InputError(
                    {.what = "the curve ends inside the domain",
                     .where = point_name(k, index == 0 ? 0 : curves[k].size() - 1),
                     .value = text(place),
                     .allowed = "ends on a side of the domain, or exactly at other ends"});
            }
        }
    }
    return numbers;
}

// Counts pieces before rounding, so that float and double are cut alike.
template <class Real>
Points cut(const Points& given, const Points& points, std::size_t k, double h,
           const Lattice& lattice, const std::array<std::uint32_t, 2>& ends, Network& network) {
    Points result;
    const auto number_of = [&](std::size_t i) {
        if (i == 0) {
            return ends[0];
        }
        if (i + 1 == points.size()) {
            return ends[1];
        }
        network.points.push_back(points[i]);
        return static_cast<std::uint32_t>(network.points.size() - 1);
    };
    std::uint32_t from = number_of(0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const std::uint32_t to = number_of(i + 1);
        const auto edge = static_cast<std::uint32_t>(network.edges.size());
        network.edges.push_back({from, to});
        const auto pieces = static_cast<std::uint32_t>(piece_count(given[i], given[i + 1], h));
        result.push_back(points[i]);
        for (std::uint32_t j = 1; j < pieces; ++j) {
            const Point<double> p = cut_point<Real>(points[i], points[i + 1], j, pieces);
            if (!(distance_to_sides(lattice, p) >= least_margin * h)) {
                throw InputError({.what = "the edge runs along a side of the domain",
                                  .where = curve_edge_name(k, i),
                                  .value = text(given[i]) + " to " + text(given[i + 1]),
                                  .allowed = "a distance of at least " + text(least_margin * h) +
                                             " where it is cut, as at " + text(p)});
            }
            result.push_back(p);
            network.points.push_back(p);
            const auto next = static_cast<std::uint32_t>(network.points.size() - 1);
            network.pieces.push_back({{from, next}, edge});
            from = next;
        }
        network.pieces.push_back({{from, to}, edge});
        from = to;
    }
    result.push_back(points.back());
    return result;
}

[[noreturn]] void refuse_contact(const Network& network, const EdgeContact& contact) {
    const auto name = [&](std::uint32_t edge) {
        const auto after =
            std::upper_bound(network.first_edge.begin(), network.first_edge.end(), edge);
        const auto k = static_cast<std::size_t>(after - network.first_edge.begin()) - 1;
        return curve_edge_name(k, edge - network.first_edge[k]);
    };
    throw InputError(
        {.what = "curves cross or touch",
         .where = name(contact.edge),
         .value = "contact with " + name(contact.other_edge),
         .allowed = "curves that meet nothing but the ends of curves with their ends"});
}

} // namespace

template <class Real>
CheckedCurves check_curves(const Rectangle& domain, std::span<const Curve> curves,
                           const InitialOptions& options) {
    const double h = options.edge_length;
    CheckedCurves input;
    input.lattice = check_domain<Real>(domain, options);
    std::vector<Points> rounded_curves;
    double pieces = 0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        check_phases(curves[k], k);
        rounded_curves.push_back(check_points<Real>(curves[k].points, k));
        check_places(rounded_curves.back(), k, input.lattice, h);
        for (std::size_t i = 0; i + 1 < curves[k].points.size(); ++i) {
            pieces += piece_count(curves[k].points[i], curves[k].points[i + 1], h);
        }
        if (pieces > most_pieces) {
            throw InputError({.what = "the curves would be cut into absurdly many pieces",
                              .where = curve_name(k),
                              .value = text(pieces),
                              .allowed = "at most " + text(most_pieces)});
        }
    }
    Network network;
    const auto ends = join_ends(curves, rounded_curves, input.lattice, network);
    for (std::size_t k = 0; k < curves.size(); ++k) {
        network.first_edge.push_back(static_cast<std::uint32_t>(network.edges.size()));
        input.curves.push_back(
            {cut<Real>(curves[k].points, rounded_curves[k], k, h, input.lattice, ends[k], network),
             curves[k].left, curves[k].right});
    }
    // A point that cuts an edge is at most a step of the scalar off it.
    const double reach = h / least_steps;
    if (const auto contact = find_contact(network.points, network.edges, network.pieces, reach)) {
        refuse_contact(network, *contact);
    }
    return input;
}

template CheckedCurves check_curves<double>(const Rectangle&, std::span<const Curve>,
                                            const InitialOptions&);
template CheckedCurves check_curves<float>(const Rectangle&, std::span<const Curve>,
                                           const InitialOptions&);

} // namespace dsc::initial
