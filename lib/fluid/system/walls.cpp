// SPDX-License-Identifier: MIT
#include "fluid/system/walls.h"

#include "dsc/base/error.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/side.h"
#include "fluid/system/conditions.h"
#include "fluid/system/curved_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace dsc {

namespace {

// An edge of the boundary, with the domain on its left.
struct WallEdge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t middle;
    std::uint32_t triangle;
    Wall wall;
    std::uint32_t side = no_id; // in `FluidOptions::sides`; no_id: none of them
};

std::vector<WallEdge> edges_of(const MeshSnapshot& mesh, const FluidOptions& options) {
    const SideConditions conditions(mesh.domain, options);
    std::vector<WallEdge> edges;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const SnapshotTriangle& triangle = mesh.triangles[t];
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (triangle.across[i] != no_id) {
                continue;
            }
            const std::uint32_t from = triangle.nodes[next_index(i)];
            const std::uint32_t to = triangle.nodes[prev_index(i)];
            const std::uint32_t middle = triangle.nodes[3 + i];
            const auto [wall, side] = conditions.between(mesh.nodes[from], mesh.nodes[to]);
            edges.push_back({from, to, middle, t, wall, side});
        }
    }
    return edges;
}

// The conditions of the edges at a node; of the edges before and after it in the arrays. A midpoint
// has only an edge after it.
struct AtNode {
    std::array<const WallEdge*, 2> sticks{};           // edges without slip
    std::array<std::optional<Point<double>>, 2> slips; // directions of the edges that slip
    std::array<std::uint32_t, 2> ends{no_id, no_id};   // the nodes before and after this one
    std::uint32_t side = no_id;
};

void add(AtNode& at, const WallEdge& edge, const MeshSnapshot& mesh, bool is_after) {
    const std::size_t place = is_after ? 1 : 0;
    at.side = std::min(at.side, edge.side);
    if (edge.wall == Wall::no_slip) {
        at.sticks[place] = &edge;
    } else if (edge.wall == Wall::slip) {
        at.slips[place] = mesh.nodes[edge.to] - mesh.nodes[edge.from];
        at.ends[place] = is_after ? edge.to : edge.from;
    }
}

// The velocity of a wall without slip. `way` is the direction of the wall, with the domain on its
// left.
Point<double> wall_velocity(std::uint32_t side, const Point<double>& place,
                            const Point<double>& way, const FluidOptions& options, double time) {
    if (side != no_id && options.sides[side].inflow) {
        return options.sides[side].inflow(place, time) * turned_left(way.normalized());
    }
    if (side != no_id && options.sides[side].velocity) {
        return options.sides[side].velocity(place, time);
    }
    return side == no_id && options.wall_velocity ? options.wall_velocity(place, time)
                                                  : Point<double>(0, 0);
}

Point<double> sticking(std::uint32_t node, const AtNode& at, const MeshSnapshot& mesh,
                       const FluidOptions& options, double time) {
    const auto [before, after] = at.sticks;
    const auto way = [&](const WallEdge* edge) {
        return edge == nullptr ? Point<double>(0, 0)
                               : Point<double>(mesh.nodes[edge->to] - mesh.nodes[edge->from]);
    };
    const auto velocity = [&](std::uint32_t side, const Point<double>& along) {
        return wall_velocity(side, mesh.nodes[node], along, options, time);
    };
    if (before == nullptr || after == nullptr || before->side == after->side) {
        const WallEdge* any = after == nullptr ? before : after;
        const Point<double> moving = velocity(any->side, way(before) + way(after));
        const auto& slips = at.slips[after == nullptr ? 1 : 0]; // of the other edge, if it slips
        return slips && any->side != no_id
                   ? Point<double>(moving.dot(*slips) / slips->squaredNorm() * *slips)
                   : moving;
    }
    const WallEdge* first = before->side < after->side ? before : after;
    const Point<double> one = velocity(first->side, way(first));
    const WallEdge* second = first == before ? after : before;
    return velocity(second->side, way(second)).isZero(0) ? Point<double>(0, 0) : one;
}

// The total flow through the two edges at a node is zero if the normal at the node is their mean,
// weighted by length: the normal of the line between the other ends of the edges.
WallNode slipping(std::uint32_t node, const AtNode& at, const MeshSnapshot& mesh) {
    const bool has_two = at.slips[0] && at.slips[1];
    const Point<double> way = has_two ? Point<double>(*at.slips[0] + *at.slips[1])
                                      : at.slips[0].value_or(*at.slips[at.slips[0] ? 0 : 1]);
    if (has_two &&
        side_at<double>(mesh.nodes[at.ends[0]], mesh.nodes[node], mesh.nodes[at.ends[1]],
                        std::ranges::binary_search(mesh.features, node)) == Side::feature) {
        return {.node = node, .held = {true, true}};
    }
    if (way.x() == 0) {
        return {.node = node, .held = {true, false}};
    }
    if (way.y() == 0) {
        return {.node = node, .held = {false, true}};
    }
    return {.node = node, .first = way.normalized(), .held = {false, true}};
}

bool is_of_box(const std::string& name) {
    return name == "left" || name == "right" || name == "bottom" || name == "top" ||
           name == "other";
}

// Without an open side, what flows in has to flow out, up to rounding.
void check_balance(const std::vector<WallEdge>& edges, const FluidWalls& walls,
                   const MeshSnapshot& mesh) {
    constexpr double rounding = 1e-9; // a larger rest makes the solution fail
    std::vector<Point<double>> velocity(mesh.nodes.size(), Point<double>(0, 0));
    for (const WallNode& node : walls.nodes) {
        velocity[node.node] = node.velocity;
    }
    double net = 0;
    double all = 0;
    for (const WallEdge& edge : edges) {
        const Point<double> inwards = turned_left(mesh.nodes[edge.to] - mesh.nodes[edge.from]);
        const double flow =
            inwards.dot(velocity[edge.from] + 4 * velocity[edge.middle] + velocity[edge.to]) / 6;
        net += flow;
        all += inwards.norm() * velocity[edge.middle].norm();
    }
    if (std::abs(net) > rounding * all) {
        throw InputError({.what = net > 0 ? "more flows into the domain than out of it"
                                          : "more flows out of the domain than into it",
                          .where = "FluidOptions",
                          .value = to_text(std::abs(net)) + " more, of area per time",
                          .allowed = "equal inflow and outflow, or an open side"});
    }
}

// The edges of the boundary before and after each vertex.
using EdgesBeside = std::vector<std::array<const WallEdge*, 2>>;

EdgesBeside edges_beside(const std::vector<WallEdge>& edges, const MeshSnapshot& mesh) {
    EdgesBeside beside(mesh.vertex_bound, {nullptr, nullptr});
    for (const WallEdge& edge : edges) {
        beside[edge.to][0] = &edge;
        beside[edge.from][1] = &edge;
    }
    return beside;
}

WallNode& wall_node(FluidWalls& walls, std::uint32_t node) {
    return *std::ranges::lower_bound(walls.nodes, node, {}, &WallNode::node);
}

// On a curved side without slip the middle of an edge moves with the fluid beside the wall, along
// the edge: nothing more flows through it. The velocities of the wall are those at the middle so
// far.
void correct_curved_walls(const std::vector<WallEdge>& edges, const EdgesBeside& beside,
                          const MeshSnapshot& mesh, const FluidOptions& options, double time,
                          const FluidField* last, FluidWalls& walls) {
    for (const WallEdge& edge : edges) {
        if (edge.wall != Wall::no_slip) {
            continue;
        }
        const Point<double> sagitta = sagitta_of(mesh, beside[edge.from][0]->from, edge.from,
                                                 edge.to, beside[edge.to][1]->to);
        if (sagitta.isZero(0)) {
            continue;
        }
        walls.has_curved = true;
        if (last == nullptr) {
            return;
        }
        const Point<double> way = mesh.nodes[edge.to] - mesh.nodes[edge.from];
        WallNode& node = wall_node(walls, edge.middle);
        const Point<double> at_wall =
            wall_velocity(edge.side, mesh.nodes[edge.middle] + sagitta, way, options, time);
        const Point<double> change =
            at_wall - node.velocity -
            change_to_wall(*last, mesh, mesh.triangles[edge.triangle], edge.middle, sagitta);
        node.velocity += change.dot(way) / way.squaredNorm() * way;
    }
}

// On a curved side with slip a vertex moves along the tangent of its circle. Where its edges are
// not equally long, that is not the direction in which as much flows in through one as out through
// the other: what is held is the rest, by the last velocity. The flow through each half of an edge
// then returns through its middle. Together the edges of a vertex let nothing through in either
// case. Beside a point within a straight edge of the outline the circle is not known.
void correct_curved_slips(const EdgesBeside& beside, const MeshSnapshot& mesh,
                          const FluidField* last, FluidWalls& walls) {
    const auto side_of = [&](std::uint32_t v) {
        return side_at<double>(mesh.nodes[beside[v][0]->from], mesh.nodes[v],
                               mesh.nodes[beside[v][1]->to],
                               std::ranges::binary_search(mesh.features, v));
    };
    for (std::uint32_t v = 0; v < mesh.vertex_bound; ++v) {
        const auto [before, after] = beside[v];
        if (before == nullptr || before->wall != Wall::slip || after->wall != Wall::slip ||
            side_of(v) != Side::curved || side_of(before->from) == Side::straight ||
            side_of(after->to) == Side::straight) {
            continue;
        }
        walls.has_curved = true;
        if (last == nullptr) {
            return;
        }
        const Point<double>& from = mesh.nodes[before->from];
        const Point<double>& to = mesh.nodes[after->to];
        const Point<double> free = (to - from).normalized();
        const Point<double> tangent = tangent_of_side<double>(from, mesh.nodes[v], to);
        const Spot spot = find_spot(last->mesh, mesh.nodes[v], start_at(last->mesh, v));
        const double speed = velocity_at(*last, spot).dot(free);
        const Point<double> moving = speed / tangent.dot(free) * tangent;
        wall_node(walls, v).velocity = moving - speed * free;
        for (const WallEdge* edge : {before, after}) {
            const Point<double> normal =
                turned_left(mesh.nodes[edge->to] - mesh.nodes[edge->from]).normalized();
            wall_node(walls, edge->middle).velocity -= moving.dot(normal) / 4 * normal;
        }
    }
}

// Whether the point between two edges of the boundary must stay: the conditions there differ, and
// an interface cannot slide from one to the other.
bool is_end_of_side(const SideCondition& one, const SideCondition& other) {
    const bool slides = one.wall == other.wall && one.wall != Wall::no_slip;
    return !slides && (one.wall != other.wall || one.side != other.side);
}

// An end of a side within a straight wall may have been left out of the mesh because it is too near
// to another point. The side would be longer or shorter than it was given.
void check_ends_exist(const MeshSnapshot& mesh, const FluidOptions& options,
                      const std::vector<WallEdge>& edges) {
    struct End {
        Point<double> at;
        Point<double> other;
        SideCondition condition;
    };
    const SideConditions conditions(mesh.domain, options);
    std::vector<End> ends;
    for (const DomainEdge& edge : options.domain_edges) {
        const SideCondition condition = conditions.between(edge.from, edge.to);
        ends.push_back({edge.from, edge.to, condition});
        ends.push_back({edge.to, edge.from, condition});
    }
    std::ranges::sort(ends, {}, [](const End& end) { return std::pair(end.at.x(), end.at.y()); });
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const End& one = ends[i];
        const End& other = ends[i + 1];
        if (one.at != other.at || !is_end_of_side(one.condition, other.condition) ||
            side_at<double>(one.other, one.at, other.other, false) != Side::straight) {
            continue;
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (const WallEdge& edge : edges) {
            nearest = std::min(nearest, (mesh.nodes[edge.from] - one.at).norm());
        }
        constexpr double rounding = 1e-9;
        const double length = (mesh.domain.high - mesh.domain.low).maxCoeff();
        if (nearest > rounding * length) {
            throw InputError(
                {.what = "two sides meet where the mesh has no vertex",
                 .where = "FluidOptions::domain_edges",
                 .value = to_text(one.at) + ", " + to_text(nearest) + " from the nearest one",
                 .allowed = "a mesh with a vertex there: initial_complex of a Polygon with this "
                            "point, with an edge length of at most five times the distance to the "
                            "next one, or Detail::keep"});
        }
    }
}

} // namespace

void check_sides_exist(const MeshSnapshot& mesh, const FluidOptions& options) {
    const std::vector<WallEdge> edges = edges_of(mesh, options);
    const std::vector<FluidSide>& sides = options.sides;
    for (std::uint32_t k = 0; k < sides.size(); ++k) {
        const bool may_be_missing =
            is_of_box(sides[k].name) && !sides[k].velocity && !sides[k].inflow;
        if (!may_be_missing && std::ranges::find(edges, k, &WallEdge::side) == edges.end()) {
            throw InputError({.what = "no edge of the mesh's boundary is on this side",
                              .where = "FluidOptions::sides",
                              .value = "side '" + sides[k].name + "'",
                              .allowed =
                                  "names in FluidOptions::domain_edges; left, right, bottom, "
                                  "top and other for the rest of the boundary"});
        }
    }
    if (!sides.empty()) {
        check_ends_exist(mesh, options, edges);
    }
}

std::vector<Vertex> ends_of_sides(const MeshSnapshot& mesh, const FluidOptions& options) {
    if (options.wall_at) {
        return {};
    }
    const std::vector<WallEdge> edges = edges_of(mesh, options);
    std::vector<const WallEdge*> before(mesh.vertex_bound, nullptr);
    for (const WallEdge& edge : edges) {
        before[edge.to] = &edge;
    }
    std::vector<Vertex> ends;
    for (const WallEdge& edge : edges) {
        const WallEdge& other = *before[edge.from];
        if (is_end_of_side({edge.wall, edge.side}, {other.wall, other.side})) {
            ends.push_back(Vertex{edge.from});
        }
    }
    return ends;
}

FluidWalls walls_of(const MeshSnapshot& mesh, const FluidOptions& options, double time,
                    const FluidField* last) {
    FluidWalls walls;
    std::map<std::uint32_t, AtNode> at_nodes;
    const std::vector<WallEdge> edges = edges_of(mesh, options);
    for (const WallEdge& edge : edges) {
        if (edge.wall == Wall::open) {
            walls.has_open = true;
            continue;
        }
        add(at_nodes[edge.from], edge, mesh, true);
        add(at_nodes[edge.to], edge, mesh, false);
        add(at_nodes[edge.middle], edge, mesh, true);
    }
    for (const auto& [node, at] : at_nodes) {
        if (at.sticks[0] == nullptr && at.sticks[1] == nullptr) {
            walls.nodes.push_back(slipping(node, at, mesh));
        } else {
            walls.nodes.push_back({.node = node,
                                   .held = {true, true},
                                   .velocity = sticking(node, at, mesh, options, time)});
        }
        walls.nodes.back().side = at.side;
    }
    const EdgesBeside beside = edges_beside(edges, mesh);
    correct_curved_walls(edges, beside, mesh, options, time, last, walls);
    for (const WallNode& held : walls.nodes) {
        if (!held.velocity.allFinite()) {
            throw InputError({.what = "the velocity of a wall is not finite",
                              .where = "FluidOptions, at " + to_text(mesh.nodes[held.node]),
                              .value = to_text(held.velocity),
                              .allowed = "finite velocities"});
        }
    }
    if (!walls.has_open) {
        check_balance(edges, walls, mesh);
    }
    correct_curved_slips(beside, mesh, last, walls); // nothing flows into the domain by it
    return walls;
}

} // namespace dsc
