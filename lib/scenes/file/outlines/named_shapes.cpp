// SPDX-License-Identifier: MIT
#include "scenes/file/outlines/named_shapes.h"

#include "dsc/base/error.h"
#include "shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

/// Edges of one outline: far more than a mesh could hold.
constexpr double most_edges_of_shape = 1e6;

// Refuses the shape now if it is invalid, and later if it has too many edges.
NamedShape checked(const TableReader& reader, double length,
                   std::function<Outline(double edge_length)> outline,
                   std::optional<ParametricCurve> curve = {}) {
    at_key(reader, "", [&] { (void)outline(std::max(length / 100, 1e-9)); });
    auto bounded = [outline = std::move(outline), length, where = reader.where()](double h) {
        require(length / h <= most_edges_of_shape, where + ": edge length", h,
                "at most 1000000 edges of the shape");
        return outline(h);
    };
    return {std::move(bounded), std::move(curve)};
}

NamedShape read_circle(const TableReader& reader) {
    reader.allow({"centre", "radius"});
    const Point<double> centre = reader.point("centre");
    const double radius = reader.number("radius", positive_length);
    return checked(
        reader, 2 * pi * radius, [=](double h) { return circle(centre, radius, h); },
        circle_curve(centre, radius));
}

NamedShape read_ellipse(const TableReader& reader) {
    reader.allow({"centre", "radii", "angle"});
    const Point<double> centre = reader.point("centre");
    const Point<double> radii = reader.point("radii");
    if (!(radii.minCoeff() >= positive_length.low)) {
        reader.refuse("radii", "bad value", "two lengths above 0");
    }
    const double angle = reader.number_or(0, "angle", {-360, 360}) * pi / 180;
    const Point<double> axis(std::cos(angle), std::sin(angle));
    const auto at = [=](double turn) {
        const double u = radii.x() * std::cos(turn);
        const double v = radii.y() * std::sin(turn);
        return Point<double>(centre.x() + u * axis.x() - v * axis.y(),
                             centre.y() + u * axis.y() + v * axis.x());
    };
    const double length = 2 * pi * radii.maxCoeff();
    const auto outline = [=](double h) {
        // In equal steps of the parameter no edge is longer than in a circle of the larger radius.
        const int count = std::max(8, static_cast<int>(std::ceil(length / h)));
        Outline points;
        for (int i = 0; i < count; ++i) {
            points.push_back(at(2 * pi * i / count));
        }
        return points;
    };
    return checked(
        reader, length, outline,
        ParametricCurve{[=](double s) { return at(2 * pi * s); }, {}, pi * radii.x() * radii.y()});
}

NamedShape read_rectangle(const TableReader& reader) {
    reader.allow({"low", "high"});
    const Point<double> low = reader.point("low");
    const Point<double> high = reader.point("high");
    if (!(high.x() > low.x() && high.y() > low.y())) {
        reader.refuse("high", "bad value", "above and to the right of low");
    }
    const std::vector<Point<double>> corners{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    return checked(
        reader, 2 * (high - low).sum(), [=](double h) { return rectangle(low, high, h); },
        polygon_curve(corners));
}

NamedShape read_polygon(const TableReader& reader) {
    reader.allow({"corners"});
    const std::vector<Point<double>> corners = reader.points("corners");
    if (corners.size() < 3) {
        reader.refuse("corners", "too few corners", "at least 3");
    }
    return checked(reader, perimeter(corners), [=](double h) { return polygon(corners, h); });
}

NamedShape read_slotted_disc(const TableReader& reader) {
    reader.allow({"centre", "radius", "slot_width", "slot_height"});
    SlottedDisc disc;
    disc.centre = reader.point_or(disc.centre, "centre");
    disc.radius = reader.number_or(disc.radius, "radius", positive_length);
    disc.slot_width = reader.number_or(disc.slot_width, "slot_width", positive_length);
    disc.slot_height = reader.number_or(disc.slot_height, "slot_height", positive_length);
    NamedShape shape =
        checked(reader, 12 * disc.radius, [=](double h) { return slotted_disc(disc, h); });
    shape.curve = slotted_disc_curve(disc);
    return shape;
}

NamedShape read_crescent(const TableReader& reader) {
    reader.allow({"centre", "radius", "bite_centre", "bite_radius"});
    Crescent one;
    one.centre = reader.point("centre");
    one.radius = reader.number("radius", positive_length);
    one.bite_centre = reader.point("bite_centre");
    one.bite_radius = reader.number("bite_radius", positive_length);
    return checked(reader, 2 * pi * (one.radius + one.bite_radius),
                   [=](double h) { return crescent(one, h); });
}

NamedShape read_dumbbell(const TableReader& reader) {
    reader.allow({"centre", "radius", "distance", "neck", "rounding"});
    Dumbbell one;
    one.centre = reader.point_or(one.centre, "centre");
    one.radius = reader.number_or(one.radius, "radius", positive_length);
    one.distance = reader.number_or(one.distance, "distance", positive_length);
    one.neck = reader.number_or(one.neck, "neck", positive_length);
    one.rounding = reader.number_or(one.rounding, "rounding", positive_length);
    const double length = 4 * pi * (one.radius + one.rounding) + 2 * one.distance;
    return checked(reader, length, [=](double h) { return dumbbell(one, h); });
}

NamedShape read_star(const TableReader& reader) {
    reader.allow({"centre", "outer_radius", "inner_radius", "tips"});
    const Point<double> centre = reader.point("centre");
    const double outer = reader.number("outer_radius", positive_length);
    const double inner = reader.number("inner_radius", positive_length);
    const int tips = reader.integer("tips", 2, 1000);
    return checked(reader, 2 * tips * (outer + inner),
                   [=](double h) { return star(centre, outer, inner, tips, h); });
}

struct NameOfShape {
    const char* name;
    NamedShape (*read)(const TableReader&);
};

constexpr std::array named_shapes{
    NameOfShape{"circle", read_circle},
    NameOfShape{"ellipse", read_ellipse},
    NameOfShape{"rectangle", read_rectangle},
    NameOfShape{"polygon", read_polygon},
    NameOfShape{"slotted_disc", read_slotted_disc},
    NameOfShape{"crescent", read_crescent},
    NameOfShape{"dumbbell", read_dumbbell},
    NameOfShape{"star", read_star},
};

} // namespace

std::vector<std::string> shape_names() {
    std::vector<std::string> names;
    for (const NameOfShape& shape : named_shapes) {
        names.emplace_back(shape.name);
    }
    return names;
}

NamedShape read_named_shape(const TableReader& reader, const std::string& name) {
    const auto found = std::ranges::find(named_shapes, name, &NameOfShape::name);
    return found->read(reader.table(name));
}

} // namespace dsc::scenes
