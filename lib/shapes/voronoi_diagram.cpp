// SPDX-License-Identifier: MIT
#include "shapes/voronoi_diagram.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dsc::scenes {

namespace {

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

} // namespace

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

} // namespace dsc::scenes
