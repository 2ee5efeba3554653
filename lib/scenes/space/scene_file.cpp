// SPDX-License-Identifier: MIT
#include "scenes/space/scene_file.h"

#include "dsc3/dsc3.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/scene_parts.h"
#include "scenes/space/run.h"
#ifdef DSC_SURFACE_FILES
#include "surface_files/surface_files.h"
#endif

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::scenes::space {

namespace {

using std::numbers::pi;

dsc3::Point vector_of(const TableReader& reader, const std::string& key, Bounds bounds = {}) {
    const std::vector<double> numbers = reader.numbers(key, bounds);
    if (numbers.size() != 3) {
        reader.refuse(key, "bad value", "three numbers");
    }
    return {numbers[0], numbers[1], numbers[2]};
}

dsc3::Box domain_of(const TableReader& reader) {
    reader.allow({"low", "size"});
    const dsc3::Point low = reader.has("low") ? vector_of(reader, "low") : dsc3::Point(0, 0, 0);
    return {low, low + vector_of(reader, "size", positive_length)};
}

/// A shape, and its exact volume.
struct KnownShape {
    dsc3::Shape shape;
    double volume = 0;
    std::optional<std::int64_t> euler_characteristic{}; ///< of a surface from a file
};

void add_file(const TableReader& reader, [[maybe_unused]] KnownShape& known) {
#ifdef DSC_SURFACE_FILES
    const std::string path = (reader.file().parent_path() / reader.text("file")).string();
    dsc3::TriangleSurface surface = dsc3::read_surface(path);
    const double scale = reader.number_or(1, "scale", positive_length);
    const dsc3::Point move = reader.has("move") ? vector_of(reader, "move") : dsc3::Point(0, 0, 0);
    for (dsc3::Point& p : surface.points) {
        p = scale * p + move;
    }
    dsc3::SurfaceFigures figures;
    known.shape.distance = dsc3::closed_surface(std::move(surface), &figures);
    known.volume = figures.volume;
    known.euler_characteristic = figures.euler_characteristic;
#else
    reader.refuse("file", "this program was built without Assimp and cannot read surfaces",
                  "another shape; or install libassimp-dev and build again");
#endif
}

KnownShape shape_of(const TableReader& reader) {
    const std::vector<std::string> kinds{"sphere", "box", "ellipsoid", "torus", "plane", "file"};
    const std::string kind = reader.one_of(kinds);
    std::vector<std::string> keys{kind, "phase", "divides"};
    if (kind == "file") {
        keys.insert(keys.end(), {"scale", "move"});
    }
    reader.allow(keys);
    KnownShape known{.shape = {.distance = {}, .phase = reader.phase_or(1, "phase")}};
    if (reader.has("divides")) {
        const std::vector<Phase> phases = reader.phases("divides");
        if (reader.has("phase") || phases.empty() || phases.size() % 2 != 0) {
            reader.refuse("divides", "bad value",
                          "pairs of phases [from, to, ...], and no key phase");
        }
        for (std::size_t i = 0; i < phases.size(); i += 2) {
            known.shape.divides.push_back({phases[i], phases[i + 1]});
        }
    }
    if (kind == "file") {
        add_file(reader, known);
        return known;
    }
    const TableReader of = reader.table(kind);
    if (kind == "sphere") {
        of.allow({"centre", "radius"});
        const double radius = of.number("radius", positive_length);
        known.shape.distance = dsc3::ball(vector_of(of, "centre"), radius);
        known.volume = 4.0 / 3 * pi * std::pow(radius, 3);
    } else if (kind == "box") {
        of.allow({"low", "high"});
        const dsc3::Box box{vector_of(of, "low"), vector_of(of, "high")};
        const dsc3::Point size = box.high - box.low;
        if (!(size.minCoeff() > 0)) {
            of.refuse("high", "bad value", "beyond low in each direction");
        }
        known.shape.distance = dsc3::box(box);
        known.volume = size.prod();
    } else if (kind == "ellipsoid") {
        of.allow({"centre", "radii"});
        const dsc3::Point radii = vector_of(of, "radii", positive_length);
        known.shape.distance = dsc3::ellipsoid(vector_of(of, "centre"), radii);
        known.volume = 4.0 / 3 * pi * radii.prod();
    } else if (kind == "plane") {
        of.allow({"point", "normal"});
        const dsc3::Point normal = vector_of(of, "normal");
        if (!(normal.norm() > 0)) {
            of.refuse("normal", "bad value", "a direction");
        }
        known.shape.distance = [point = vector_of(of, "point"),
                                normal = dsc3::Point(normal.normalized())](const dsc3::Point& p) {
            return normal.dot(p - point);
        };
        if (known.shape.divides.empty()) {
            reader.refuse("plane", "a plane has no inside of its own",
                          "divides = [1, 2]: phase 1 becomes 2 where the normal does not point");
        }
    } else {
        of.allow({"centre", "axis", "radius", "tube"});
        const double radius = of.number("radius", positive_length);
        const double tube = of.number("tube", positive_length);
        if (!(tube < radius)) {
            of.refuse("tube", "bad value", "less than the radius");
        }
        const dsc3::Point axis = of.has("axis") ? vector_of(of, "axis") : dsc3::Point(0, 0, 1);
        if (!(axis.norm() > 0)) {
            of.refuse("axis", "bad value", "a direction");
        }
        known.shape.distance = dsc3::torus(vector_of(of, "centre"), axis, radius, tube);
        known.volume = 2 * pi * pi * radius * tube * tube;
    }
    return known;
}

/// Makes the flow for the final values of h and the period, which --set may have changed.
std::function<dsc3::Velocity(const Parameters&)> flow_of(const TableReader& reader) {
    reader.allow({"u", "v", "w", "parameters"});
    SpaceFormulaTexts texts{.components = {reader.text("u"), reader.text("v"), reader.text("w")},
                            .where = {reader.where("u"), reader.where("v"), reader.where("w")}};
    if (reader.has("parameters")) {
        const TableReader table = reader.table("parameters");
        for (const std::string& name : table.keys()) {
            if (!is_parameter_name(name) || name == "z" || name == "pi" || name == "h" ||
                name == "period") {
                table.refuse(name, "bad name for a parameter",
                             "letters, digits and _, a letter first; not x, y, z, t, pi, h, "
                             "period or a function");
            }
            texts.parameters[name] = table.number(name, {-1e300, 1e300});
        }
    }
    return [texts](const Parameters& parameters) -> dsc3::Velocity {
        SpaceFormulaTexts now = texts;
        now.parameters["h"] = parameters.h;
        now.parameters["period"] = parameters.period;
        return SpaceFormulaFlow(now);
    };
}

struct Parts {
    std::string where;
    std::optional<Scene> base{};
    std::optional<dsc3::Box> domain{};
    std::vector<KnownShape> shapes{};
    std::function<dsc3::Velocity(const Parameters&)> flow{};
    bool comes_back = false;
};

// Sets the time step and the number of steps that the file gives.
void set_times(const Parts& parts, const Parameters& p, Setup& setup) {
    if ((p.dt > 0) + (p.steps > 0) + (p.period > 0) < 2) {
        throw InputError({.what = "the time step and the number of steps are not given",
                          .where = parts.where,
                          .value = "fewer than two of dt, steps and period",
                          .allowed = "two of dt, steps and period in [options]"});
    }
    setup.steps = p.steps > 0 ? p.steps : static_cast<int>(std::ceil(p.period / p.dt - 1e-9));
    setup.dt = p.dt > 0 && p.steps > 0 ? p.dt : p.period / setup.steps;
    if (setup.steps % 2 == 0 && std::abs(setup.steps * setup.dt - p.period) < 1e-9 * p.period) {
        setup.half_step = setup.steps / 2;
    }
}

Setup prepare(const Parts& parts, const Parameters& p) {
    Setup setup;
    if (parts.base) {
        setup = parts.base->prepare(p);
    } else {
        set_times(parts, p, setup);
    }
    setup.domain = parts.domain.value_or(setup.domain);
    if (parts.flow) {
        setup.velocity = parts.flow(p);
    }
    if (!parts.shapes.empty()) {
        setup.shapes.clear();
        for (const KnownShape& known : parts.shapes) {
            setup.shapes.push_back(known.shape);
        }
        setup.euler_first =
            parts.shapes.size() == 1 ? parts.shapes.front().euler_characteristic : std::nullopt;
    }
    if (parts.flow || !parts.shapes.empty()) {
        setup.last = {};
    }
    if (parts.comes_back) {
        setup.last = setup.shapes.front().distance;
        setup.volume_last = parts.shapes.empty() ? setup.volume_last : parts.shapes.front().volume;
    }
    return setup;
}

} // namespace

bool is_in_space(const std::string& text, const std::filesystem::path& path) {
    const toml::table table = parse_toml(text, path);
    const auto base = table["scene"].value<std::string>();
    return (base && find_scene(*base) != nullptr) || !!table["domain"]["size"];
}

SceneFile read_scene_text(const std::string& text, const std::filesystem::path& path) {
    const toml::table table = parse_toml(text, path);
    const TableReader top(table, "", path);
    top.allow({"name", "scene", "domain", "shape", "flow", "options", "exact", "limits"});
    SceneFile file;
    Parts parts{.where = path.string()};
    if (top.has("scene")) {
        const Scene* const base = find_scene(top.text("scene"));
        if (base == nullptr) {
            top.refuse("scene", "unknown scene in three dimensions",
                       name_list(catalogue(), &Scene::name));
        }
        parts.base = *base;
        file.scene = *base;
    } else {
        file.scene.keys = {"h", "dt", "steps", "period", "integrator"};
        file.scene.defaults.h = 0;
        file.scene.defaults.dt = 0;
    }
    file.scene.name = read_name(top);
    read_options(top, file.scene.keys, file.scene.defaults);
    if (top.has("domain")) {
        parts.domain = domain_of(top.table("domain"));
    }
    for (const TableReader& shape : top.tables("shape")) {
        parts.shapes.push_back(shape_of(shape));
        if (shape.has("file")) {
            file.files.push_back((path.parent_path() / shape.text("file")).string());
        }
    }
    if (top.has("flow")) {
        parts.flow = flow_of(top.table("flow"));
    }
    if (!parts.base && (parts.shapes.empty() || !parts.flow)) {
        top.refuse("", "the scene has no shape or no flow", "[shape] and [flow]");
    }
    if (top.has("exact")) {
        const TableReader exact = top.table("exact");
        exact.allow({"back"});
        parts.comes_back = exact.flag_or(false, "back");
        if (!parts.comes_back || parts.shapes.size() > 1) {
            exact.refuse("back", "bad value", "true, for a scene of one shape");
        }
    }
    file.scene.prepare = [parts = std::move(parts)](const Parameters& p) {
        return prepare(parts, p);
    };
    const Setup setup =
        file.scene.prepare(file.scene.defaults); // finds errors now, not at the start of the run
    if (top.has("limits")) {
        std::vector<std::string> names;
        for (const auto& [name, value] : figures({})) {
            names.push_back(name);
        }
        file.limits = read_limits(top.table("limits"), names);
        for (const FigureLimit& limit : file.limits) {
            const bool needs_shape =
                limit.figure.starts_with("sd_rel") || limit.figure.starts_with("vertex_error");
            if ((needs_shape && !setup.last) ||
                (limit.figure == "sd_rel_half" && !setup.half_step)) {
                top.table("limits").refuse(limit.figure, "the run does not measure this figure",
                                           "figures that the run measures");
            }
        }
    }
    return file;
}

} // namespace dsc::scenes::space
