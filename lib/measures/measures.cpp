// SPDX-License-Identifier: MIT
#include "measures/measures.h"

#include "dsc/base/error.h"
#include "measures/hausdorff.h"
#include "measures/jaggedness.h"
#include "measures/mesh_quality.h"
#include "measures/symmetric_difference.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

namespace dsc::scenes {

namespace {

double said(const Moment& moment, const char* name) { return number(*moment.figures, name); }

Value jaggedness_of(const Moment& moment) {
    const Jaggedness j = measure_jaggedness(moment.polygons, moment.exact->outlines);
    return Figures{{"beyond", j.beyond},
                   {"largest_excess_deg", j.largest_excess_deg},
                   {"worst", j.worst},
                   {"rms_deg", j.rms_deg}};
}

MeshQuality quality_of(const Moment& moment) {
    return std::visit([](const auto* complex) { return measure_quality(*complex); }, moment.mesh);
}

std::vector<Measure> make_default_measures() {
    using enum Needs;
    using M = const Moment&;
    return {
        {"area", "domain units^2", "area of the shape", outlines,
         [](M m) { return signed_area(m.outlines); }},
        {"area_exact", "domain units^2", "area of the exact shape", exact_shape,
         [](M m) { return m.exact->area; }},
        {"area_drift_exact",
         "1",
         "area against that of the exact shape, less 1",
         exact_shape,
         [](M m) { return area_drift(said(m, "area"), said(m, "area_exact")); },
         {"area", "area_exact"}},
        {"area_drift_first",
         "1",
         "area against the first, less 1",
         outlines,
         [](M m) { return area_drift(said(m, "area"), m.area_first); },
         {"area"}},
        {"sd", "domain units^2", "area between the shape and the exact one", exact_shape,
         [](M m) { return symmetric_difference(m.outlines, m.exact->outlines); }},
        {"sd_rel",
         "1",
         "the same over the first area of the exact shape",
         exact_shape,
         [](M m) { return said(m, "sd") / m.area_exact_first; },
         {"sd"}},
        {"hausdorff", "domain units", "largest distance of either curve from the other",
         exact_shape, [](M m) { return hausdorff(m.outlines, m.exact->outlines).distance(); }},
        {"perimeter", "domain units", "length of the interface", outlines,
         [](M m) { return perimeter(m.outlines); }},
        {"jaggedness", "degrees", "turning angles against those of the exact curve", exact_shape,
         jaggedness_of},
        {"exact_error", "domain units^2", "area by which the exact shape may be off itself",
         exact_shape, [](M m) { return m.exact->own_error; }},
        {"min_quality", "1", "worst triangle by equation 4", mesh,
         [](M m) { return quality_of(m).min_quality; }},
        {"min_angle_deg", "degrees", "smallest angle of any triangle", mesh,
         [](M m) { return quality_of(m).min_angle_deg; }},
        {"median_angle_deg", "degrees", "median of the triangles' smallest angles", mesh,
         [](M m) { return quality_of(m).median_angle_deg; }},
    };
}

} // namespace

const std::vector<Measure>& default_measures() {
    static const std::vector<Measure> measures = make_default_measures();
    return measures;
}

std::vector<Measure> select_measures(const std::vector<std::string>& names) {
    const std::vector<Measure>& measures = default_measures();
    std::set<std::string> wanted(names.begin(), names.end());
    for (const std::string& name : names) {
        if (std::ranges::find(measures, name, &Measure::name) == measures.end()) {
            std::string known;
            for (const Measure& measure : measures) {
                known += (known.empty() ? "" : ", ") + measure.name;
            }
            throw InputError({.what = "unknown measure",
                              .where = "measures",
                              .value = "'" + name + "'",
                              .allowed = known});
        }
    }
    // Backwards, because a measure uses only those before it.
    for (std::size_t i = measures.size(); i-- > 0;) {
        if (wanted.contains(measures[i].name)) {
            wanted.insert(measures[i].uses.begin(), measures[i].uses.end());
        }
    }
    std::vector<Measure> selected;
    std::ranges::copy_if(measures, std::back_inserter(selected),
                         [&](const Measure& one) { return wanted.contains(one.name); });
    return selected;
}

Figures measure(const std::vector<Measure>& measures, Moment moment) {
    Figures figures;
    figures.reserve(measures.size());
    moment.figures = &figures;
    for (const Measure& one : measures) {
        const bool can = one.needs != Needs::exact_shape || moment.exact != nullptr;
        figures.push_back(
            {one.name, can ? one.function(moment) : std::numeric_limits<double>::quiet_NaN()});
    }
    return figures;
}

} // namespace dsc::scenes
