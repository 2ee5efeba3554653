// SPDX-License-Identifier: MIT
#include "scenes/file/scene_file.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/families.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/flow_source.h"
#include "scenes/file/fluid_source.h"
#include "scenes/file/scene_parts.h"
#include "scenes/file/text_file.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

namespace {

constexpr double max_edges_of_side = 1e5;
/// About a gigabyte, so that a scene file with a wrong unit does not exhaust the memory.
constexpr double max_triangles_of_file = 2e7;

/// The tables of the file, read and checked, from which a setup is made for given parameters.
struct SceneParts {
    std::string where;
    std::optional<Scene> base{};
    std::optional<Rectangle> domain{};
    std::vector<DomainOutline> domain_outline{}; ///< in place of the rectangle
    bool is_clamped = false;
    std::vector<ShapeSource> shapes{};
    std::vector<CurveSource> curves{};
    std::shared_ptr<const LabelImage> labels{};
    FlowSource flow{};
    std::vector<Phase> advected{};
    std::optional<CurvatureMotion> curvature{};
    std::optional<Growth> growth{};
    std::optional<FluidMotion> fluid{};
    std::optional<ExactSource> exact{};
    std::function<SizeOptions<double>(const Parameters&)> sizes{};
    std::optional<Phase> measured{};
    bool is_measured = true; ///< against the exact shape

    [[nodiscard]] bool has_shape_and_motion_of_base() const {
        return base && shapes.empty() && curves.empty() && !labels && !flow && !curvature &&
               !growth && !fluid && advected.empty();
    }
};

// A setup with the time step and the number of steps that the file gives.
Setup scheduled_by(const SceneParts& parts, const Parameters& p) {
    if ((p.dt > 0) + (p.steps > 0) + (p.period > 0) < 2) {
        throw InputError({.what = "the time step and the number of steps are not given",
                          .where = parts.where,
                          .value = p.dt > 0       ? "dt alone"
                                   : p.steps > 0  ? "steps alone"
                                   : p.period > 0 ? "period alone"
                                                  : "none of dt, steps and period",
                          .allowed = "two of dt, steps and period in [options]"});
    }
    Setup setup = scheduled(p, p.period, 0);
    const bool ends_with_period = std::abs(setup.steps * setup.dt - p.period) < 1e-9 * p.period;
    if (setup.steps % 2 == 0 && ends_with_period) {
        setup.half_step = setup.steps / 2;
    }
    return setup;
}

void check_size(const SceneParts& parts, double h, const Setup& setup) {
    const Point<double> size = setup.domain.high - setup.domain.low;
    const double triangles = 4 / std::sqrt(3.0) * size.prod() / (h * h);
    require(size.maxCoeff() / h <= max_edges_of_side && triangles <= max_triangles_of_file,
            parts.where + ": edge length", h,
            "at most 100000 edges along a side, and 20000000 triangles");
}

// Sets the polygon; the result are its edges with the names of their sides.
std::vector<DomainEdge> set_domain_outline(const std::vector<DomainOutline>& outlines, double h,
                                           Setup& setup) {
    std::vector<Outline> rings;
    std::vector<DomainEdge> edges;
    for (const auto& [source, sides, where] : outlines) {
        std::size_t k = 0;
        for (const Piece& ring : source.pieces(h)) {
            rings.push_back(ring.points);
            for (std::size_t i = 0; i < ring.points.size(); ++i, ++k) {
                edges.push_back({ring.points[i], ring.points[(i + 1) % ring.points.size()],
                                 sides.empty()       ? std::string()
                                 : sides.size() == 1 ? sides[0]
                                                     : sides[std::min(k, sides.size() - 1)]});
            }
        }
        if (sides.size() > 1 && sides.size() != k) {
            throw InputError(
                {.what = "not one name for each edge of an outline of the domain",
                 .where = where,
                 .value = std::to_string(sides.size()) + " names, " + std::to_string(k) + " edges",
                 .allowed = "one name for all edges, or one for each"});
        }
    }
    setup.domain = {rings.at(0).at(0), rings.at(0).at(0)};
    for (const Outline& ring : rings) {
        for (const Point<double>& p : ring) {
            setup.domain = {setup.domain.low.cwiseMin(p), setup.domain.high.cwiseMax(p)};
        }
    }
    setup.polygon = Polygon{rings.at(0), {rings.begin() + 1, rings.end()}};
    return edges;
}

// The names of the sides, each once.
std::vector<std::string> names_of_sides(const std::vector<DomainOutline>& outlines) {
    std::vector<std::string> names;
    for (const DomainOutline& outline : outlines) {
        for (const std::string& name : outline.sides) {
            if (!name.empty() && std::ranges::find(names, name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

// Sets the motion of the interface, which must be exactly one.
void set_motion(const SceneParts& parts, const Parameters& p, Setup& setup) {
    if (!parts.flow && !parts.curvature && !parts.growth && !parts.fluid) {
        if (!parts.base) {
            setup.flow = steady(Translation{});
        }
        return;
    }
    setup.flow = parts.flow ? parts.flow(p) : Flow{};
    setup.advected.clear();
    setup.curvature = parts.curvature;
    setup.growth = parts.growth;
    setup.fluid = parts.fluid;
}

Setup prepare(const SceneParts& parts, const Parameters& p) {
    if (parts.base) {
        check_grains(*parts.base, p, parts.where);
    }
    Setup setup = parts.base ? parts.base->prepare(p) : scheduled_by(parts, p);
    setup.domain = parts.domain.value_or(setup.domain);
    const bool is_polygon = !parts.domain_outline.empty();
    const std::vector<DomainEdge> edges = is_polygon
                                              ? set_domain_outline(parts.domain_outline, p.h, setup)
                                              : std::vector<DomainEdge>();
    setup.clamped = parts.domain || is_polygon ? parts.is_clamped : setup.clamped;
    check_size(parts, p.h, setup);
    if (!parts.shapes.empty() || !parts.curves.empty() || parts.labels) {
        setup.outlines.clear();
        setup.phases.clear();
        setup.curves.clear();
        setup.measured.reset();
        setup.labels = parts.labels;
        add_shapes(parts.shapes, p.h, setup);
        add_curves(parts.curves, p.h, setup);
    }
    if (setup.polygon && (setup.labels || !setup.curves.empty())) {
        throw InputError({.what = "curves or labels in a domain that is no rectangle",
                          .where = parts.where + ": domain.outline",
                          .value = setup.labels ? "labels" : "curves",
                          .allowed = "shapes, which are clipped at the domain boundary"});
    }
    set_motion(parts, p, setup);
    if (parts.fluid) {
        setup.fluid->options.domain_edges = edges;
    }
    setup.advected = parts.advected.empty() ? setup.advected : parts.advected;
    setup.measured = parts.measured ? parts.measured : setup.measured;
    if (parts.sizes) {
        setup.sizes = parts.sizes(p);
    }
    if (parts.exact) {
        set_exact(*parts.exact, parts.shapes, p.period, p.h, setup);
    }
    if (!parts.is_measured || !(parts.exact || parts.has_shape_and_motion_of_base())) {
        setup.exact = {};
    }
    return setup;
}

void read_geometry(const TableReader& top, SceneParts& parts) {
    if (top.has("domain")) {
        const TableReader domain = top.table("domain");
        if (domain.has("outline")) {
            parts.domain_outline = read_domain_outline(domain);
        } else {
            parts.domain = read_domain(domain);
        }
        parts.is_clamped = domain.flag_or(false, "clamped");
    }
    const std::vector<TableReader> shapes = top.tables("shape");
    for (const TableReader& shape : shapes) {
        if (!shape.has("labels")) {
            parts.shapes.push_back(read_shape(shape));
        } else if (shapes.size() > 1 || top.has("curve") || top.has("exact")) {
            shape.refuse("labels", "a scene with a label image has no other shapes or curves",
                         "one [shape], without [[curve]] and [exact]");
        } else {
            parts.labels = read_label_image(shape);
        }
    }
    for (const TableReader& curve : top.tables("curve")) {
        parts.curves.push_back(read_curve(curve));
    }
    if (!parts.shapes.empty() && !parts.curves.empty()) {
        top.refuse("curve", "a scene has both shapes and curves",
                   "either; a shape can be given as a closed curve");
    }
}

void read_motion(const TableReader& top, SceneParts& parts) {
    const std::vector<std::string> kinds{"flow", "curvature", "growth", "fluid"};
    for (const DomainOutline& outline : parts.domain_outline) {
        if (!outline.sides.empty() && !top.has("fluid")) {
            throw InputError({.what = "sides have names, but no fluid has conditions on them",
                              .where = outline.where,
                              .value = name_list(outline.sides),
                              .allowed = "a [fluid], or an outline without sides"});
        }
    }
    if (std::ranges::none_of(kinds, [&](const std::string& kind) { return top.has(kind); })) {
        return;
    }
    const std::string kind = top.one_of(kinds);
    if (kind == "flow") {
        const std::vector<TableReader> legs = top.tables("flow");
        if (legs.empty()) {
            top.refuse("flow", "bad value", "a table");
        }
        parts.flow = read_flow(legs);
    } else if (kind == "curvature") {
        parts.curvature = read_curvature(top.table("curvature"));
    } else if (kind == "fluid") {
        parts.fluid = FluidMotion{
            .options = read_fluid(top.table("fluid"), names_of_sides(parts.domain_outline))};
    } else {
        parts.growth = read_growth(top.table("growth"));
    }
}

// Reads the options of the mesh.
void read_remeshing(const TableReader& top, SceneParts& parts) {
    if (top.has("advected")) {
        parts.advected = top.phases("advected");
    }
    if (top.has("sizes")) {
        parts.sizes = read_sizes(top.table("sizes"));
    }
}

std::optional<Scene> read_base(const TableReader& top, const std::vector<Scene>& scenes) {
    if (!top.has("scene")) {
        return std::nullopt;
    }
    const std::string name = top.text("scene");
    const auto found = std::ranges::find(scenes, name, &Scene::name);
    if (found == scenes.end()) {
        top.refuse("scene", "unknown scene", name_list(scenes, &Scene::name));
    }
    return *found;
}

} // namespace

SceneFile read_scene_text(const std::string& text, const std::filesystem::path& path,
                          const std::vector<Scene>& scenes) {
    const toml::table table = parse_toml(text, path);
    const TableReader top(table, "", path);
    top.allow({"name", "scene", "domain", "shape", "curve", "flow", "curvature", "growth", "fluid",
               "advected", "options", "sizes", "exact", "measure", "limits"});
    SceneFile file;
    SceneParts parts{.where = path.string(), .base = read_base(top, scenes)};
    file.scene = parts.base.value_or(Scene{});
    file.scene.name = read_name(top);
    if (!parts.base) {
        file.scene.keys.emplace_back("period");
        file.scene.defaults.h = 0;
        file.scene.defaults.dt = 0;
    }
    read_options(top, file.scene.keys, file.scene.defaults);
    read_geometry(top, parts);
    std::vector<TableReader> sources = top.tables("shape");
    std::ranges::copy(top.tables("curve"), std::back_inserter(sources));
    if (!parts.domain_outline.empty()) {
        std::ranges::copy(top.table("domain").tables("outline"), std::back_inserter(sources));
    }
    for (const TableReader& source : sources) {
        for (const char* key : {"file", "labels"}) {
            if (source.has(key)) {
                file.outlines.push_back((path.parent_path() / source.text(key)).string());
            }
        }
    }
    read_motion(top, parts);
    read_remeshing(top, parts);
    if (top.has("exact")) {
        parts.exact = read_exact(top.table("exact"));
    }
    if (top.has("measure")) {
        const TableReader measure = top.table("measure");
        measure.allow({"phase", "shape"});
        if (measure.has("phase")) {
            parts.measured = measure.phase("phase", 1);
        }
        parts.is_measured = measure.flag_or(true, "shape");
    }
    if (top.has("limits")) {
        file.limits = read_limits(top.table("limits"));
    }
    file.scene.prepare = [parts = std::move(parts)](const Parameters& p) {
        return prepare(parts, p);
    };
    // Finds errors that involve several tables now, not at the start of the run.
    check_measured(file.limits, file.scene.prepare(file.scene.defaults));
    return file;
}

SceneFile read_scene_file(const std::filesystem::path& path, const std::vector<Scene>& scenes) {
    return read_scene_text(read_text_file(path), path, scenes);
}

bool is_scene_file(const std::string& name) {
    return name.find('/') != std::string::npos || name.ends_with(".toml");
}

} // namespace dsc::scenes
