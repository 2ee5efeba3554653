// SPDX-License-Identifier: MIT
#include "combinations/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dsc::combinations {

namespace {

using std::numbers::pi;
using P = Point<double>;

// --- the place: where a shape begins -------------------------------------------------------------

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
    case Place::on_boundary: return {.centre = {0.47, 0}, .to = pi};
    case Place::in_corner: return {.centre = {0, 0}, .radius = 0.4, .to = pi / 2};
    case Place::pair: return {.centre = {0.5, 0.5}, .radius = 0.12};
    case Place::by_boundary: return {.centre = {0.47, 0.32}};
    case Place::square:
    case Place::layer: break;
    }
    return {};
}

constexpr double height = 0.4;   ///< of the layer
constexpr double aside = 0.17;   ///< of each of a pair
constexpr double spacing = 0.27; ///< of vertices on arcs, at most, in edge lengths

// An arc of the shape, from one angle to another; with Outline::corners, its corners are at most 60
// degrees apart, or 45 on short arcs.
std::vector<P> arc(const Shape& shape, double radius, double from, double to, Outline outline) {
    const double largest = to - from < 0.55 * pi ? pi / 4 : pi / 3;
    const int n = outline == Outline::round
                      ? static_cast<int>(std::ceil(radius * (to - from) / (spacing * shape.h)))
                      : static_cast<int>(std::ceil((to - from) / largest - 1e-9));
    std::vector<P> points;
    for (int i = 0; i <= n; ++i) {
        const double angle = from + (to - from) * i / n;
        // Points that are on a side up to rounding are moved exactly onto it.
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
    // Cuts the shape by a chord through its centre, with phase 2 on the right of the chord.
    const bool is_closed = shape.to - shape.from == 2 * pi;
    const double cut = is_closed ? pi / 2 : (shape.from + shape.to) / 2;
    std::vector<P> before = piece(shape.radius, is_closed ? -pi / 2 : shape.from, cut);
    std::vector<P> after = piece(shape.radius, cut, is_closed ? 1.5 * pi : shape.to);
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

std::vector<Curve> layer_of(const Row& row) {
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

std::vector<Curve> curves_of(const Row& row, const Shape& shape) {
    return row.place == Place::pair    ? pair_of(row, shape)
           : row.place == Place::layer ? layer_of(row)
                                       : arcs_of(row, shape);
}

// --- the motion ----------------------------------------------------------------------------------

// Points on the domain boundary stay on it, and no point leaves the domain.
P kept_inside(const P& start, const P& end, const P& size) {
    P kept = end.cwiseMax(P(0, 0)).cwiseMin(size);
    for (int k = 0; k < 2; ++k) {
        if (start[k] == 0 || start[k] == size[k]) {
            kept[k] = start[k];
        }
    }
    return kept;
}

// The contact of a circle of this radius with a line at this distance from its centre.
void meet(Scene& scene, double radius, double distance) {
    scene.meets = true;
    scene.seam = 2 * std::sqrt(radius * radius - distance * distance);
    scene.seam_angle = std::acos(distance / radius);
}

void translate(Scene& scene, const Row& row, const Shape& shape) {
    // Shapes move so little that even with the widest contact distance no film opens at the domain
    // boundary, except by `Place::by_boundary`, whose disc meets it on its way down.
    const bool is_slender = row.place == Place::slender;
    const P way = row.motion == Motion::right  ? P(is_slender ? 0.3 : 0.12, 0)
                  : row.motion == Motion::down ? P(0, is_slender ? -0.03 : -0.15)
                                               : P(0, 0);
    scene.velocity = [way](const P&, double) { return way; };
    scene.exact = [way, size = shape.size](const P& p) { return kept_inside(p, p + way, size); };
    if (row.motion == Motion::right) {
        scene.runs_into_boundary = row.place == Place::layer;
    } else if (row.motion == Motion::down && row.place == Place::by_boundary) {
        meet(scene, shape.radius, shape.centre.y() + way.y());
        scene.meets_boundary = true;
        scene.runs_into_boundary = row.inside == Inside::advected;
    } else if (row.motion == Motion::down && row.place == Place::layer &&
               row.phases == Phases::junctions) {
        // The curve below the layer shortens from its end on the domain boundary: its last vertex
        // is collapsed before it runs into the domain boundary, unless a step is longer than short
        // edges.
        scene.runs_into_boundary =
            -way.y() / scene.steps > InterfaceThresholds{}.shortest * shape.h;
    }
}

void turn(Scene& scene) {
    constexpr double angle = 1.5 * pi;
    scene.steps = 60;
    scene.velocity = [](const P& p, double) {
        return P(-angle * (p.y() - 0.5), angle * (p.x() - 0.5));
    };
    scene.exact = [](const P& p) { return P(p.y(), 1 - p.x()); }; // a quarter of a turn clockwise
}

// The stream function is s sin(pi x) sin(pi y), so there is slip along the sides of the domain.
void swirl(Scene& scene, const Row& row) {
    constexpr double strength = 0.1;
    scene.velocity = [](const P& p, double t) {
        const double at = strength * pi * std::cos(pi * t);
        return P(at * std::sin(pi * p.x()) * std::cos(pi * p.y()),
                 -at * std::cos(pi * p.x()) * std::sin(pi * p.y()));
    };
    scene.exact = [](const P& p) { return p; };
    // Bounds at half the time: the stretch is exp of the integral of the velocity gradient, at most
    // pi times the speed. The curvature grows by the integral of the second derivatives, at most pi
    // squared times the speed, and by the square of the stretch across the bend.
    scene.stretch = std::exp(pi * strength);
    scene.curvature = (scene.curvature * scene.stretch + pi * pi * strength) * scene.stretch;
    if (row.phases == Phases::junctions && row.place != Place::pair) {
        scene.longest_at_start = 1; // the straight chord, which the flow bends as well
    }
}

// Nested shapes: with half the speed for the inner shape, both are scaled by the same factor.
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
        // Both discs end at the line half-way between them; if they merge, that line vanishes.
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
    } else if (by > 0 && row.place == Place::by_boundary) {
        meet(scene, radius, shape.centre.y());
        scene.meets_boundary = true;
    }
}

void bend(Scene& scene, const Row& row, const Shape& shape) {
    scene.end = row.place == Place::slender ? 0.001 : 0.003;
    double smallest = row.phases == Phases::nested ? shape.radius / 2 : shape.radius;
    if (row.motion == Motion::vanish) {
        scene.end = 1.1 * smallest * smallest / 2;
        scene.meets = true;
        smallest = shape.radius; // the outer radius, because the inner shape has vanished
    }
    if (scene.curvature > 0) {
        scene.curvature = 1 / std::sqrt(smallest * smallest - 2 * scene.end);
    }
    if (row.phases == Phases::junctions && row.place == Place::layer) {
        // Each curve turns by pi / 6: its ends are at right angles to the sides of the domain.
        const double each = pi / 6 * scene.end;
        scene.area_changes = {2 * each, -each, -each};
    } else if (row.phases == Phases::junctions && row.place != Place::pair) {
        const double each = pi / 3 * (2 - 6) * (shape.to - shape.from) / (2 * pi) * scene.end;
        scene.area_changes = {-2 * each, each, each};
    }
    if (row.place == Place::layer) {
        scene.exact = [](const P& p) { return p; };
        return;
    }
    const double to_the_side = row.place == Place::pair ? aside : 0;
    scene.exact = [=, end = scene.end, middle = shape.centre](const P& p) {
        const P centre = middle + P(p.x() < middle.x() ? -to_the_side : to_the_side, 0);
        const double r = (p - centre).norm();
        const double rest = r * r - 2 * end;
        return rest > 0 ? P(centre + std::sqrt(rest) / r * (p - centre)) : centre;
    };
}

void set_motion(Scene& scene, const Row& row, const Shape& shape) {
    // Of two nested shapes, the inner one has the larger curvature.
    const double radius = row.phases == Phases::nested ? shape.radius / 2 : shape.radius;
    const bool is_straight = row.outline == Outline::corners || row.place == Place::layer;
    scene.curvature = is_straight ? 0 : 1 / radius;
    scene.longest_at_start = is_straight ? 1 : spacing;
    const bool is_slender = row.place == Place::slender;
    const bool is_small = is_slender || row.place == Place::pair;
    switch (row.motion) {
    case Motion::rest:
    case Motion::right:
    case Motion::down: translate(scene, row, shape); break;
    case Motion::turn: turn(scene); break;
    case Motion::swirl: swirl(scene, row); break;
    case Motion::grow: grow(scene, row, shape, is_slender ? 0.04 : 0.12); break;
    case Motion::shrink: grow(scene, row, shape, is_small ? -0.04 : -0.08); break;
    case Motion::curvature:
    case Motion::vanish: bend(scene, row, shape); break;
    }
}

// --- the turn ------------------------------------------------------------------------------------

// The rotation or reflection of the scene; exact except for one subtraction per coordinate.
class Frame {
public:
    Frame(Turned turned, const P& size) : is_mirrored_(turned == Turned::mirrored) {
        const double x = turned == Turned::half || turned == Turned::mirrored ? -1 : 1;
        const double y = turned == Turned::half ? -1 : 1;
        turn_ << x, 0, 0, y;
        if (turned == Turned::quarter) {
            turn_ << 0, -1, 1, 0;
        } else if (turned == Turned::three_quarters) {
            turn_ << 0, 1, -1, 0;
        }
        shift_ = (-way(size)).cwiseMax(P(0, 0));
    }
    [[nodiscard]] P way(const P& v) const { return turn_ * v; }
    [[nodiscard]] P place(const P& p) const { return turn_ * p + shift_; }
    [[nodiscard]] P place_before(const P& p) const { return turn_.transpose() * (p - shift_); }
    [[nodiscard]] Curve curve(Curve one) const {
        std::ranges::transform(one.points, one.points.begin(),
                               [&](const P& p) { return place(p); });
        if (is_mirrored_) {
            std::swap(one.left, one.right);
        }
        return one;
    }

private:
    bool is_mirrored_;
    Eigen::Matrix2d turn_;
    P shift_;
};

} // namespace

Scene scene_of(const Row& row, double fineness) {
    Shape shape = shape_at(row.place);
    shape.h /= fineness;
    Scene scene;
    scene.h = shape.h;
    set_motion(scene, row, shape);
    const Frame frame(row.turned, shape.size);
    scene.domain = {{0, 0}, frame.way(shape.size).cwiseAbs()};
    for (Curve& curve : curves_of(row, shape)) {
        scene.phases = std::max({scene.phases, curve.left + 1, curve.right + 1});
        scene.curves.push_back(frame.curve(std::move(curve)));
    }
    scene.exact = [frame, exact = std::move(scene.exact)](const P& p) {
        return frame.place(exact(frame.place_before(p)));
    };
    if (scene.velocity) {
        scene.velocity = [frame, velocity = std::move(scene.velocity)](const P& p, double t) {
            return frame.way(velocity(frame.place_before(p), t));
        };
    }
    return scene;
}

Scene in_units(Scene scene, double length, double time) {
    scene.length_unit *= length;
    scene.time_unit *= time;
    scene.h *= length;
    scene.end *= time;
    scene.domain = {length * scene.domain.low, length * scene.domain.high};
    for (Curve& curve : scene.curves) {
        for (P& p : curve.points) {
            p *= length;
        }
    }
    if (scene.velocity) {
        scene.velocity = [=, velocity = std::move(scene.velocity)](const P& p, double t) {
            return P(length / time * velocity(p / length, t / time));
        };
    }
    return scene;
}

} // namespace dsc::combinations
