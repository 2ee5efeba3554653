// SPDX-License-Identifier: MIT
// Boost.Polygon (S. Fortune, "A sweepline algorithm for Voronoi diagrams", 1987) finds exactly
// which cells meet, for sites rounded to a fine grid of integers. The sides of the domain act as
// mirrors: each site has an image behind each side, and the side is the bisector of the site and
// its image. Vertices are then computed from the unrounded sites.
#include "shapes/voronoi_diagram.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <string>

namespace dsc::scenes {

namespace {

/// Steps of the grid along the longer side; the images still fit into 32 bits.
constexpr double grid_steps = 0x1p29;

using GridPoint = boost::polygon::point_data<std::int32_t>;
using GridDiagram = boost::polygon::voronoi_diagram<double>;

// The cells that meet at a vertex: sites, ascending, and sides of the domain, as bits.
struct Meeting {
    std::vector<std::uint32_t> sites;
    std::uint8_t sides = 0;

    void add(std::uint32_t one) {
        if (is_side(one)) {
            sides |= static_cast<std::uint8_t>(1U << (one - bottom_side));
        } else if (const auto at = std::ranges::lower_bound(sites, one);
                   at == sites.end() || *at != one) {
            sites.insert(at, one);
        }
    }

    [[nodiscard]] std::string described() const {
        std::string words;
        for (const std::uint32_t site : sites) {
            words += (words.empty() ? "site " : ", site ") + std::to_string(site);
        }
        for (unsigned side = 0; side < 4; ++side) {
            words += (sides >> side & 1U) != 0 ? ", side " + std::to_string(side) : "";
        }
        return words;
    }
};

std::string site_name(std::size_t site) { return "site " + std::to_string(site); }

[[noreturn]] void refuse(const std::string& where, const std::string& value) {
    throw InputError({.what = "rounding decides which cells meet: sites are nearly cocircular, "
                              "too close to each other, or aligned with a corner of the domain",
                      .where = where,
                      .value = value,
                      .allowed = "sites in general position, for example slightly shifted"});
}

// The sites on the grid, followed by their images at the four sides, n each.
std::vector<GridPoint> with_images(const Rectangle& domain, std::span<const Point<double>> sites) {
    const Point<double> size = domain.high - domain.low;
    const double scale = grid_steps / size.maxCoeff();
    const auto on_grid = [&](double way) {
        return static_cast<std::int32_t>(std::lround(way * scale));
    };
    const std::int32_t width = std::max(on_grid(size.x()), 2);
    const std::int32_t height = std::max(on_grid(size.y()), 2);
    std::vector<GridPoint> points;
    for (const Point<double>& site : sites) {
        // Not on a side, where site and image would coincide.
        points.emplace_back(std::clamp(on_grid(site.x() - domain.low.x()), 1, width - 1),
                            std::clamp(on_grid(site.y() - domain.low.y()), 1, height - 1));
    }
    std::map<GridPoint, std::size_t> before;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const auto [found, is_new] = before.try_emplace(points[i], i);
        if (!is_new) {
            throw InputError({.what = "two sites coincide or nearly do",
                              .where = site_name(found->second),
                              .value = to_text(sites[i]) + ", as " + site_name(i),
                              .allowed = "sites that are apart"});
        }
    }
    const auto add_images = [&](auto image) {
        for (std::size_t i = 0; i < sites.size(); ++i) {
            points.push_back(image(points[i]));
        }
    };
    add_images([](const GridPoint& p) { return GridPoint(p.x(), -p.y()); });
    add_images([&](const GridPoint& p) { return GridPoint(2 * width - p.x(), p.y()); });
    add_images([&](const GridPoint& p) { return GridPoint(p.x(), 2 * height - p.y()); });
    add_images([](const GridPoint& p) { return GridPoint(-p.x(), p.y()); });
    return points;
}

// The intersection of the bisector of two sites with a side of the domain.
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

// The number of the vertex where these cells meet: a new one, or a corner of the domain.
std::uint32_t add_vertex(const Meeting& m, VoronoiDiagram& diagram) {
    const auto site = [&](std::size_t i) { return diagram.sites[m.sites[i]]; };
    const auto corner =
        std::ranges::find(diagram.sides.begin(), diagram.sides.begin() + domain_corners, m.sides);
    if (corner != diagram.sides.begin() + domain_corners) {
        if (m.sites.size() > 1) {
            refuse(m.described(), "a vertex at a corner of the domain");
        }
        return static_cast<std::uint32_t>(corner - diagram.sides.begin());
    }
    const bool on_side = m.sides != 0;
    if (m.sites.size() < (on_side ? 2U : 3U)) {
        refuse(m.described(), "a vertex of fewer than three cells or sides");
    }
    const auto side = static_cast<std::uint32_t>(std::countr_zero(m.sides));
    const Point<double> p =
        on_side ? point_on_side(diagram.domain, bottom_side + side, site(0), site(1))
                : circumcentre<double>(site(0), site(1), site(2));
    const auto between = [&](Eigen::Index axis) {
        return diagram.domain.low[axis] < p[axis] && p[axis] < diagram.domain.high[axis];
    };
    if (!(on_side ? between(side % 2) : between(0) && between(1))) {
        refuse(m.described(), "a vertex outside the domain after rounding");
    }
    diagram.vertices.push_back(p);
    diagram.sides.push_back(m.sides);
    return static_cast<std::uint32_t>(diagram.vertices.size() - 1);
}

} // namespace

std::vector<Point<double>> VoronoiDiagram::corners_of(const VoronoiCell& cell) const {
    std::vector<Point<double>> corners;
    for (const std::uint32_t v : cell.vertices) {
        corners.push_back(vertices[v]);
    }
    return corners;
}

Point<double> centroid(std::span<const Point<double>> corners) {
    double area = 0;
    Point<double> moment = Point<double>::Zero();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        // Relative to the first corner, so that an offset of the coordinates costs no digits.
        const Point<double> p = corners[k] - corners[0];
        const Point<double> q = corners[k + 1 < corners.size() ? k + 1 : 0] - corners[0];
        const double cross = p.x() * q.y() - p.y() * q.x();
        area += cross;
        moment += cross * (p + q);
    }
    return corners[0] + moment / (3 * area);
}

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
    VoronoiDiagram diagram{.domain = domain,
                           .sites = {sites.begin(), sites.end()},
                           .vertices = {domain.low,
                                        {domain.high.x(), domain.low.y()},
                                        domain.high,
                                        {domain.low.x(), domain.high.y()}},
                           .sides = {0b1001, 0b0011, 0b0110, 0b1100},
                           .cells = std::vector<VoronoiCell>(sites.size())};
    const std::vector<GridPoint> points = with_images(domain, sites);
    GridDiagram grid;
    boost::polygon::construct_voronoi(points.begin(), points.end(), &grid);
    std::vector<Meeting> meetings(grid.num_vertices());
    const auto count = static_cast<std::uint32_t>(sites.size());
    for (const GridDiagram::cell_type& cell : grid.cells()) {
        const auto i = static_cast<std::uint32_t>(cell.source_index());
        if (i >= count) {
            continue; // the cell of an image
        }
        const GridDiagram::edge_type* edge = cell.incident_edge();
        do {
            const auto other = static_cast<std::uint32_t>(edge->twin()->cell()->source_index());
            const std::uint32_t beyond = other < count ? other : bottom_side + other / count - 1;
            for (const auto* end : {edge->vertex0(), edge->vertex1()}) {
                Meeting& meeting = meetings[static_cast<std::size_t>(end - grid.vertices().data())];
                meeting.add(i);
                meeting.add(beyond);
            }
            diagram.cells[i].vertices.push_back(
                static_cast<std::uint32_t>(edge->vertex0() - grid.vertices().data()));
            diagram.cells[i].beyond.push_back(beyond);
            edge = edge->next();
        } while (edge != cell.incident_edge());
    }
    std::vector<std::uint32_t> numbers; // of the vertices of the cells of sites
    for (const Meeting& meeting : meetings) {
        numbers.push_back(meeting.sites.empty() ? 0 : add_vertex(meeting, diagram));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        VoronoiCell& cell = diagram.cells[i];
        std::ranges::transform(cell.vertices, cell.vertices.begin(),
                               [&](std::uint32_t v) { return numbers[v]; });
        if (!is_seen_from(sites[i], diagram.corners_of(cell), cell.beyond)) {
            refuse(site_name(i), "vertices of its cell that coincide after rounding");
        }
    }
    return diagram;
}

} // namespace dsc::scenes
