// SPDX-License-Identifier: MIT
#include "checks.h"

#include "measures/histogram.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <cmath>

namespace dsc::gate {

namespace {

using scenes::Histogram;
using scenes::RunResult;

// --- figures -------------------------------------------------------------------------------------

// The error of the area's change relative to the exact change; for divergence-free flows |A(t) /
// A(0) - 1|.
double area_drift(const RunResult& r) {
    return std::abs(r.area_ratio / (number(r.last, "area_exact") / r.area_exact_first) - 1);
}

double lost(const RunResult& r) { return static_cast<double>(r.inverted + r.unreached); }

double area_difference(const RunResult& a, const RunResult& b) {
    return std::abs(a.area_ratio - b.area_ratio) / b.area_ratio;
}

double area_distance(const RunResult& a, const RunResult& b) {
    return histogram_distance(a.area_histogram, b.area_histogram);
}

double quality_distance(const RunResult& a, const RunResult& b) {
    return histogram_distance(a.quality_histogram, b.quality_histogram);
}

double excess_of_error(const RunResult& a, const RunResult& b) {
    return std::max(number(a.last, "sd_rel") - number(b.last, "sd_rel"), 0.0);
}

double loss_of_quality(const RunResult& a, const RunResult& b) {
    return std::max(number(b.last, "min_quality") - number(a.last, "min_quality"), 0.0);
}

// Counts only events that change how pieces are joined; the number of others, such as a seam that
// goes on, depends on the order of the interface.
double event_difference(const RunResult& a, const RunResult& b) {
    double sum = 0;
    for (const EventKind kind :
         {EventKind::merge, EventKind::split, EventKind::meet, EventKind::t1}) {
        const auto in_a = std::ranges::count(a.events, kind, &Event::kind);
        const auto in_b = std::ranges::count(b.events, kind, &Event::kind);
        sum += static_cast<double>(std::abs(in_a - in_b));
    }
    return sum;
}

// Submeshes must not cause additional work: an edit that a submesh boundary delays may look like a
// fault of the mesh, and vertices that are inserted to repair it have to be removed again.
double effort_ratio(const RunResult& a, const RunResult& b) {
    const auto splits_and_collapses = [](const RunResult& r) {
        return static_cast<double>(r.operations.at("splits") + r.operations.at("collapses"));
    };
    return splits_and_collapses(a) / splits_and_collapses(b);
}

// A figure by its name in result files.
double figure_of(const RunResult& r, const std::string& name) {
    if (scenes::is_figure_of_fluid(name)) {
        return number(r.fluid, name);
    }
    if (name == "inverted") {
        return static_cast<double>(r.inverted);
    }
    if (name == "unreached") {
        return static_cast<double>(r.unreached);
    }
    if (name == "held") {
        return static_cast<double>(r.held);
    }
    if (name == "area_ratio") {
        return r.area_ratio;
    }
    if (name == "min_quality_ever") {
        return r.min_quality_ever;
    }
    if (name == "attribute_error_last") {
        return r.attribute_error;
    }
    const std::size_t dot = std::min(name.find('.'), name.size());
    const std::size_t moment = name.rfind('_', dot);
    const std::string measure = name.substr(0, moment) + name.substr(dot);
    const bool is_half = name.compare(moment, 5, "_half") == 0;
    return number(is_half ? r.half.value() : r.last, measure);
}

Culprit culprit_of(const std::string& figure) {
    if (figure == "inverted") {
        return Culprit::first_failure;
    }
    if (figure.starts_with("force_")) { // on a whole side
        return Culprit::none;
    }
    if (figure.starts_with("min_quality") || figure == "unreached" || figure == "held") {
        return Culprit::worst_triangle;
    }
    if (figure.find("angle_deg") != std::string::npos) {
        return Culprit::sharpest_corner;
    }
    return figure.starts_with("jaggedness") ? Culprit::turn : Culprit::deviation;
}

std::string unit_of(const std::string& figure) {
    for (const scenes::Measure& measure : scenes::default_measures()) {
        if (figure.starts_with(measure.name + "_last") ||
            figure.starts_with(measure.name + "_half")) {
            return measure.unit;
        }
    }
    return figure == "inverted"                        ? "triangles"
           : figure == "unreached" || figure == "held" ? "vertices"
                                                       : "1";
}

// The check of a figure by its name in result files, from which figure, culprit and unit follow.
Check of_figure(std::string name, std::string description, std::string group,
                const std::string& figure) {
    return {.name = std::move(name),
            .description = std::move(description),
            .group = std::move(group),
            .figure = [figure](const RunResult& r) { return figure_of(r, figure); },
            .figures = {figure},
            .culprit = culprit_of(figure),
            .unit = unit_of(figure)};
}

// --- the table -----------------------------------------------------------------------------------

Check of_fluid(const char* name, const char* description, const char* figure) {
    return {.name = name,
            .description = description,
            .group = "fluid",
            .figure = [figure](const RunResult& r) { return number(r.fluid, figure); }};
}

Check of_space(std::string name, std::string description, const std::string& figure,
               bool at_least = false) {
    return {.name = std::move(name),
            .description = std::move(description),
            .group = in_space,
            .figure = [figure](const RunResult& r) { return number(r.last, figure); },
            .at_least = at_least};
}

Check of_diagram(const char* name, const char* description, const char* figure) {
    return {.name = name,
            .description = description,
            .group = "shape",
            .figure = [figure](const RunResult& r) { return number(r.diagram, figure); }};
}

// The histogram of a measure over triangles at the end, against the one that the limit stores.
Check of_histogram(const char* name, const char* description, Histogram RunResult::*histogram,
                   std::size_t bins) {
    return {.name = name,
            .description = description,
            .group = "histograms",
            .histogram = histogram,
            .bins = bins,
            .stores = Stores::histogram};
}

// The histogram's median against the one that the limit stores.
Check of_median(const char* name, const char* description,
                std::function<double(const RunResult&)> figure, const char* unit = "1") {
    return {.name = name,
            .description = description,
            .group = "histograms",
            .figure = std::move(figure),
            .stores = Stores::figure,
            .unit = unit};
}

Check of_events(const char* name, const char* description, EventKind kind) {
    return {.name = name,
            .description = description,
            .group = "events",
            .figure =
                [kind](const RunResult& r) {
                    return static_cast<double>(std::ranges::count(r.events, kind, &Event::kind));
                },
            .unit = "events"};
}

Check of_lost(const char* name, const char* description, Of of, const char* unit) {
    return {.name = name,
            .description = description,
            .group = "validity",
            .of = of,
            .figure = lost,
            .culprit = Culprit::first_failure,
            .unit = unit};
}

// A check that compares several runs, as `of` says.
Check of_runs(Of of, const char* name, const char* description, const char* group,
              std::function<double(const RunResult&, const RunResult&)> difference,
              std::vector<std::string> figures = {}) {
    return {.name = name,
            .description = description,
            .group = group,
            .of = of,
            .difference = std::move(difference),
            .figures = std::move(figures)};
}

// Makes the limit of a check a lower one.
Check at_least(Check check, Of of = Of::sequential) {
    check.at_least = true;
    check.of = of;
    return check;
}

std::vector<Check> table() {
    using enum Of;
    const char* const area_histogram = "Kolmogorov-Smirnov distance of the triangles' areas";
    const char* const quality_histogram = "Kolmogorov-Smirnov distance of the triangles' qualities";
    return {
        {.name = "area_ratio",
         .description = "area against the exact shape's, both relative to their first",
         .group = "area",
         .figure = area_drift,
         .figures = {"area_exact_last"},
         .culprit = Culprit::deviation},
        of_figure("symmetric_difference", "area between the shape and the exact one at the end",
                  "shape", "sd_rel_last"),
        of_figure("symmetric_difference_half",
                  "the same at the half of a reversing flow, where errors do not cancel", "shape",
                  "sd_rel_half"),
        of_figure("inverted", "triangles that are not positive, by the exact predicate", "validity",
                  "inverted"),
        of_figure("unreached", "vertices that did not arrive", "validity", "unreached"),
        at_least(
            of_figure("min_quality", "worst quality at the end", "quality", "min_quality_last")),
        of_histogram("area_histogram",
                     "Kolmogorov-Smirnov distance of the triangles' areas from the stored ones",
                     &RunResult::area_histogram, RunResult::area_bins),
        of_histogram("quality_histogram", "the same of their qualities",
                     &RunResult::quality_histogram, RunResult::quality_bins),
        of_histogram("angle_histogram", "the same of their smallest angles",
                     &RunResult::angle_histogram, RunResult::angle_bins),
        of_median("median_area",
                  "median of the triangles' areas, over an equilateral triangle's of edge h, off "
                  "the stored one",
                  [](const RunResult& r) {
                      return 3 * median(r.area_histogram) / r.area_histogram.edges.back();
                  }),
        of_median("median_quality", "median of their qualities, off the stored one",
                  [](const RunResult& r) { return median(r.quality_histogram); }),
        of_median(
            "median_angle", "median of their smallest angles, off the stored one",
            [](const RunResult& r) { return median(r.angle_histogram); }, "degrees"),
        of_runs(reference, "reference_area", "area ratio, library against reference", "area",
                area_difference),
        of_runs(reference, "reference_area_histogram", area_histogram, "histograms", area_distance),
        of_runs(reference, "reference_quality_histogram", quality_histogram, "histograms",
                quality_distance),
        of_runs(reference, "reference_min_quality",
                "worst quality at the end, of the reference minus that of the library, if positive",
                "quality", loss_of_quality, {"min_quality_last"}),
        of_runs(difference, "parallel_area", "area ratio, parallel against sequential", "area",
                area_difference),
        of_runs(difference, "parallel_symmetric_difference",
                "symmetric difference of the parallel run minus that of the sequential one, if "
                "positive",
                "shape", excess_of_error, {"sd_rel_last"}),
        of_runs(difference, "parallel_events",
                "merge, split, meet and t1, parallel against sequential", "events",
                event_difference),
        of_runs(difference, "parallel_area_histogram", area_histogram, "histograms", area_distance),
        of_runs(difference, "parallel_quality_histogram", quality_histogram, "histograms",
                quality_distance),
        of_runs(difference, "parallel_effort", "splits and collapses, parallel over sequential",
                "effort", effort_ratio),
        at_least(of_figure("parallel_min_quality", "worst quality at the end, in parallel",
                           "quality", "min_quality_last"),
                 worst_parallel),
        at_least(of_figure("parallel_min_angle", "smallest angle at the end, in parallel",
                           "quality", "min_angle_deg_last"),
                 worst_parallel),
        of_lost("parallel_unreached",
                "vertices that did not arrive, and triangles inverted, in parallel", all_parallel,
                "vertices"),
        of_runs(threads, "mesh_hash",
                "different results of 1, 2, 3 and 5 threads, by each strategy", "threads", {}),
        of_figure("accuracy", "symmetric difference at the end, over the first area", "shape",
                  "sd_rel_last"),
        of_figure("accuracy_half", "the same half-way, where a flow that returns cancels nothing",
                  "shape", "sd_rel_half"),
        {.name = "accuracy_area",
         .description = "area at the end against the first, off 1",
         .group = "area",
         .figure = [](const RunResult& r) { return std::abs(r.area_ratio - 1); },
         .culprit = Culprit::deviation},
        of_figure("accuracy_jagged",
                  "largest turning angle of the interface beyond twice the exact curve's plus 2 "
                  "degrees",
                  "shape", "jaggedness_last.largest_excess_deg"),
        at_least(of_figure("accuracy_angle", "smallest angle at the end", "quality",
                           "min_angle_deg_last")),
        at_least(of_figure("accuracy_median_angle",
                           "median of the triangles' smallest angles at the end", "quality",
                           "median_angle_deg_last")),
        of_lost("accuracy_lost", "triangles inverted and vertices that did not arrive", sequential,
                "1"),
        of_fluid("fluid_velocity", "largest velocity at the end", "largest_velocity_last"),
        of_fluid("fluid_amplitude",
                 "root mean square of what a wave's height is off, over the first height",
                 "amplitude_error"),
        of_fluid("fluid_frequency", "error of a wave's frequency, relative", "frequency_error"),
        of_fluid("fluid_circularity", "smallest circularity", "circularity_min"),
        of_fluid("fluid_rise", "largest mean velocity upwards", "rise_velocity_max"),
        of_fluid("fluid_centre", "height of the centroid at the end", "centre_last"),
        of_fluid("fluid_area", "area at the end against the first, off 1", "area_drift_last"),
        of_fluid("fluid_neck", "half-width of a neck, largest relative error", "neck_error"),
        of_space("space_difference",
                 "symmetric difference at the end in three dimensions, over the exact volume",
                 "sd_rel_last"),
        of_space("space_difference_half", "the same half-way", "sd_rel_half"),
        of_space("space_vertices", "distance of vertices from the exact shape, rms over h",
                 "vertex_error_rms_h"),
        of_space("space_farthest", "the same of the farthest vertex", "vertex_error_max_h"),
        of_space("space_angle", "smallest dihedral angle at the end", "min_dihedral_deg_last",
                 true),
        of_space("space_angle_ever", "smallest dihedral angle ever", "min_dihedral_deg_ever", true),
        of_diagram("wrong_area", "area at the end that belongs to another disc", "wrong_area_last"),
        of_diagram("seam_error", "largest distance of a seam from where fronts meet",
                   "seam_error_last"),
        of_events("merges", "pieces that merge", EventKind::merge),
        of_events("splits", "pieces that fall in two", EventKind::split),
        of_events("widenings", "times that a film opened farther than at first", EventKind::widen),
    };
}

} // namespace

bool Check::is_called(const std::string& name_or_group) const {
    const bool is_kind =
        name_or_group == "parallel" || name_or_group == "reference" || name_or_group == "accuracy";
    return name_or_group == name || name_or_group == group ||
           (is_kind && name.starts_with(name_or_group));
}

const std::vector<std::shared_ptr<const Check>>& all_checks() {
    static const std::vector<std::shared_ptr<const Check>> checks = [] {
        std::vector<std::shared_ptr<const Check>> all;
        for (Check& check : table()) {
            all.push_back(std::make_shared<const Check>(std::move(check)));
        }
        return all;
    }();
    return checks;
}

std::shared_ptr<const Check> find_check(const std::string& name) {
    const auto found = std::ranges::find(all_checks(), name, &Check::name);
    if (found == all_checks().end()) {
        throw InputError({.what = "unknown check",
                          .where = "run",
                          .value = scenes::quoted_excerpt(name),
                          .allowed = scenes::name_list(all_checks(),
                                                       [](const auto& one) { return one->name; })});
    }
    return *found;
}

std::shared_ptr<const Check> check_of_figure(const std::string& figure, const std::string& name,
                                             bool at_least) {
    Check check = of_figure(name, figure + ", as the scene file limits it", figure, figure);
    check.at_least = at_least;
    return std::make_shared<const Check>(std::move(check));
}

std::shared_ptr<const Check> check_in_space(const std::string& figure, const std::string& name,
                                            bool at_least) {
    return std::make_shared<const Check>(
        of_space(name, figure + ", as the scene file limits it", figure, at_least));
}

} // namespace dsc::gate
