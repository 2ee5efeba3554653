// SPDX-License-Identifier: MIT
#include "combinations/scene.h"

#include "combinations/frame.h"
#include "shapes/voronoi.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dsc::combinations {

namespace {

using std::numbers::pi;
using P = Point<double>;

// --- the place: where a shape begins -------------------------------------------------------------

constexpr double pi_2 = pi / 2;

struct Shape {
    P centre{0.56, 0.53};
    double radius = 0.24;
    double from = 0; ///< the angles of its arc, counter-clockwise; a whole turn is closed
    double to = 2 * pi;
    P size{1, 1}; ///< of the domain
    double h = 0.04;
};

Shape shape_at(Place place) {
    switch (place) {
    case Place::slender:
        return {.centre = {20.07, 0.2}, .radius = 0.12, .size = {40, 0.4}, .h = 0.025};
    case Place::on_wall: return {.centre = {0.47, 0}, .to = pi};
    case Place::in_corner: return {.centre = {0, 0}, .radius = 0.4, .to = pi_2};
    case Place::pair: return {.centre = {0.5, 0.5}, .radius = 0.12};
    case Place::by_wall: return {.centre = {0.47, 0.32}};
    case Place::square:
    case Place::layer:
    case Place::through_corner: break;
    }
    return {};
}

constexpr double height = 0.4; ///< of the layer
constexpr double aside = 0.17; ///< of each of a pair

constexpr double spacing = 0.27; ///< of the vertices of arcs, at most, in edge lengths

// An arc of the shape, from one angle to another. Corners lie on it 60 degrees apart, or 45.
std::vector<P> arc(const Shape& shape, double radius, double from, double to, Outline outline) {
    const double most = to - from < 1.1 * pi_2 ? pi / 4 : pi / 3;
    const int n = outline == Outline::round
                      ? static_cast<int>(std::ceil(radius * (to - from) / (spacing * shape.h)))
                      : static_cast<int>(std::ceil((to - from) / most - 1e-9));
    std::vector<P> points;
    for (int i = 0; i <= n; ++i) {
        const double angle = from + (to - from) * i / n;
        // Exactly on the walls.
        const auto exactly = [](double x) { return std::abs(x) < 1e-9 ? 0.0 : x; };
        points.emplace_back(shape.centre +
                            radius * P(exactly(std::cos(angle)), exactly(std::sin(angle))));
    }
    if (to - from == 2 * pi) {
        points.back() = points.front();
    }
    return points;
}

std::vector<Curve> pair_of(const Row& row, const Shape& shape) {
    std::vector<Curve> curves;
    for (const Phase phase : {1U, 2U}) {
        Shape one = shape;
        one.centre.x() += phase == 1 ? -aside : aside;
        curves.push_back({arc(one, one.radius, one.from, one.to, row.outline),
                          row.phases == Phases::junctions ? phase : Phase{1}, exterior_phase});
    }
    return curves;
}

std::vector<Curve> arcs_of(const Row& row, const Shape& shape) {
    const auto piece = [&](double radius, double from, double to) {
        return arc(shape, radius, from, to, row.outline);
    };
    if (row.phases != Phases::junctions) {
        std::vector<Curve> curves{{piece(shape.radius, shape.from, shape.to), 1, exterior_phase}};
        if (row.phases == Phases::nested) {
            curves.push_back({piece(shape.radius / 2, shape.from, shape.to), 2, 1});
        }
        return curves;
    }
    // Cut by a chord through the middle: phase 2 on its right.
    const bool is_closed = shape.to - shape.from == 2 * pi;
    const double cut = is_closed ? pi_2 : (shape.from + shape.to) / 2;
    std::vector<P> before = piece(shape.radius, is_closed ? -pi_2 : shape.from, cut);
    std::vector<P> after = piece(shape.radius, cut, is_closed ? 3 * pi_2 : shape.to);
    after.front() = before.back();
    if (is_closed) {
        after.back() = before.front();
    }
    const P foot = is_closed ? before.front() : shape.centre;
    std::vector<P> chord{foot, before.back()};
    return {{std::move(before), 2, exterior_phase},
            {std::move(after), 1, exterior_phase},
            {std::move(chord), 1, 2}};
}

std::vector<Curve> lines_of(const Row& row) {
    if (row.place == Place::through_corner) {
        std::vector<Curve> curves;
        if (row.phases == Phases::junctions) {
            curves.push_back({{{0, 0}, {0.5, 0.5}}, exterior_phase, 1});
            curves.push_back({{{0.5, 0.5}, {1, 1}}, exterior_phase, 2});
            curves.push_back({{{0.5, 0.5}, {1, 0}}, 2, 1});
        } else {
            curves.push_back({{{0, 0}, {1, 1}}, exterior_phase, 1});
        }
        return curves;
    }
    if (row.phases == Phases::junctions) {
        return {{{{0, height}, {0.5, height}}, exterior_phase, 1},
                {{{0.5, height}, {1, height}}, exterior_phase, 2},
                {{{0.5, 0}, {0.5, height}}, 1, 2}};
    }
    std::vector<Curve> curves{{{{0, height}, {1, height}}, exterior_phase, 1}};
    if (row.phases == Phases::nested) {
        curves.push_back({{{0, height / 2}, {1, height / 2}}, 1, 2});
    }
    return curves;
}

// Cells that are not much narrower than two edges, in the middle of a slender domain smaller.
std::vector<Curve> cells_of(const Shape& shape) {
    const Rectangle domain{{0, 0}, shape.size};
    constexpr std::size_t count = 100;
    const auto sites = scenes::relaxed_sites(domain, scenes::random_sites(domain, count, 7), 20);
    return scenes::voronoi_curves(domain, sites, {.shortest = shape.h / 2});
}

std::vector<Curve> curves_of(const Row& row, const Shape& shape) {
    if (row.phases == Phases::many) {
        return cells_of(shape);
    }
    if (row.place == Place::pair) {
        return pair_of(row, shape);
    }
    const bool is_line = row.place == Place::layer || row.place == Place::through_corner;
    return is_line ? lines_of(row) : arcs_of(row, shape);
}

// --- the motion ----------------------------------------------------------------------------------

// What lies on a wall stays on it, and nothing leaves the domain.
P kept_inside(const P& start, const P& end, const P& size) {
    P kept = end.cwiseMax(P(0, 0)).cwiseMin(size);
    for (int k = 0; k < 2; ++k) {
        if (start[k] == 0 || start[k] == size[k]) {
            kept[k] = start[k];
        }
    }
    return kept;
}

void translate(Scene& scene, const P& way, const P& size) {
    scene.velocity = [way](const P&, double) { return way; };
    scene.exact = [way, size](const P& p) { return kept_inside(p, p + way, size); };
    scene.fastest = way.norm();
}

// By three quarters of a turn about the middle of the square.
void turn(Scene& scene) {
    constexpr double angle = 1.5 * pi;
    const P centre(0.5, 0.5);
    scene.steps = 60;
    scene.velocity = [](const P& p, double) {
        return P(-angle * (p.y() - 0.5), angle * (p.x() - 0.5));
    };
    scene.exact = [centre](const P& p) { // a quarter of a turn clockwise
        const P off = p - centre;
        return P(centre + P(off.y(), -off.x()));
    };
    scene.fastest = angle * 0.45;
}

// By the stream function s sin^2(pi X) sin(pi Y) in a part of the domain: along the walls of Y
// there is slip; and of the square's X as well.
void swirl(Scene& scene, const Shape& shape, Place place) {
    const bool is_slender = place == Place::slender;
    const double from = is_slender ? shape.centre.x() - 0.5 : 0;
    const double b = shape.size.y();
    const double strength = is_slender ? 0.02 : 0.1;
    scene.velocity = [=](const P& p, double t) {
        const double x = std::clamp(p.x() - from, 0.0, 1.0) * pi;
        const double y = p.y() / b * pi;
        const double at = strength * pi * std::cos(pi * t);
        const double across = is_slender ? std::pow(std::sin(x), 2) : std::sin(x);
        const double slope = is_slender ? std::sin(2 * x) : std::cos(x);
        return P(at * across * std::cos(y) / b, -at * slope * std::sin(y));
    };
    scene.exact = [](const P& p) { return p; };
    scene.fastest = strength * pi / b;
    // In half of the time curves become longer by the integral of the gradient, which is no more
    // than k times the speed, and bend by that of the second derivatives, k squared times it; and a
    // curve that is drawn out by a factor across its bend is bent by the square of it.
    const double k = pi / std::min(b, 1.0);
    const double way = scene.fastest / pi;
    scene.stretch = std::exp(k * way);
    scene.curvature = (scene.curvature * scene.stretch + k * k * way) * scene.stretch;
}

// A circle of this radius meets a line at this distance from its centre.
void meet(Scene& scene, double radius, double distance) {
    scene.meets = true;
    scene.seam = 2 * std::sqrt(radius * radius - distance * distance);
    scene.seam_angle = std::acos(distance / radius);
}

// With half the speed where the inner shape grows: then all is scaled alike.
void grow(Scene& scene, const Row& row, const Shape& shape, double by) {
    scene.end = std::abs(by);
    if (row.place == Place::layer) {
        const double factor = (height + by) / height;
        scene.exact = [=](const P& p) {
            return p.y() < 1.01 * height ? P(p.x(), factor * p.y()) : p;
        };
        return;
    }
    const double radius = shape.radius + by;
    const double factor = radius / shape.radius;
    scene.stretch = std::max(factor, 1.0);
    scene.curvature *= std::max(1 / factor, 1.0);
    const auto scaled = [factor](const P& p, const P& centre) {
        return P(centre + factor * (p - centre));
    };
    if (row.place == Place::pair) {
        // Both end up at the line in the middle between them, which is gone if they are one.
        scene.exact = [=](const P& p) {
            const bool is_left = p.x() < shape.centre.x();
            P end = scaled(p, shape.centre + P(is_left ? -aside : aside, 0));
            if (is_left != (end.x() < shape.centre.x())) {
                end.x() = shape.centre.x();
            }
            return end;
        };
    } else {
        scene.exact = [=](const P& p) {
            return kept_inside(p, scaled(p, shape.centre), shape.size);
        };
    }
    if (by > 0 && row.place == Place::pair) {
        meet(scene, radius, aside);
    } else if (by > 0 && row.place == Place::by_wall) {
        meet(scene, radius, shape.centre.y());
        scene.meets_wall = true;
    }
}

void bend(Scene& scene, const Row& row, const Shape& shape) {
    scene.end = row.place == Place::slender ? 0.001 : 0.003;
    double smallest = row.phases == Phases::nested ? shape.radius / 2 : shape.radius;
    if (row.motion == Motion::vanish) {
        scene.end = 1.1 * smallest * smallest / 2;
        scene.meets = true;
        smallest = shape.radius; // the other one's: nothing of the inner one is left
    }
    if (scene.curvature > 0) {
        scene.curvature = 1 / std::sqrt(smallest * smallest - 2 * scene.end);
    }
    if (row.phases == Phases::many) {
        scene.end = 2e-4;
        scene.is_only_conserved = true;
    } else if (row.place == Place::layer) {
        scene.exact = [](const P& p) { return p; };
        if (row.phases ==
            Phases::junctions) { // a sixth of a half turn, at right angles to the walls
            scene.area_changes = {pi / 3, -pi / 6, -pi / 6};
        }
    } else if (row.phases == Phases::junctions && row.place != Place::pair) {
        const double each = pi / 3 * (2 - 6) * (shape.to - shape.from) / (2 * pi);
        scene.area_changes = {-2 * each, each, each};
    }
    for (double& change : scene.area_changes) {
        change *= scene.end;
    }
    if (row.place != Place::layer) {
        const double end = scene.end;
        const double to_the_side = row.place == Place::pair ? aside : 0;
        scene.exact = [=, middle = shape.centre](const P& p) {
            const P centre = middle + P(p.x() < middle.x() ? -to_the_side : to_the_side, 0);
            const double r = (p - centre).norm();
            const double rest = r * r - 2 * end;
            return rest > 0 ? P(centre + std::sqrt(rest) / r * (p - centre)) : centre;
        };
    }
}

// Of the curves at the start: of the inner of two nested ones, if there is one.
double first_curvature(const Row& row, const Shape& shape) {
    const bool is_straight = row.outline != Outline::round || row.phases == Phases::many ||
                             row.place == Place::layer || row.place == Place::through_corner;
    return is_straight ? 0 : (row.phases == Phases::nested ? 2 : 1) / shape.radius;
}

void set_motion(Scene& scene, const Row& row, const Shape& shape) {
    scene.curvature = first_curvature(row, shape);
    scene.longest_at_start = scene.curvature > 0 ? spacing : 1;
    // Those of the inner of two nested shapes; of 45 degrees where arcs are shorter.
    const double radius = row.phases == Phases::nested ? shape.radius / 2 : shape.radius;
    scene.corner_distance = 2 * radius * std::sin(pi / 8);
    const bool is_small = row.place == Place::slender || row.place == Place::pair;
    scene.runs_into_wall =
        row.place == Place::layer && (row.motion == Motion::right || row.motion == Motion::left);
    // Not as far as to a wall: nothing meets there by the widest contact distance.
    const double far = row.place == Place::slender ? 0.3 : 0.12;
    const double near = row.place == Place::slender ? 0.03 : 0.15;
    switch (row.motion) {
    case Motion::rest: translate(scene, {0, 0}, shape.size); break;
    case Motion::right: translate(scene, {far, 0}, shape.size); break;
    case Motion::left: translate(scene, {-far, 0}, shape.size); break;
    case Motion::up: translate(scene, {0, near}, shape.size); break;
    case Motion::down:
        translate(scene, {0, -near}, shape.size);
        if (row.place == Place::by_wall) {
            meet(scene, shape.radius, shape.centre.y() - near);
            scene.meets_wall = true;
            scene.runs_into_wall = row.inside == Inside::carried;
        } else if (row.place == Place::layer && row.phases == Phases::junctions) {
            // The curve below the layer shortens from its end on the wall: its last vertex is
            // collapsed before it runs into the wall, unless a step is longer than short edges.
            scene.runs_into_wall = near / scene.steps > InterfaceThresholds{}.shortest * shape.h;
        }
        break;
    case Motion::turn: turn(scene); break;
    case Motion::swirl: swirl(scene, shape, row.place); break;
    case Motion::grow: grow(scene, row, shape, row.place == Place::slender ? 0.04 : 0.12); break;
    case Motion::shrink: grow(scene, row, shape, is_small ? -0.04 : -0.08); break;
    case Motion::curvature:
    case Motion::vanish: bend(scene, row, shape); break;
    }
}

} // namespace

Scene scene_of(const Row& row, double fineness) {
    Shape shape = shape_at(row.place);
    shape.h /= fineness;
    Scene scene;
    scene.h = shape.h;
    set_motion(scene, row, shape);
    const Frame frame(row.turned, shape.size);
    scene.domain = {{0, 0}, frame.size()};
    for (Curve& curve : curves_of(row, shape)) {
        scene.phases = std::max({scene.phases, curve.left + 1, curve.right + 1});
        scene.curves.push_back(frame.curve(std::move(curve)));
    }
    if (scene.exact) {
        scene.exact = [frame, exact = std::move(scene.exact)](const P& p) {
            return frame.place(exact(frame.place_before(p)));
        };
    }
    if (scene.velocity) {
        scene.velocity = [frame, velocity = std::move(scene.velocity)](const P& p, double t) {
            return frame.way(velocity(frame.place_before(p), t));
        };
    }
    return scene;
}

} // namespace dsc::combinations
