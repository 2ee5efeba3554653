// SPDX-License-Identifier: MIT
#include "scenes/file/describe.h"

#include "dsc/base/error.h"
#include "scenes/digits.h"
#include "scenes/file/formula/formula_flow.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

namespace {

std::string in_quotes(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
        }
        quoted += c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
    }
    return quoted + '"';
}

std::string in_toml(double value) { return shortest_digits(value); }
std::string in_toml(const Point<double>& p) {
    return '[' + in_toml(p.x()) + ", " + in_toml(p.y()) + ']';
}

// As text where it does not fit the integers of TOML.
std::string in_toml(const Setting& setting) {
    struct Writer {
        std::string operator()(double value) const { return in_toml(value); }
        std::string operator()(int value) const { return std::to_string(value); }
        std::string operator()(std::uint64_t value) const {
            return value > INT64_MAX ? in_quotes(std::to_string(value)) : std::to_string(value);
        }
        std::string operator()(const std::string& value) const { return in_quotes(value); }
    };
    return std::visit(Writer{}, setting);
}

std::string without_quotes(const std::string& text) {
    return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

// --- geometry -----------------------------------------------------------------------------------

std::string points_in_toml(const std::vector<Point<double>>& points) {
    std::string text = "points = [\n";
    for (const Point<double>& point : points) {
        text += "    " + in_toml(point) + ",\n";
    }
    return text + "]\n";
}

std::string geometry_in_toml(const Setup& setup) {
    std::string text = "\n[domain]\nlow = " + in_toml(setup.domain.low) +
                       "\nhigh = " + in_toml(setup.domain.high) + '\n';
    if (setup.clamped) {
        text += "clamped = true\n";
    }
    if (!setup.curves.empty()) {
        for (const dsc::Curve& curve : setup.curves) {
            text += "\n[[curve]]\nleft = " + std::to_string(curve.left) +
                    "\nright = " + std::to_string(curve.right) + '\n' +
                    points_in_toml(curve.points);
        }
        return text;
    }
    for (std::size_t i = 0; i < setup.outlines.size(); ++i) {
        const Phase phase = setup.phases.empty() ? 1 : setup.phases[i];
        text += "\n[[shape]]\nphase = " + std::to_string(phase) + '\n' +
                points_in_toml(setup.outlines[i]);
    }
    return text;
}

// --- motion -------------------------------------------------------------------------------------

std::string formulas_in_toml(const FormulaTexts& texts) {
    std::string text = "u = " + in_quotes(texts.u) + "\nv = " + in_quotes(texts.v) + '\n';
    std::string parameters;
    for (const auto& [name, value] : texts.parameters) {
        if (name != "h" && name != "period") {
            parameters += (parameters.empty() ? "" : ", ") + name + " = " + in_toml(value);
        }
    }
    return parameters.empty() ? text : text + "parameters = { " + parameters + " }\n";
}

std::string velocity_in_toml(const Velocity& velocity, const std::string& scene) {
    if (const auto* f = velocity.target<Translation>()) {
        return "translation = { velocity = " + in_toml(f->velocity) + " }\n";
    }
    if (const auto* f = velocity.target<Radial>()) {
        return "radial = { centre = " + in_toml(f->centre) + ", speed = " + in_toml(f->speed) +
               " }\n";
    }
    if (const auto* f = velocity.target<Rotation>()) {
        return "rotation = { centre = " + in_toml(f->centre) +
               ", angular_speed = " + in_toml(f->angular_speed) + " }\n";
    }
    if (const auto* f = velocity.target<Vortex>()) {
        return "vortex = { centre = " + in_toml(f->centre) + ", speed = " + in_toml(f->speed) +
               " }\n";
    }
    if (const auto* f = velocity.target<Swirl>()) {
        return "swirl = { amplitude = " + in_toml(f->amplitude) +
               ", period = " + in_toml(f->period) + " }\n";
    }
    if (const auto* f = velocity.target<Falling>()) {
        return "falling = { surface = " + in_toml(f->surface) + ", depth = " + in_toml(f->depth) +
               ", speed = " + in_toml(f->speed) + " }\n";
    }
    if (const auto* f = velocity.target<FormulaFlow>()) {
        return formulas_in_toml(f->texts());
    }
    throw InputError({.what = "a flow that a scene file has no name for",
                      .where = "describe",
                      .value = "the scene " + scene,
                      .allowed = "flows of flows/velocity.h, and formulas"});
}

std::string flow_in_toml(const Flow& flow, const std::string& scene) {
    std::string text;
    for (const Leg& leg : flow) {
        text += flow.size() == 1 ? "\n[flow]\n" : "\n[[flow]]\n";
        if (std::isfinite(leg.end)) {
            text += "until = " + in_toml(leg.end) + '\n';
        }
        const auto* opposite = leg.velocity.target<Reversed>();
        text += velocity_in_toml(opposite != nullptr ? opposite->velocity : leg.velocity, scene);
        text += opposite != nullptr ? "reversed = true\n" : "";
    }
    return text;
}

std::string curvature_in_toml(const CurvatureMotion& motion) {
    std::string text = "\n[curvature]\n";
    if (!motion.keeps.empty()) {
        std::string phases;
        for (const Phase phase : motion.keeps) {
            phases += (phases.empty() ? "" : ", ") + std::to_string(phase);
        }
        text += "keeps = [" + phases + "]\n";
    }
    for (const PairCurvature& pair : motion.pairs) {
        text += "[[curvature.pairs]]\none = " + std::to_string(pair.one) +
                "\nother = " + std::to_string(pair.other) + "\ntension = " + in_toml(pair.tension) +
                "\nmobility = " + in_toml(pair.mobility) + '\n';
    }
    return text;
}

std::string motion_in_toml(const Setup& setup, const std::string& scene) {
    if (setup.growth) {
        const Growth& growth = *setup.growth;
        return "\n[growth]\nspeed = " + in_toml(growth.speed) + '\n' +
               (std::isfinite(growth.turns_at) ? "turns_at = " + in_toml(growth.turns_at) + '\n'
                                               : "");
    }
    return setup.curvature ? curvature_in_toml(*setup.curvature) : flow_in_toml(setup.flow, scene);
}

// --- numbers ------------------------------------------------------------------------------------

std::string options_in_toml(Parameters parameters, const Setup& setup) {
    parameters.dt = setup.dt;
    parameters.steps = setup.steps;
    std::string text = "\n[options]\n";
    for (const Key& key : parameter_keys()) {
        if (key.is_common) {
            text += key.name + " = " + in_toml(key.value(parameters)) + '\n';
        }
    }
    return text;
}

std::string sizes_in_toml(const SizeOptions<double>& sizes, const std::string& scene) {
    if (!sizes.by_distance && !sizes.by_place && sizes.longest == 0) {
        return "";
    }
    const auto* edges = sizes.by_distance.target<EdgesToInterface>();
    if (sizes.by_place || (sizes.by_distance && edges == nullptr)) {
        throw InputError({.what = "sizes that a scene file has no name for",
                          .where = "describe",
                          .value = "the scene " + scene,
                          .allowed = "EdgesToInterface and a longest length"});
    }
    return "\n[sizes]\n" +
           (edges != nullptr ? "edges_to_interface = " + in_toml(edges->number) + '\n' : "") +
           (sizes.longest > 0 ? "longest = " + in_toml(sizes.longest) + '\n' : "");
}

// The settings with which the scene's own exact shape is the one of this run.
std::string exact_in_toml(const Scene& scene, const Parameters& parameters) {
    std::string settings;
    for (const Key& key : parameter_keys()) {
        const Setting value = key.value(parameters);
        if (value != key.value(scene.defaults)) {
            settings += (settings.empty() ? "" : ", ") +
                        in_quotes(key.name + '=' + without_quotes(in_toml(value)));
        }
    }
    return "\n[exact]\nscene = " + in_quotes(scene.name) + '\n' +
           (settings.empty() ? "" : "set = [" + settings + "]\n");
}

std::string measure_in_toml(const Setup& setup) {
    if (!setup.measured && !setup.half_step) {
        return "";
    }
    return "\n[measure]\n" +
           (setup.measured ? "phase = " + std::to_string(*setup.measured) + '\n' : "") +
           (setup.half_step ? "half_step = " + std::to_string(*setup.half_step) + '\n' : "");
}

} // namespace

std::string describe(const Scene& scene, const Parameters& parameters) {
    const Setup setup = scene.prepare(parameters);
    return "# The scene " + scene.name + ", in full. Run it with: dsc_scene run FILE.toml\n" +
           "name = " + in_quotes(scene.name) + "\ndescription = " + in_quotes(scene.description) +
           '\n' + options_in_toml(parameters, setup) + sizes_in_toml(setup.sizes, scene.name) +
           motion_in_toml(setup, scene.name) +
           (setup.exact ? exact_in_toml(scene, parameters) : "") + measure_in_toml(setup) +
           geometry_in_toml(setup);
}

} // namespace dsc::scenes
