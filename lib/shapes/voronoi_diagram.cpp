// SPDX-License-Identifier: MIT
#include "shapes/voronoi_diagram.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <string>
#include <utility>

namespace dsc::scenes {

namespace {

// Whether the whole cell is seen from a point in it: each edge goes counter-clockwise about it,
// with some length. The point may lie on a side of the domain. Exact. Such a cell is a simple
// polygon.
bool is_seen_from(const Point<double>& point, std::span<const Point<double>> corners,
                  std::span<const std::uint32_t> beyond) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point<double>& p = corners[k];
        const Point<double>& q = corners[k + 1 < corners.size() ? k + 1 : 0];
        const int turn = orientation<double>(point, p, q);
        if (p == q || turn < 0 || (turn == 0 && !is_side(beyond[k]))) {
            return false;
        }
    }
    return true;
}

// --- the diagram of the sites --------------------------------------------------------------------

// The numbers that meet at a vertex, ascending: three sites, two sites and a side, or a site and
// two sides.
using Meeting = std::array<std::uint32_t, 3>;

// A vertex as one cell sees it.
struct Sighting {
    Meeting meeting;
    std::uint32_t cell;
    std::uint32_t place; // in the cell
};

std::string described(const Meeting& meeting) {
    std::string words;
    for (const std::uint32_t m : meeting) {
        words +=
            (words.empty() ? "" : ", ") +
            (is_side(m) ? "side " + std::to_string(m - bottom_side) : "site " + std::to_string(m));
    }
    return words;
}

std::vector<Sighting> sightings_of(const std::vector<ClippedCell>& cells) {
    std::vector<Sighting> sightings;
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        const auto& beyond = cells[i].beyond;
        for (std::uint32_t k = 0; k < beyond.size(); ++k) {
            Meeting meeting{i, beyond[k > 0 ? k - 1 : beyond.size() - 1], beyond[k]};
            std::sort(meeting.begin(), meeting.end());
            sightings.push_back({meeting, i, k});
        }
    }
    std::sort(sightings.begin(), sightings.end(), [](const Sighting& a, const Sighting& b) {
        return a.meeting != b.meeting ? a.meeting < b.meeting : a.cell < b.cell;
    });
    return sightings;
}

[[noreturn]] void refuse(const std::string& where, const std::string& value) {
    throw InputError({.what = "it is not certain which cells meet: sites are cocircular, too close "
                              "to each other, or level with a corner of the domain",
                      .where = where,
                      .value = value,
                      .allowed = "sites in general position; if need be, shifted a little"});
}

// Each site of the meeting sees the vertex once, and no other site does.
void check_agreement(std::span<const Sighting> group) {
    const Meeting& meeting = group.front().meeting;
    const auto sites = static_cast<std::size_t>(
        std::count_if(meeting.begin(), meeting.end(), [](std::uint32_t m) { return !is_side(m); }));
    bool agreed = group.size() == sites;
    for (std::size_t k = 0; agreed && k < sites; ++k) {
        agreed = group[k].cell == meeting[k];
    }
    if (!agreed) {
        refuse(described(meeting),
               "a vertex that is seen from " + std::to_string(group.size()) + " of these sites");
    }
}

// Where the bisector of two sites meets a side of the domain.
Point<double> point_on_side(const Rectangle& domain, std::uint32_t side, const Point<double>& a,
                            const Point<double>& b) {
    const Point<double> middle = (a + b) / 2;
    const Point<double> d = b - a;
    if (side == bottom_side || side == top_side) {
        const double y = side == bottom_side ? domain.low.y() : domain.high.y();
        return {middle.x() - d.y() * (y - middle.y()) / d.x(), y};
    }
    const double x = side == left_side ? domain.low.x() : domain.high.x();
    return {x, middle.y() - d.x() * (x - middle.x()) / d.y()};
}

// The corner of the domain at which two sides meet.
std::uint32_t corner_between(std::uint32_t side, std::uint32_t other) {
    // Corner k is the end of side k - 1 and the beginning of side k.
    return side == bottom_side && other == left_side ? 0 : other - bottom_side;
}

// The vertex of a meeting with at most one side, and on that side if there is one.
Point<double> vertex_at(const Rectangle& domain, std::span<const Point<double>> sites,
                        const Meeting& m) {
    const bool on_side = is_side(m[2]);
    const Point<double> p = on_side ? point_on_side(domain, m[2], sites[m[0]], sites[m[1]])
                                    : circumcentre<double>(sites[m[0]], sites[m[1]], sites[m[2]]);
    const auto between = [&](Eigen::Index axis) {
        return domain.low[axis] < p[axis] && p[axis] < domain.high[axis];
    };
    const bool level = on_side && (m[2] == bottom_side || m[2] == top_side);
    if (!(on_side ? between(level ? 0 : 1) : between(0) && between(1))) {
        refuse(described(m), "a vertex that is not inside the domain once it is rounded");
    }
    return p;
}

// --- without its short edges ---------------------------------------------------------------------

// Vertices that have become one, by the smallest of their numbers.
struct Cluster {
    std::vector<std::uint32_t> members; // ascending
    std::vector<std::uint32_t> cells;   // ascending
    Point<double> place{0.0, 0.0};
};

struct ShortEdge {
    double squared_length;
    std::uint32_t from;
    std::uint32_t to;

    friend auto operator<=>(const ShortEdge&, const ShortEdge&) = default;
};

std::vector<std::uint32_t> merged(const std::vector<std::uint32_t>& a,
                                  const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

class Contraction {
public:
    explicit Contraction(VoronoiDiagram diagram) : diagram_(std::move(diagram)) {
        clusters_.resize(diagram_.vertices.size());
        for (std::uint32_t v = 0; v < clusters_.size(); ++v) {
            cluster_of_.push_back(v);
            clusters_[v].members = {v};
            clusters_[v].place = diagram_.vertices[v];
        }
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            for (const std::uint32_t v : diagram_.cells[i].vertices) {
                clusters_[v].cells.push_back(i);
            }
            centres_.push_back(centroid(corners_of(diagram_.cells[i])));
        }
    }

    // Tries each short edge once, the shortest first; returns how many are gone.
    std::size_t contract(double shortest) {
        std::size_t gone = 0;
        for (const ShortEdge& edge : edges_below(shortest)) {
            const std::uint32_t a = cluster_of_[edge.from];
            const std::uint32_t b = cluster_of_[edge.to];
            // The edge may be gone, or longer, since the list was made.
            if (a != b && (clusters_[a].place - clusters_[b].place).norm() < shortest) {
                gone += merge(std::min(a, b), std::max(a, b)) ? 1U : 0U;
            }
        }
        return gone;
    }

    VoronoiDiagram result() {
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            diagram_.cells[i] = shrunk(i);
        }
        for (std::uint32_t v = 0; v < clusters_.size(); ++v) {
            diagram_.vertices[v] = clusters_[v].place;
            for (const std::uint32_t member : clusters_[v].members) {
                diagram_.sides[v] |= diagram_.sides[member];
            }
        }
        return std::move(diagram_);
    }

private:
    [[nodiscard]] std::vector<Point<double>> corners_of(const VoronoiCell& cell) const {
        std::vector<Point<double>> corners;
        for (const std::uint32_t v : cell.vertices) {
            corners.push_back(clusters_[v].place);
        }
        return corners;
    }

    // The cell with one vertex for each cluster, and without contracted edges.
    [[nodiscard]] VoronoiCell shrunk(std::uint32_t cell) const {
        const VoronoiCell& whole = diagram_.cells[cell];
        VoronoiCell result;
        const std::size_t n = whole.vertices.size();
        for (std::size_t k = 0; k < n; ++k) {
            const std::uint32_t v = cluster_of_[whole.vertices[k]];
            if (v != cluster_of_[whole.vertices[k + 1 < n ? k + 1 : 0]]) {
                result.vertices.push_back(v);
                result.beyond.push_back(whole.beyond[k]);
            }
        }
        return result;
    }

    [[nodiscard]] std::vector<ShortEdge> edges_below(double shortest) const {
        std::vector<ShortEdge> edges;
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            const VoronoiCell cell = shrunk(i);
            const std::size_t n = cell.vertices.size();
            for (std::size_t k = 0; k < n; ++k) {
                const auto [a, b] =
                    std::minmax(cell.vertices[k], cell.vertices[k + 1 < n ? k + 1 : 0]);
                const double squared = (clusters_[a].place - clusters_[b].place).squaredNorm();
                if (cell.beyond[k] > i && squared < shortest * shortest) {
                    edges.push_back({squared, a, b});
                }
            }
        }
        std::sort(edges.begin(), edges.end());
        return edges;
    }

    // Where these vertices become one: a corner of the domain stays, and so does its side.
    [[nodiscard]] std::optional<Point<double>>
    place_of(const std::vector<std::uint32_t>& members) const {
        unsigned sides = 0;
        for (const std::uint32_t v : members) {
            sides |= diagram_.sides[v];
        }
        if (members.front() < domain_corners) {
            return sides == diagram_.sides[members.front()]
                       ? std::optional(diagram_.vertices[members.front()])
                       : std::nullopt;
        }
        if (std::popcount(sides) > 1) {
            return std::nullopt;
        }
        Point<double> sum = Point<double>::Zero();
        const Point<double>* on_side = nullptr;
        int count = 0;
        for (const std::uint32_t v : members) {
            if (diagram_.sides[v] == sides) {
                sum += diagram_.vertices[v];
                on_side = &diagram_.vertices[v];
                ++count;
            }
        }
        Point<double> place = sum / count;
        if (sides != 0) { // not even by rounding off its side
            const bool level = (sides & 0b0101U) != 0;
            place[level ? 1 : 0] = (*on_side)[level ? 1 : 0];
        }
        return place;
    }

    // Makes cluster `b` part of `a` if all cells around them stay sound.
    bool merge(std::uint32_t a, std::uint32_t b) {
        const std::vector<std::uint32_t> members =
            merged(clusters_[a].members, clusters_[b].members);
        const auto place = place_of(members);
        if (!place) {
            return false;
        }
        const Point<double> before = clusters_[a].place;
        const std::vector<std::uint32_t> cells = merged(clusters_[a].cells, clusters_[b].cells);
        for (const std::uint32_t v : clusters_[b].members) {
            cluster_of_[v] = a;
        }
        clusters_[a].place = *place;
        if (!std::all_of(cells.begin(), cells.end(),
                         [&](std::uint32_t cell) { return is_sound(cell); })) {
            for (const std::uint32_t v : clusters_[b].members) {
                cluster_of_[v] = b;
            }
            clusters_[a].place = before;
            return false;
        }
        clusters_[a].members = members;
        clusters_[a].cells = cells;
        clusters_[b].members.clear();
        clusters_[b].cells.clear();
        return true;
    }

    // A cell that has lost its third side turns clockwise on the way back along its second one.
    [[nodiscard]] bool is_sound(std::uint32_t cell) const {
        const VoronoiCell shape = shrunk(cell);
        return is_seen_from(centres_[cell], corners_of(shape), shape.beyond);
    }

    VoronoiDiagram diagram_;
    std::vector<Point<double>> centres_;    // of the cells, before anything is contracted
    std::vector<std::uint32_t> cluster_of_; // by vertex
    std::vector<Cluster> clusters_;         // by the smallest member; the others are empty
};

} // namespace

VoronoiDiagram voronoi_diagram(const Rectangle& domain, std::span<const Point<double>> sites) {
    const std::vector<ClippedCell> clipped = clip_cells(domain, sites);
    VoronoiDiagram diagram{domain,
                           {sites.begin(), sites.end()},
                           {domain.low,
                            {domain.high.x(), domain.low.y()},
                            domain.high,
                            {domain.low.x(), domain.high.y()}},
                           {0b1001, 0b0011, 0b0110, 0b1100},
                           {}};
    diagram.cells.reserve(clipped.size());
    for (const ClippedCell& cell : clipped) {
        diagram.cells.push_back({std::vector<std::uint32_t>(cell.beyond.size()), cell.beyond});
    }
    const std::vector<Sighting> sightings = sightings_of(clipped);
    std::array<bool, domain_corners> seen{};
    for (std::size_t i = 0; i < sightings.size();) {
        const Meeting& m = sightings[i].meeting;
        std::size_t end = i + 1;
        while (end < sightings.size() && sightings[end].meeting == m) {
            ++end;
        }
        const std::span group = std::span(sightings).subspan(i, end - i);
        check_agreement(group);
        auto vertex = static_cast<std::uint32_t>(diagram.vertices.size());
        if (is_side(m[1])) {
            vertex = corner_between(m[1], m[2]);
            if (std::exchange(seen[vertex], true)) {
                refuse(described(m), "a vertex at a corner of the domain");
            }
        } else {
            diagram.vertices.push_back(vertex_at(domain, sites, m));
            diagram.sides.push_back(
                is_side(m[2]) ? static_cast<std::uint8_t>(1U << (m[2] - bottom_side)) : 0);
        }
        for (const Sighting& sighting : group) {
            diagram.cells[sighting.cell].vertices[sighting.place] = vertex;
        }
        i = end;
    }
    std::vector<Point<double>> corners;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        corners.clear();
        for (const std::uint32_t v : diagram.cells[i].vertices) {
            corners.push_back(diagram.vertices[v]);
        }
        if (!is_seen_from(sites[i], corners, diagram.cells[i].beyond)) {
            refuse("site " + std::to_string(i), "vertices of its cell that are one when rounded");
        }
    }
    return diagram;
}

VoronoiDiagram without_short_edges(VoronoiDiagram diagram, double shortest) {
    Contraction contraction(std::move(diagram));
    while (contraction.contract(shortest) > 0) {
    }
    return contraction.result();
}

} // namespace dsc::scenes
