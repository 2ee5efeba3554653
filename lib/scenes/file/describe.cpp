// SPDX-License-Identifier: MIT
#include "scenes/file/describe.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/digits.h"
#include "scenes/file/fluid_source.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/formula/formula_length.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

std::string phases_in_toml(const std::string& key, const std::vector<Phase>& phases) {
    std::string list;
    for (const Phase phase : phases) {
        list += (list.empty() ? "" : ", ") + std::to_string(phase);
    }
    return list.empty() ? "" : key + " = [" + list + "]\n";
}

std::string curvature_in_toml(const CurvatureMotion& motion) {
    std::string text = "\n[curvature]\n" + phases_in_toml("keeps", motion.keeps);
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
    if (setup.fluid) {
        return fluid_in_toml(setup.fluid->options);
    }
    return setup.curvature ? curvature_in_toml(*setup.curvature) : flow_in_toml(setup.flow, scene);
}

// --- numbers ------------------------------------------------------------------------------------

std::string options_in_toml(Parameters parameters, const Setup& setup, bool has_period) {
    parameters.dt = setup.dt;
    parameters.steps = setup.steps;
    std::string text = "\n[options]\n";
    for (const Key& key : parameter_keys()) {
        if (key.is_common) {
            text += key.name + " = " + in_toml(key.value(parameters)) + '\n';
        }
    }
    return has_period ? text + "period = " + in_toml(parameters.period) + '\n' : text;
}

// The same operations in the same order as LengthAcross, so that the bits are the same.
std::string formula_of(const LengthAcross& f) {
    const std::string now =
        '(' + in_toml(f.radius) + " + " + in_toml(f.speed) + "*t)"; // the radius now
    return in_toml(f.left) + " + (" + in_toml(f.right) + " - " + in_toml(f.left) +
           ")*min(max((x - (" + in_toml(f.centre) + " - " + now + "))/(2*" + now + "), 0), 1)";
}

// A target by place, or along the interface; nothing where it has no name.
template <class Function>
std::optional<std::string> length_in_toml(const Function& function) {
    if (const auto* across = function.template target<LengthAcross>()) {
        return in_quotes(formula_of(*across));
    }
    if (const auto* formula = function.template target<FormulaLength>()) {
        return in_quotes(formula->formula());
    }
    if (const auto* one = function.template target<OneLength>()) {
        return in_quotes(in_toml(one->length));
    }
    return std::nullopt;
}

std::string sizes_in_toml(const SizeOptions<double>& sizes, const std::string& scene) {
    std::string text;
    bool has_names = true;
    if (const auto* edges = sizes.by_distance.target<EdgesToInterface>()) {
        text += "edges_to_interface = " + in_toml(edges->number) + '\n';
    } else {
        has_names = !sizes.by_distance;
    }
    if (const auto* by_phase = sizes.by_place.target<LengthByPhase>()) {
        std::string list;
        for (const double length : by_phase->lengths) {
            list += (list.empty() ? "" : ", ") + in_toml(length);
        }
        text += "by_phase = [" + list + "]\n";
    } else if (sizes.by_place) {
        const auto length = length_in_toml(sizes.by_place);
        has_names = has_names && length;
        text += "by_place = " + length.value_or("") + '\n';
    }
    if (sizes.on_interface) {
        const auto length = length_in_toml(sizes.on_interface);
        has_names = has_names && length;
        text += "on_interface = " + length.value_or("") + '\n';
    }
    if (!has_names) {
        throw InputError({.what = "sizes that a scene file has no name for",
                          .where = "describe",
                          .value = "the scene " + scene,
                          .allowed = "the targets of scene.h, and formulas"});
    }
    text += sizes.longest > 0 ? "longest = " + in_toml(sizes.longest) + '\n' : "";
    return text.empty() ? "" : "\n[sizes]\n" + text;
}

std::string upkeep_in_toml(const Setup& setup) {
    std::string text;
    for (std::size_t i = 0; i < setup.thresholds.size(); ++i) {
        const PhaseThresholds& t = setup.thresholds[i];
        text += "\n[[thresholds]]\nphase = " + std::to_string(i) +
                "\ncollapse_quality = " + in_toml(t.collapse_quality) +
                "\nsmooth_quality = " + in_toml(t.smooth_quality) +
                "\nlongest = " + in_toml(t.longest) + "\nshortest = " + in_toml(t.shortest) +
                "\ncrowded = " + in_toml(t.crowded) + '\n';
    }
    if (setup.insertion) {
        text += "\n[insertion]\non_circle = " + in_toml(setup.insertion->centre) + '\n';
    }
    if (setup.value) {
        const RadialValue& v = *setup.value;
        text += "\n[value]\ncentre = " + in_toml(v.centre) +
                "\nfirst_radius = " + in_toml(v.first_radius) +
                "\nlast_radius = " + in_toml(v.last_radius) + "\nspeed = " + in_toml(v.speed) +
                "\npower = " + in_toml(v.power) + '\n';
    }
    return text;
}

// The settings with which the scene's own exact shape is the one of this run.
std::string exact_in_toml(const Scene& scene, const Parameters& parameters) {
    std::string settings;
    for (const Key& key : parameter_keys()) {
        const Setting value = key.value(parameters);
        // h in any case: the points below stay where they are if the file gets another one.
        if (value != key.value(scene.defaults) || key.name == "h") {
            settings += (settings.empty() ? "" : ", ") +
                        in_quotes(key.name + '=' + without_quotes(in_toml(value)));
        }
    }
    return "\n# That of the shape and the motion in this file, and refused once they are others: "
           "then say\n"
           "# what it is (back, carried or circle), or strike [exact] out.\n[exact]\nscene = " +
           in_quotes(scene.name) + "\nset = [" + settings + "]\n";
}

std::string measure_in_toml(const SceneFile& file, const Setup& setup) {
    std::string names;
    for (const Measure& measure : file.measures) {
        names += (names.empty() ? "" : ", ") + in_quotes(measure.name);
    }
    return "\n[measure]\nmeasures = [" + names + "]\n" +
           (setup.measured ? "phase = " + std::to_string(*setup.measured) + '\n' : "") +
           (setup.half_step ? "half_step = " + std::to_string(*setup.half_step) + '\n' : "") +
           (file.measures_shape ? "" : "shape = false\n");
}

std::string limits_in_toml(const std::vector<FigureLimit>& limits) {
    std::string text;
    for (const FigureLimit& limit : limits) {
        std::string bounds = std::isfinite(limit.least) ? "least = " + in_toml(limit.least) : "";
        if (std::isfinite(limit.most)) {
            bounds += (bounds.empty() ? "most = " : ", most = ") + in_toml(limit.most);
        }
        text += limit.figure + " = { " + bounds + " }\n";
    }
    return text.empty() ? "" : "\n[limits]\n" + text;
}

// What the file says itself, or what it took over from the scene that it began as.
std::string exact_of_file(const SceneFile& file, const Parameters& parameters, const Setup& setup) {
    if (!file.exact.empty()) {
        return '\n' + file.exact;
    }
    if (!setup.exact) {
        return "";
    }
    return exact_in_toml(file.begins_as.empty() ? file.scene : find_scene(file.begins_as),
                         parameters);
}

} // namespace

std::string describe(const Scene& scene, const Parameters& parameters) {
    return describe(SceneFile{.scene = scene}, parameters);
}

std::string describe(const SceneFile& file, const Parameters& parameters) {
    const Scene& scene = file.scene;
    const Setup setup = scene.prepare(parameters);
    const bool has_period =
        parameters.period > 0 && std::ranges::find(scene.keys, "period") != scene.keys.end();
    return "# The scene " + scene.name + ", in full. Run it with: dsc_scene run FILE.toml\n" +
           "name = " + in_quotes(scene.name) + "\ndescription = " + in_quotes(scene.description) +
           '\n' + phases_in_toml("carried", setup.carried) +
           options_in_toml(parameters, setup, has_period) + sizes_in_toml(setup.sizes, scene.name) +
           upkeep_in_toml(setup) + motion_in_toml(setup, scene.name) +
           exact_of_file(file, parameters, setup) + measure_in_toml(file, setup) +
           limits_in_toml(file.limits) + geometry_in_toml(setup);
}

} // namespace dsc::scenes
