// SPDX-License-Identifier: MIT
#include "shapes/outline.h"

#include "dsc/base/error.h"
#include "measures/compensated_sum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dsc::scenes {

double signed_area(const Outline& outline) { return signed_area(std::span(&outline, 1)); }

double signed_area(std::span<const Outline> outlines) {
    CompensatedSum doubled;
    for (const Outline& outline : outlines) {
        for (std::size_t i = 2; i < outline.size(); ++i) {
            const Point<double> a = outline[i - 1] - outline[0];
            const Point<double> b = outline[i] - outline[0];
            doubled.add_product(a.x(), b.y());
            doubled.add_product(-a.y(), b.x());
        }
    }
    return 0.5 * doubled.value();
}

double perimeter(const Outline& outline) { return perimeter(std::span(&outline, 1)); }

double perimeter(std::span<const Outline> outlines) {
    CompensatedSum length;
    for (const Outline& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point<double> edge = outline[i + 1 == outline.size() ? 0 : i + 1] - outline[i];
            length.add(std::hypot(edge.x(), edge.y()));
        }
    }
    return length.value();
}

Outline reversed(Outline outline) {
    std::reverse(outline.begin(), outline.end());
    return outline;
}

void check_outline(const Outline& outline, const std::string& where) {
    require(outline.size() >= 3, where + ": number of points", static_cast<double>(outline.size()),
            "at least 3");
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (!outline[i].allFinite()) {
            throw InputError({.what = "point " + std::to_string(i) + " of an outline is not finite",
                              .where = where,
                              .value = to_text(outline[i]),
                              .allowed = "finite coordinates"});
        }
    }
}

Eigen::AlignedBox2d box_around(std::span<const Outline> first, std::span<const Outline> second,
                               const std::string& where) {
    Eigen::AlignedBox2d box;
    for (const std::span<const Outline> outlines : {first, second}) {
        for (const Outline& outline : outlines) {
            check_outline(outline, where);
            for (const Point<double>& p : outline) {
                box.extend(p);
            }
        }
    }
    return box;
}

} // namespace dsc::scenes
