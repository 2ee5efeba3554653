// SPDX-License-Identifier: MIT
#include "own_scenes.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dsc::gate {

namespace {

using scenes::FigureLimit;
using scenes::RunResult;
using scenes::SceneFile;

/// What errors and rows name the checks of [limits] by.
const std::string of_file = "limits.";

// A figure by its name in result files.
double figure_of(const RunResult& r, const std::string& name) {
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
    return "1";
}

Check check_of(const FigureLimit& limit, const std::string& name, bool at_least) {
    return {.name = name,
            .description = limit.figure + ", as the scene file limits it",
            .unit = unit_of(limit.figure),
            .at_least = at_least,
            .scenes = {},
            .measure =
                [figure = limit.figure](Runs& runs, const std::string& scene) {
                    return Measured{figure_of(finished(runs, {scene}), figure), {scene}};
                },
            .figures = {limit.figure},
            .culprit = culprit_of(limit.figure)};
}

} // namespace

std::vector<SceneFile> read_scenes(const std::vector<std::string>& paths) {
    std::vector<SceneFile> files;
    std::set<std::string> names;
    for (const std::string& path : paths) {
        files.push_back(scenes::read_scene_file(path));
        const std::string& name = files.back().scene.name;
        if (!names.insert(name).second) {
            throw InputError({.what = "two scenes of one name",
                              .where = path,
                              .value = name,
                              .allowed = "a `name` of its own in each file"});
        }
    }
    return files;
}

std::string why_not(const std::vector<std::string>& figures, const SceneFile& file) {
    const scenes::Setup setup = file.scene.prepare(file.scene.defaults);
    for (const std::string& figure : figures) {
        const std::string reason = scenes::why_missing(
            figure, scenes::measured_by(file.measures, file.measures_shape, setup));
        if (!reason.empty()) {
            return reason;
        }
    }
    return "";
}

std::vector<Check> checks_of_files(const std::vector<SceneFile>& files, Limits& limits) {
    std::vector<Check> checks;
    const auto add = [&](const SceneFile& file, const FigureLimit& limit, const std::string& name,
                         double value, bool at_least) {
        auto check = std::ranges::find(checks, name, &Check::name);
        if (check == checks.end()) {
            check = checks.insert(checks.end(), check_of(limit, name, at_least));
        }
        check->scenes.push_back(file.scene.name);
        limits.add(name, file.scene.name, {value, limit.where});
    };
    for (const SceneFile& file : files) {
        for (const FigureLimit& limit : file.limits) {
            const std::string name = of_file + limit.figure;
            if (std::isfinite(limit.least)) {
                add(file, limit, name + ".least", limit.least, true);
            }
            if (std::isfinite(limit.most)) {
                add(file, limit, name + (std::isfinite(limit.least) ? ".most" : ""), limit.most,
                    false);
            }
        }
    }
    return checks;
}

std::vector<Task> tasks_of_files(const std::vector<const Check*>& checks,
                                 const std::vector<SceneFile>& files, const Limits& limits) {
    std::vector<Task> tasks;
    for (const Check* check : checks) {
        for (const SceneFile& file : files) {
            if (!limits.has(check->name, file.scene.name)) {
                continue;
            }
            const std::string reason = why_not(check->figures, file);
            if (!reason.empty()) {
                throw InputError(
                    {.what = "a limit without its measure",
                     .where = limits.path() + ": " + check->name + ", " + file.scene.name,
                     .value = reason,
                     .allowed = "limits of figures that the run has"});
            }
            tasks.push_back({check, file.scene.name});
        }
    }
    return tasks;
}

void check_has_limits(const std::vector<SceneFile>& files, const Limits& limits,
                      bool has_limits_file) {
    for (const SceneFile& file : files) {
        const std::string& name = file.scene.name;
        const auto is_of_json = [&](const auto& entry) {
            return entry.first.second == name && !entry.first.first.starts_with(of_file);
        };
        const bool has_any = std::ranges::any_of(limits.all(), is_of_json);
        if (has_limits_file && !has_any) {
            throw InputError(
                {.what = "no limit of this scene",
                 .where = limits.path(),
                 .value = name,
                 .allowed = "limits of " + name + ", such as `dsc_verify propose` writes"});
        }
        if (file.limits.empty() && !has_any) {
            throw InputError({.what = "a scene without limits",
                              .where = file.scene.section,
                              .value = "no [limits]",
                              .allowed = "[limits] in the file, or --limits FILE"});
        }
    }
}

} // namespace dsc::gate
