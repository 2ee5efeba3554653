// SPDX-License-Identifier: MIT
#include "measures/measures.h"

#include "measures/hausdorff.h"
#include "measures/jaggedness.h"
#include "measures/symmetric_difference.h"

#include <algorithm>
#include <limits>

namespace dsc::scenes {

namespace {

Value jaggedness_of(const Moment& moment) {
    const Jaggedness j = measure_jaggedness(moment.polygons, moment.exact->outlines);
    return Figures{{"largest_excess_deg", j.largest_excess_deg}};
}

std::vector<Measure> make_default_measures() {
    using enum Needs;
    using M = const Moment&;
    return {
        {"area", "domain units^2", "area of the shape", outlines,
         [](M m) { return signed_area(m.outlines); }},
        {"area_exact", "domain units^2", "area of the exact shape", exact_shape,
         [](M m) { return m.exact->area; }},
        {"sd", "domain units^2", "area between the shape and the exact one", exact_shape,
         [](M m) { return symmetric_difference(m.outlines, m.exact->outlines); }},
        {"sd_rel", "1", "the same relative to the first area of the exact shape", exact_shape,
         [](M m) { return number(*m.figures, "sd") / m.area_exact_first; }},
        {"hausdorff", "domain units", "largest distance of either curve from the other",
         exact_shape, [](M m) { return hausdorff(m.outlines, m.exact->outlines).distance(); }},
        {"jaggedness", "degrees", "turning angles against those of the exact curve", exact_shape,
         jaggedness_of},
        {"exact_error", "domain units^2", "estimated error of the exact shape itself, as an area",
         exact_shape, [](M m) { return m.exact->own_error; }},
        {"min_quality", "1", "worst triangle by equation 4", mesh,
         [](M m) { return m.quality.min_quality; }},
        {"min_angle_deg", "degrees", "smallest angle of any triangle", mesh,
         [](M m) { return m.quality.min_angle_deg; }},
        {"median_angle_deg", "degrees", "median of the triangles' smallest angles", mesh,
         [](M m) { return m.quality.median_angle_deg; }},
    };
}

} // namespace

const std::vector<Measure>& default_measures() {
    static const std::vector<Measure> measures = make_default_measures();
    return measures;
}

Figures measure(const std::vector<Measure>& measures, Moment moment) {
    Figures figures;
    figures.reserve(measures.size());
    moment.figures = &figures;
    if (std::ranges::find(measures, Needs::mesh, &Measure::needs) != measures.end()) {
        moment.quality =
            std::visit([](const auto* complex) { return measure_quality(*complex); }, moment.mesh);
    }
    for (const Measure& one : measures) {
        const bool can = one.needs != Needs::exact_shape || moment.exact != nullptr;
        figures.push_back(
            {one.name, can ? one.function(moment) : std::numeric_limits<double>::quiet_NaN()});
    }
    return figures;
}

} // namespace dsc::scenes
