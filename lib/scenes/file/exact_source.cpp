// SPDX-License-Identifier: MIT
#include "scenes/file/exact_source.h"

#include "dsc/base/error.h"
#include "flows/exact.h"
#include "scenes/file/formula/formula_length.h"

#include <cmath>
#include <limits>

namespace dsc::scenes {

namespace {

using ExactFunction = std::function<ExactShape(double time)>;

/// Two times closer than this, relative to the period, are one but for rounding.
constexpr double same_time = 1e-9;

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

ExactSource read_back(const TableReader& reader) {
    return [where = reader.where("back")](const Parameters& parameters, const Setup&,
                                          const std::vector<FirstShape>& shapes) -> ExactFunction {
        const double period = parameters.period;
        require(period > 0, where + ": period", period,
                "above 0: the time when the flow is back, in [options]");
        return [period, shapes](double time) {
            if (!is_at(time, 0, period) && !is_at(time, period, period)) {
                return unknown_shape();
            }
            return together(shapes, [](const auto& curve) { return unmoved_shape(curve); });
        };
    };
}

ExactSource read_carried(const TableReader& reader) {
    return
        [where = reader.where("carried")](const Parameters& parameters, const Setup& setup,
                                          const std::vector<FirstShape>& shapes) -> ExactFunction {
            if (setup.flow.empty()) {
                throw InputError({.what = "there is no flow that carries shapes along",
                                  .where = where,
                                  .value = "true",
                                  .allowed = "with a [flow]"});
            }
            return [flow = setup.flow, period = parameters.period, shapes](double time) {
                const bool is_first = time == 0 || (period > 0 && is_at(time, period, period));
                return together(shapes, [&](const ParametricCurve& curve) {
                    return is_first ? unmoved_shape(curve) : advected_shape(curve, flow, time);
                });
            };
        };
}

ExactSource read_exact_circle(const TableReader& circle) {
    circle.allow({"centre", "radius"});
    const Point<double> centre = circle.point("centre");
    const FormulaLength radius(circle.text("radius"), {}, circle.where("radius"));
    return [=](const Parameters&, const Setup&, const std::vector<FirstShape>&) -> ExactFunction {
        return [=](double time) {
            const double now = radius(centre, time);
            return now > 0 && now <= largest_coordinate ? exact_circle(centre, now)
                                                        : unknown_shape();
        };
    };
}

} // namespace

ExactSource read_exact(const TableReader& reader) {
    const std::vector<std::string> kinds{"back", "carried", "circle"};
    reader.allow(kinds);
    const std::string kind = reader.one_of(kinds);
    if (kind == "circle") {
        return read_exact_circle(reader.table("circle"));
    }
    if (!reader.flag_or(true, kind)) {
        reader.refuse(kind, "bad value", "true, or no such key");
    }
    return kind == "back" ? read_back(reader) : read_carried(reader);
}

} // namespace dsc::scenes
