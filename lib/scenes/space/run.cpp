// SPDX-License-Identifier: MIT
#include "scenes/space/run.h"

#include "dsc3/dsc3.h"
#include "scenes/keys.h"
#include "scenes/output/machine.h"
#include "scenes/run/clock.h"
#include "scenes/space/measure.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace dsc::scenes::space {

namespace {

void add(dsc3::StepReport& sum, const dsc3::StepReport& step) {
    sum.sub_steps += step.sub_steps;
    sum.passes += step.passes;
    sum.unreached += step.unreached;
    sum.held += step.held;
    sum.unjammed += step.unjammed;
    sum.moves += step.moves;
    sum.gave_up = step.gave_up;
    sum.operations += step.operations;
}

void measure_end(const dsc3::Complex& complex, const Setup& setup, RunResult& result) {
    result.tets_last = complex.tet_count();
    result.volume_last = dsc3::phase_volume(complex, 1);
    result.volume_exact_last = setup.volume_last;
    result.sd_rel_last = volume_between(complex, setup.last) / setup.volume_last;
    const VertexErrors errors = vertex_errors(complex, setup.last);
    result.interface_vertices_last = errors.vertices;
    result.vertex_error_rms = errors.rms;
    result.vertex_error_max = errors.largest;
    result.problem = dsc3::validate(complex).problem;
    result.mesh_hash = dsc3::mesh_hash(complex);
}

} // namespace

RunResult run_scene(const Scene& scene, const Parameters& parameters, const FramePlan& plan,
                    const std::atomic<bool>& interrupted) {
    const Setup setup = scene.prepare(parameters);
    scenes::Setup times;
    times.steps = setup.steps;
    times.dt = setup.dt;
    times.half_step = setup.half_step;
    Frames frames(plan, scene.name, times);
    dsc3::Complex complex =
        dsc3::initial_complex(setup.domain, {{setup.shape, 1}}, {.edge_length = parameters.h});
    dsc3::Options options;
    options.edge_length = parameters.h;
    const auto integrator = value_in(integrator_names, to_string(parameters.integrator));
    if (!integrator) {
        throw InputError({.what = "no such integrator in three dimensions",
                          .where = "integrator",
                          .value = std::string(to_string(parameters.integrator)),
                          .allowed = names_in(integrator_names)});
    }
    options.integrator = *integrator;
    dsc3::Simulation simulation(complex, options);
    RunResult result;
    result.scene = scene.name;
    result.parameters = parameters;
    result.keys = scene.keys;
    result.tets_first = complex.tet_count();
    result.volume_first = dsc3::phase_volume(complex, 1);
    const auto write_frame = [&] {
        if (frames.is_due(result.steps)) {
            const std::string path = frames.enter(result.steps, result.steps * setup.dt);
            dsc3::write_vtu(complex, path + ".vtu");
            dsc3::write_ply(complex, path + ".ply");
        }
    };
    write_frame();
    std::vector<double> step_times;
    while (result.steps < setup.steps && !interrupted.load() &&
           result.sum.gave_up == dsc3::GiveUp::none) {
        const Stopwatch watch;
        const dsc3::StepReport step =
            simulation.step(setup.velocity, result.steps * setup.dt, setup.dt);
        step_times.push_back(watch.wall());
        result.wall_s += step_times.back();
        result.cpu_s += watch.cpu();
        ++result.steps;
        add(result.sum, step);
        result.tet_steps += complex.tet_count();
        result.interface_vertices_most =
            std::max(result.interface_vertices_most, step.interface_vertices);
        const dsc3::MeshQuality now = dsc3::mesh_quality(complex);
        dsc3::MeshQuality& ever = result.quality_ever;
        ever = {std::min(ever.worst, now.worst), std::min(ever.min_dihedral, now.min_dihedral),
                std::max(ever.max_dihedral, now.max_dihedral),
                std::min(ever.min_face_angle, now.min_face_angle)};
        result.quality_last = now;
        result.inverted += now.worst > 0 ? 0U : 1U;
        write_frame();
        if (setup.half_step == result.steps) {
            result.sd_rel_half =
                volume_between(complex, setup, result.steps * setup.dt) / setup.volume_last;
        }
    }
    frames.finish({});
    result.interrupted = result.steps < setup.steps && interrupted.load();
    if (!step_times.empty()) {
        result.first_step_us = 1e6 * step_times.front();
        std::sort(step_times.begin(), step_times.end());
        result.step_us_median = 1e6 * step_times[step_times.size() / 2];
    }
    measure_end(complex, setup, result);
    return result;
}

std::string to_json(const RunResult& r) {
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(r.mesh_hash));
    nlohmann::ordered_json parameters;
    for (const Key& key : parameter_keys()) {
        if (std::find(r.keys.begin(), r.keys.end(), key.name) != r.keys.end()) {
            std::visit([&](const auto& value) { parameters[key.name] = value; },
                       key.value(r.parameters));
        }
    }
    const dsc3::OperationCounts& done = r.sum.operations;
    const nlohmann::ordered_json json{
        {"scene", r.scene},
        {"parameters", parameters},
        {"steps", r.steps},
        {"partial", r.interrupted || r.sum.gave_up != dsc3::GiveUp::none},
        {"tets_first", r.tets_first},
        {"tets_last", r.tets_last},
        {"interface_vertices_last", r.interface_vertices_last},
        {"interface_vertices_most", r.interface_vertices_most},
        {"volume_first", r.volume_first},
        {"volume_last", r.volume_last},
        {"volume_exact_last", r.volume_exact_last},
        {"volume_ratio", r.volume_last / r.volume_first},
        {"sd_rel_last", r.sd_rel_last},
        {"sd_rel_half",
         r.sd_rel_half ? nlohmann::ordered_json(*r.sd_rel_half) : nlohmann::ordered_json(nullptr)},
        {"vertex_error_rms", r.vertex_error_rms},
        {"vertex_error_max", r.vertex_error_max},
        {"min_quality_last", r.quality_last.worst},
        {"min_quality_ever", r.quality_ever.worst},
        {"min_dihedral_deg_last", r.quality_last.min_dihedral},
        {"min_dihedral_deg_ever", r.quality_ever.min_dihedral},
        {"max_dihedral_deg_ever", r.quality_ever.max_dihedral},
        {"min_face_angle_deg_ever", r.quality_ever.min_face_angle},
        {"inverted", r.inverted},
        {"problem",
         r.problem.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(r.problem)},
        {"unreached", r.sum.unreached},
        {"held", r.sum.held},
        {"unjammed", r.sum.unjammed},
        {"sub_steps", r.sum.sub_steps},
        {"passes", r.sum.passes},
        {"moves", r.sum.moves},
        {"operations",
         {{"splits", done.splits},
          {"collapses", done.collapses},
          {"edge_removals", done.edge_removals},
          {"face_flips", done.face_flips},
          {"smoothings", done.smoothings},
          {"interface_splits", done.interface_splits},
          {"interface_collapses", done.interface_collapses},
          {"interface_flips", done.interface_flips},
          {"reassigned", done.reassigned}}},
        {"cpu_s", r.cpu_s},
        {"wall_s", r.wall_s},
        {"run_s", r.wall_s},
        {"first_step_us", r.first_step_us},
        {"step_us_median", r.step_us_median},
        {"us_per_vertex_and_sub_step", 1e6 * r.cpu_s / static_cast<double>(r.sum.moves)},
        {"us_per_tet_and_step", 1e6 * r.cpu_s / static_cast<double>(r.tet_steps)},
        {"peak_memory_mb", peak_memory_mb()},
        {"threads", 1},
        {"threads_used", 1},
        {"strategy", "sequential"},
        {"mesh_hash", hash},
        {"commit", commit()},
        {"machine", machine()},
    };
    return json.dump(2) + "\n";
}

void print_summary(const RunResult& r) {
    const double h = r.parameters.h;
    std::cout << r.scene << ": " << r.steps << " steps, " << r.tets_last << " tets, "
              << r.interface_vertices_last << " interface vertices\n  volume ratio "
              << r.volume_last / r.volume_first << ", symmetric difference " << r.sd_rel_last
              << " of the volume, vertices off by " << r.vertex_error_rms / h << " h (rms), "
              << r.vertex_error_max / h << " h (most)\n  smallest dihedral angle "
              << r.quality_last.min_dihedral << " degrees (ever " << r.quality_ever.min_dihedral
              << ")\n  inverted " << r.inverted << ", unreached " << r.sum.unreached << " of "
              << r.sum.moves << "\n  " << r.step_us_median << " us a step (median), " << r.cpu_s
              << " s CPU, " << peak_memory_mb() << " MB\n";
    if (!r.problem.empty()) {
        std::cout << "  the mesh is not valid: " << r.problem << '\n';
    }
}

} // namespace dsc::scenes::space
