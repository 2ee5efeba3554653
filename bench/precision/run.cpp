// SPDX-License-Identifier: MIT
#include "run.h"

#include "dsc/base/error.h"
#include "markers.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/output/machine.h"
#include "scenes/run/json.h"
#include "scenes/run/run.h"

#include <algorithm>
#include <cmath>

namespace dsc::bench {

namespace {

using Json = nlohmann::ordered_json;

// A single time below this is not reliable on any machine.
constexpr double short_run_s = 0.3;
constexpr int max_repetitions = 3;

// The number of steps, in total or each way.
int steps_of(const Case& item) {
    const Flow& flow = *item.flow;
    double dt = flow.step_over_length * item.method->step_factor * item.h;
    if (item.method->step == Method::Step::with_square) {
        dt *= item.h / flow.lengths.front();
    }
    const double duration = flow.there_and_back ? flow.duration / 2 : flow.duration;
    const int steps = std::max(1, static_cast<int>(std::lround(duration / dt)));
    // An even number, so that a step ends when the flow turns back.
    return flow.period > 0 ? steps + steps % 2 : steps;
}

std::map<std::string, std::string> settings_of(const Case& item) {
    const Flow& flow = *item.flow;
    const int steps = steps_of(item);
    const double duration = flow.there_and_back ? flow.duration / 2 : flow.duration;
    std::map<std::string, std::string> result{{"h", to_text(item.h)},
                                              {"dt", to_text(duration / steps)},
                                              {"steps", std::to_string(steps)}};
    if (flow.period > 0) {
        result["period"] = to_text(flow.period);
    }
    for (const Setting& setting : item.method->settings) {
        result[setting.key] = !setting.word.empty()
                                  ? setting.word
                                  : to_text(setting.factor * std::pow(item.h, setting.power));
    }
    return result;
}

// A run that is only timed does not need an exact shape.
scenes::Scene without_exact_shape(scenes::Scene scene) {
    scene.prepare = [prepare = scene.prepare](const scenes::Parameters& parameters) {
        scenes::Setup setup = prepare(parameters);
        setup.exact = [outlines = setup.outlines](double) {
            return scenes::ExactShape{outlines, scenes::signed_area(outlines), 0};
        };
        return setup;
    };
    return scene;
}

CaseResult run_dsc(const Case& item, ExactShapes& shapes) {
    const scenes::Parameters parameters = parameters_of(item);
    scenes::RunOptions options;
    options.strategy = item.method->strategy;
    const scenes::Scene scene = shapes.scene_of(item);
    scenes::RunResult result = scenes::run_scene(scene, parameters, options);
    int repetitions = 1;
    double spent = result.cpu_s;
    for (; repetitions < max_repetitions && spent < short_run_s; ++repetitions) {
        const auto again = scenes::run_scene(without_exact_shape(scene), parameters, options);
        if (again.mesh_hash != result.mesh_hash) {
            throw InvariantError(file_name(item) + ": two runs ended in different meshes");
        }
        spent += again.cpu_s;
        result.cpu_s = std::min(result.cpu_s, again.cpu_s);
        result.wall_s = std::min(result.wall_s, again.wall_s);
    }
    Json json = Json::parse(scenes::to_json(result));
    json["repetitions"] = repetitions;
    return {std::move(json), result.inverted == 0 && result.gave_up.empty(), result.unreached};
}

CaseResult run_bare(const Case& item, ExactShapes& shapes) {
    const scenes::Parameters parameters = parameters_of(item);
    const scenes::Setup setup = shapes.scene_of(item).prepare(parameters);
    MarkerResult result = run_markers(setup, parameters.h, *item.method->markers);
    int repetitions = 1;
    double spent = result.cpu_s;
    for (; repetitions < max_repetitions && spent < short_run_s; ++repetitions) {
        const auto again = run_markers(setup, parameters.h, *item.method->markers);
        spent += again.cpu_s;
        result.cpu_s = std::min(result.cpu_s, again.cpu_s);
    }
    Json json = to_json(result);
    json["scene"] = item.flow->scene;
    json["parameters"] = {{"h", parameters.h}, {"dt", setup.dt}, {"steps", setup.steps}};
    json["strategy"] = "bare markers";
    json["repetitions"] = repetitions;
    json["commit"] = scenes::commit();
    json["machine"] = scenes::machine();
    return {std::move(json)};
}

} // namespace

std::vector<Case> cases_of(const std::vector<const Flow*>& flows,
                           const std::vector<const Method*>& methods, bool quick) {
    std::vector<Case> cases;
    for (const Flow* flow : flows) {
        for (const Method* method : methods) {
            // Skipped if the exact shape is a polygon: its difference from a curve would count as
            // an error.
            if ((quick && !method->in_quick) || (method->markers && !flow->smooth) ||
                (method->reads_curves && flow->polygon_is_exact)) {
                continue;
            }
            const bool all = !flow->last_by_few || method->to_the_last;
            const std::size_t count =
                std::min({flow->lengths.size() - (all ? 0 : 1), method->max_lengths,
                          quick ? flow->quick_lengths : std::size_t{99}});
            for (std::size_t i = 0; i < count; ++i) {
                cases.push_back({flow, method, flow->lengths[i]});
            }
        }
    }
    return cases;
}

std::string file_name(const Case& item) {
    std::string name = item.flow->name + "--" + item.method->name + "--" + to_text(item.h);
    std::string result;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
        if (plain || c == ' ') {
            result += plain ? c : '-';
        }
    }
    return result + ".json";
}

scenes::Parameters parameters_of(const Case& item) {
    const scenes::Scene& scene = scenes::find_scene(item.flow->scene);
    scenes::Parameters parameters = scene.defaults;
    for (const auto& [key, value] : settings_of(item)) {
        scenes::set_parameter(parameters, scene.keys, key, value);
    }
    return parameters;
}

scenes::Scene ExactShapes::scene_of(const Case& item) {
    scenes::Scene scene = scenes::find_scene(item.flow->scene);
    const Flow* flow = item.flow;
    scene.prepare = [this, flow, prepare = scene.prepare](const scenes::Parameters& parameters) {
        scenes::Setup setup = prepare(parameters);
        const double h = flow->polygon_is_exact ? parameters.h : 0;
        setup.exact = [this, flow, h, exact = setup.exact](double time) {
            const Key key{flow, h, std::llround(1e9 * time / flow->duration)};
            const auto found = shapes_.find(key);
            return found != shapes_.end() ? found->second
                                          : shapes_.emplace(key, exact(time)).first->second;
        };
        return setup;
    };
    return scene;
}

CaseResult run_case(const Case& item, ExactShapes& shapes) {
    CaseResult result = item.method->markers ? run_bare(item, shapes) : run_dsc(item, shapes);
    result.json["flow"] = item.flow->name;
    result.json["flow_title"] = item.flow->title;
    result.json["method"] = item.method->name;
    result.json["group"] = to_string(item.method->group);
    return result;
}

} // namespace dsc::bench
