// SPDX-License-Identifier: MIT
#include "place.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"
#include "dsc/io/pictures.h"
#include "dsc/quality/measures.h"
#include "measures/hausdorff.h"
#include "measures/interface_outlines.h"
#include "measures/jaggedness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

namespace dsc::gate {

namespace {

using Mesh = Complex<double>;

constexpr double edges_around = 8; ///< half the width of the picture, in edge lengths

struct Spot {
    std::string what;
    Point<double> at{0, 0};
};

Point<double> centre_of(const Mesh& mesh, Triangle t) {
    const auto v = mesh.vertices_of(t);
    return (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
}

// --- the culprits -------------------------------------------------------------------------------

// The triangle with the smallest value.
template <class Value>
std::optional<Spot> min_triangle(const Mesh& mesh, const std::string& what, const std::string& unit,
                                 Value value) {
    std::optional<Spot> spot;
    double min = std::numeric_limits<double>::infinity();
    for (const Triangle t : triangles(mesh)) {
        const double here = value(t);
        if (here < min) {
            min = here;
            spot = Spot{what + few_digits(here) + unit + " in triangle " + std::to_string(t.id),
                        centre_of(mesh, t)};
        }
    }
    return spot;
}

std::optional<Spot> inverted_triangle(const Mesh& mesh) {
    for (const Triangle t : triangles(mesh)) {
        const auto v = mesh.vertices_of(t);
        if (!(orientation<double>(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])) >
              0)) {
            return Spot{"triangle " + std::to_string(t.id) + " is inverted", centre_of(mesh, t)};
        }
    }
    return std::nullopt;
}

// The interface's worst place against the exact shape at this time: the largest excess turn for
// Culprit::turn, otherwise the largest distance. None if the exact shape is not known.
std::optional<Spot> against_exact(const Mesh& mesh, Culprit culprit, const scenes::Setup& setup,
                                  const scenes::Parameters& parameters, double time) {
    if (!setup.exact) {
        return std::nullopt;
    }
    const scenes::ExactShape exact = setup.exact(time);
    if (std::isnan(exact.area) || exact.outlines.empty()) {
        return std::nullopt;
    }
    if (culprit == Culprit::turn) {
        const auto polygons = scenes::interface_outlines(mesh, {.phase = setup.measured});
        const auto jaggedness = scenes::measure_jaggedness(polygons, exact.outlines);
        return Spot{"a vertex of the interface turns by " +
                        few_digits(jaggedness.largest_excess_deg) + " degrees too much",
                    jaggedness.worst};
    }
    const auto outlines = scenes::interface_outlines(
        mesh, {.reading = parameters.interface.reading, .phase = setup.measured});
    const auto distance = scenes::hausdorff(outlines, exact.outlines);
    return Spot{"the interface and the exact shape are " + few_digits(distance.distance()) +
                    " apart",
                distance.farthest};
}

std::optional<Spot> find_spot(const Mesh& mesh, Culprit culprit, const scenes::Setup& setup,
                              const scenes::Parameters& parameters, double time) {
    switch (culprit) {
    case Culprit::worst_triangle:
        return min_triangle(mesh, "quality ", "", [&](Triangle t) { return quality(mesh, t); });
    case Culprit::sharpest_corner:
        return min_triangle(mesh, "an angle of ", " degrees",
                            [&](Triangle t) { return min_angle_deg(mesh, t); });
    case Culprit::first_failure: return inverted_triangle(mesh);
    case Culprit::deviation:
    case Culprit::turn: return against_exact(mesh, culprit, setup, parameters, time);
    case Culprit::none: break;
    }
    return std::nullopt;
}

// --- what is written ----------------------------------------------------------------------------

std::string file_name(const Row& row) {
    return std::regex_replace(row.check->name + '_' + row.of->name, std::regex("[^\\w.-]"), "-");
}

// The command line of the run, with all settings that differ from the scene's defaults.
std::string command_of(const Configuration& run) {
    const scenes::Scene& scene = run.of->file.scene;
    std::string command = "dsc_scene run " + (run.of->path.empty() ? scene.name : run.of->path);
    for (const scenes::Key& key : scenes::parameter_keys()) {
        const scenes::Setting value = key.value(run.parameters);
        if (value != key.value(scene.defaults)) {
            command += " --set " + key.name + '=' + scenes::text_of(value);
        }
    }
    if (run.strategy != scenes::Strategy::sequential) {
        command += " --strategy " + scenes::to_string(run.strategy);
    }
    return run.threads == 1 ? command : command + " --threads " + std::to_string(run.threads);
}

} // namespace

Place find_place(const Row& row, const Runs& runs, const std::filesystem::path& folder) {
    Place place;
    if (!row.run) {
        return place;
    }
    const Configuration& run = *row.run;
    const scenes::Scene& scene = run.of->file.scene;
    place.command = command_of(run);
    const bool has_run = row.measured.has_value();
    const Culprit culprit = has_run ? row.check->culprit : Culprit::first_failure;
    if (culprit == Culprit::none || run.of->space || run.strategy == scenes::Strategy::reference ||
        run.parameters.real != scenes::RealType::double_precision) {
        return place;
    }
    const scenes::Setup setup = scene.prepare(run.parameters);
    const bool is_half = row.check->name.find("_half") != std::string::npos;
    const int last = is_half ? setup.half_step.value_or(setup.steps) : setup.steps;
    const auto known = runs.all().find(run.key());
    const int end = known == runs.all().end() ? last : std::min(last, known->second.result.steps);
    const std::string path = (folder / file_name(row)).string();

    std::filesystem::create_directories(folder);
    scenes::RunOptions options = run.options();
    if (culprit == Culprit::first_failure) {
        options.edits = path + ".edits";
        place.edits = options.edits;
    }
    options.measure_shape = false;
    options.stop_after = end;
    options.observer = [&](int step, const Mesh& mesh) {
        if (place.at || (culprit != Culprit::first_failure && step != end)) {
            return;
        }
        const double time = step * setup.dt;
        std::optional<Spot> spot = find_spot(mesh, culprit, setup, run.parameters, time);
        if (!spot && step == end) { // no culprit of that kind: show the worst triangle
            spot = find_spot(mesh, Culprit::worst_triangle, setup, run.parameters, time);
        }
        if (spot) {
            place.what = spot->what;
            place.at = spot->at;
            place.time = time;
            place.picture = path + ".svg";
            const double reach = edges_around * run.parameters.h;
            write_svg(mesh, place.picture,
                      {.view = Rectangle{spot->at.array() - reach, spot->at.array() + reach},
                       .title = row.check->name + ", " + row.of->name,
                       .marks = {{spot->at.x(), spot->at.y(), spot->what}}});
        }
    };
    (void)scenes::run_scene(scene, run.parameters, options);
    if (place.at) {
        place.command +=
            " --frames frames --pictures phases,edges,interface --at " + to_text(place.time);
    }
    return place;
}

} // namespace dsc::gate
