// SPDX-License-Identifier: MIT
#include "scenes/file/exact_source.h"

#include "dsc/base/error.h"
#include "flows/exact.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace dsc::scenes {

namespace {

using ExactFunction = std::function<ExactShape(double time)>;

/// Two times closer than this, relative to the period, are one but for rounding.
constexpr double same_time = 1e-9;
/// The same of points and of velocities, relative to the largest.
constexpr double same_point = 1e-9;

ExactShape unknown_shape() {
    ExactShape shape;
    shape.area = std::numeric_limits<double>::quiet_NaN();
    return shape;
}

// Holes run clockwise, and their area is taken away.
template <class OneShape>
ExactShape together(const std::vector<FirstShape>& shapes, OneShape one_shape) {
    ExactShape all;
    for (const FirstShape& first : shapes) {
        ExactShape one = one_shape(first.curve);
        all.area += first.is_hole ? -one.area : one.area;
        all.own_error += one.own_error;
        all.description = one.description;
        for (Outline& outline : one.outlines) {
            all.outlines.push_back(first.is_hole ? reversed(std::move(outline))
                                                 : std::move(outline));
        }
    }
    return all;
}

bool is_at(double time, double moment, double period) {
    return std::abs(time - moment) <= same_time * period;
}

ExactFunction back_at(double period, const std::vector<FirstShape>& shapes) {
    return [period, shapes](double time) {
        if (!is_at(time, 0, period) && !is_at(time, period, period)) {
            return unknown_shape();
        }
        return together(shapes, [](const ParametricCurve& curve) { return unmoved_shape(curve); });
    };
}

ExactFunction carried_by(const Flow& flow, double period, const std::vector<FirstShape>& shapes) {
    return [flow, period, shapes](double time) {
        return together(shapes, [&](const ParametricCurve& curve) {
            const bool is_first = time == 0 || (period > 0 && is_at(time, period, period));
            return is_first ? unmoved_shape(curve) : advected_shape(curve, flow, time);
        });
    };
}

ExactSource read_back(const TableReader& reader) {
    return [where = reader.where("back")](const Parameters& parameters, const Setup&,
                                          const std::vector<FirstShape>& shapes) {
        if (!(parameters.period > 0)) {
            throw InputError({.what = "the time when the flow is back is not given",
                              .where = where,
                              .value = "no period",
                              .allowed = "a `period` in [options]"});
        }
        return back_at(parameters.period, shapes);
    };
}

ExactSource read_carried(const TableReader& reader) {
    return [where = reader.where("carried")](const Parameters& parameters, const Setup& setup,
                                             const std::vector<FirstShape>& shapes) {
        if (setup.flow.empty()) {
            throw InputError({.what = "there is no flow that carries shapes along",
                              .where = where,
                              .value = "true",
                              .allowed = "with a [flow]"});
        }
        return carried_by(setup.flow, parameters.period, shapes);
    };
}

ExactSource read_exact_circle(const TableReader& circle) {
    circle.allow({"centre", "radius"});
    const Point<double> centre = circle.point("centre");
    const FormulaFlow radius(
        {.u = circle.text("radius"), .v = "0", .where_u = circle.where("radius")});
    return [=](const Parameters&, const Setup&, const std::vector<FirstShape>&) -> ExactFunction {
        return [=](double time) {
            const Point<double> here = centre;
            Point<double> result;
            radius({&here, 1}, time, {&result, 1});
            return result.x() > 0 && result.x() <= largest_coordinate
                       ? exact_circle(centre, result.x())
                       : unknown_shape();
        };
    };
}

std::vector<Point<double>> first_points(const Setup& setup) {
    std::vector<Point<double>> points;
    for (const Outline& outline : setup.outlines) {
        points.insert(points.end(), outline.begin(), outline.end());
    }
    for (const dsc::Curve& curve : setup.curves) {
        points.insert(points.end(), curve.points.begin(), curve.points.end());
    }
    return points;
}

bool are_near(const std::vector<Point<double>>& a, const std::vector<Point<double>>& b) {
    double scale = 0;
    for (const Point<double>& p : a) {
        scale = std::max(scale, p.norm());
    }
    return std::ranges::equal(
        a, b, [&](const auto& p, const auto& q) { return (p - q).norm() <= same_point * scale; });
}

bool has_same_shape(const Setup& a, const Setup& b) {
    const auto phases = [](const Setup& setup) {
        std::vector<Phase> all = setup.phases;
        all.resize(setup.outlines.size(), 1);
        for (const dsc::Curve& curve : setup.curves) {
            all.insert(all.end(), {curve.left, curve.right});
        }
        return all;
    };
    return phases(a) == phases(b) && are_near(first_points(a), first_points(b));
}

// Velocities are compared where the shape is at the start, at times of the whole run.
bool has_same_motion(const Setup& a, const Setup& b) {
    if (a.growth || b.growth) {
        return a.growth && b.growth && a.growth->speed == b.growth->speed &&
               a.growth->turns_at == b.growth->turns_at;
    }
    if (a.curvature || b.curvature) {
        const auto of_pair = [](const PairCurvature& pair) {
            return std::tuple(pair.one, pair.other, pair.tension, pair.mobility);
        };
        return a.curvature && b.curvature && a.curvature->keeps == b.curvature->keeps &&
               std::ranges::equal(a.curvature->pairs, b.curvature->pairs, {}, of_pair, of_pair);
    }
    const std::vector<Point<double>> points = first_points(a);
    constexpr int moments = 8;
    const double step = a.steps * a.dt / moments;
    for (int i = 0; i < moments; ++i) {
        const auto velocities = [&](const Setup& setup) {
            std::vector<Point<double>> found(points.size());
            velocity_of_step(setup.flow, i * step, (i + 1) * step)(points, i * step, found);
            return found;
        };
        if (!are_near(velocities(a), velocities(b))) {
            return false;
        }
    }
    return true;
}

ExactSource read_exact_of_scene(const TableReader& reader, const std::vector<Scene>& scenes,
                                const std::string& begins_as) {
    const std::string name = reader.text("scene");
    const auto found = std::ranges::find(scenes, name, &Scene::name);
    if (found == scenes.end() || !found->prepare(found->defaults).exact) {
        reader.refuse("scene", "no scene with an exact shape",
                      "a name that `dsc_scene list` shows");
    }
    const bool is_base = name == begins_as;
    const std::vector<std::string> set =
        reader.has("set") ? reader.texts("set") : std::vector<std::string>{};
    const auto settings = [scene = *found, set, is_base](const Parameters& of_file) {
        Parameters found_settings = is_base ? of_file : scene.defaults;
        found_settings.h = of_file.h;
        for (const std::string& setting : set) {
            apply_setting(found_settings, scene.keys, setting);
        }
        return found_settings;
    };
    at_key(reader, "set",
           [&] { check_grains(*found, settings(found->defaults), reader.where("set")); });
    return [=, prepare = found->prepare, where = reader.where("scene")](
               const Parameters& parameters, const Setup& setup, const std::vector<FirstShape>&) {
        const Setup other = prepare(settings(parameters));
        const std::string differs = !has_same_shape(setup, other)    ? "shape"
                                    : !has_same_motion(setup, other) ? "motion"
                                                                     : "";
        if (!differs.empty()) {
            throw InputError({.what = "the exact shape of another " + differs,
                              .where = where,
                              .value = "'" + name + "'",
                              .allowed = "the shape and the motion of that scene with the settings "
                                         "`set`; or back, carried or circle in place of it; or no "
                                         "[exact]"});
        }
        return other.exact;
    };
}

} // namespace

ExactSource read_exact(const TableReader& reader, const std::vector<Scene>& scenes,
                       const std::string& begins_as) {
    const std::vector<std::string> kinds{"back", "carried", "circle", "scene"};
    reader.allow({"back", "carried", "circle", "scene", "set"});
    const std::string kind = reader.one_of(kinds);
    if (kind == "circle") {
        return read_exact_circle(reader.table("circle"));
    }
    if (kind == "scene") {
        return read_exact_of_scene(reader, scenes, begins_as);
    }
    if (!reader.flag_or(true, kind)) {
        reader.refuse(kind, "bad value", "true, or no such key");
    }
    return kind == "back" ? read_back(reader) : read_carried(reader);
}

} // namespace dsc::scenes
