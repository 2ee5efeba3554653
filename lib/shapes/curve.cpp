// SPDX-License-Identifier: MIT
#include "shapes/curve.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dsc::scenes {

namespace {
using std::numbers::pi;
}

ParametricCurve circle_curve(const Point<double>& centre, double radius) {
    require(radius > 0.0 && std::isfinite(radius), "radius of the circle", radius,
            "finite and above 0");
    const auto point = [centre, radius](double s) {
        return Point<double>{centre.x() + radius * std::cos(2.0 * pi * s),
                             centre.y() + radius * std::sin(2.0 * pi * s)};
    };
    return {point, {}, pi * radius * radius};
}

ParametricCurve polygon_curve(std::span<const Point<double>> corners) {
    const Outline outline(corners.begin(), corners.end());
    check_outline(outline, "polygon_curve");
    const auto point = [outline](double s) {
        const double place = s * static_cast<double>(outline.size());
        const std::size_t i = std::min(static_cast<std::size_t>(place), outline.size() - 1);
        const Point<double>& a = outline[i];
        const Point<double>& b = outline[i + 1 == outline.size() ? 0 : i + 1];
        return Point<double>{a + (place - static_cast<double>(i)) * (b - a)};
    };
    ParametricCurve curve{point, {}, signed_area(outline)};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        curve.corners.push_back(static_cast<double>(i) / static_cast<double>(outline.size()));
    }
    return curve;
}

ParametricCurve slotted_disc_curve(const SlottedDisc& disc) {
    const std::vector<Point<double>> slot = slot_corners(disc);
    const double begin = std::atan2(slot[3].y() - disc.centre.y(), slot[3].x() - disc.centre.x());
    const double sweep = 2.0 * pi - 2.0 * std::asin(0.5 * disc.slot_width / disc.radius);
    // An eighth of the parameter range for each side of the slot, the rest for the arc.
    const auto point = [slot, disc, begin, sweep](double s) {
        const double place = 8.0 * s;
        if (place < 3.0) {
            const auto i = static_cast<std::size_t>(place);
            const double part = place - static_cast<double>(i);
            return Point<double>{slot[i] + part * (slot[i + 1] - slot[i])};
        }
        if (place == 3.0) {
            return slot[3];
        }
        const double angle = begin + sweep * ((place - 3.0) / 5.0);
        return Point<double>{disc.centre.x() + disc.radius * std::cos(angle),
                             disc.centre.y() + disc.radius * std::sin(angle)};
    };
    return {point, {0.0, 0.125, 0.25, 0.375}, slotted_disc_area(disc)};
}

} // namespace dsc::scenes
