// SPDX-License-Identifier: MIT
// The results of a run: as figures for limits, as JSON, and in words.
#include "scenes/space/run.h"

#include "dsc/base/names.h"
#include "dsc3/dsc3.h"
#include "scenes/keys.h"
#include "scenes/output/machine.h"
#include "scenes/run/clock.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <limits>

namespace dsc::scenes::space {

namespace {

template <class Number>
nlohmann::ordered_json number_or_null(const std::optional<Number>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

} // namespace

std::string strategy_of(const RunResult& result) {
    return result.parallel ? std::string(name_in(dsc3::division_names, result.parallel->division))
                           : "sequential";
}

std::map<std::string, double> figures(const RunResult& r) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double h = r.parameters.h;
    return {{"tets_last", r.tets_last},
            {"volume_ratio", r.volume_last / r.volume_first},
            {"sd_rel_last", r.sd_rel_last.value_or(none)},
            {"sd_rel_half", r.sd_rel_half.value_or(none)},
            {"vertex_error_rms_h", r.vertex_error_rms.value_or(none) / h},
            {"vertex_error_max_h", r.vertex_error_max.value_or(none) / h},
            {"min_quality_last", r.quality_last.worst},
            {"min_quality_ever", r.quality_ever.worst},
            {"min_dihedral_deg_last", r.quality_last.min_dihedral},
            {"min_dihedral_deg_ever", r.quality_ever.min_dihedral},
            {"inverted", static_cast<double>(r.inverted)},
            {"unreached", static_cast<double>(r.sum.unreached)},
            {"held", static_cast<double>(r.sum.held)}};
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
        {"interface_vertices_max", r.interface_vertices_max},
        {"volume_first", r.volume_first},
        {"euler_characteristic_first", number_or_null(r.euler_first)},
        {"euler_characteristic_exact_first", number_or_null(r.euler_exact_first)},
        {"volume_last", r.volume_last},
        {"volume_exact_last", r.volume_exact_last},
        {"volume_ratio", r.volume_last / r.volume_first},
        {"sd_rel_last", number_or_null(r.sd_rel_last)},
        {"sd_rel_half", number_or_null(r.sd_rel_half)},
        {"vertex_error_rms", number_or_null(r.vertex_error_rms)},
        {"vertex_error_max", number_or_null(r.vertex_error_max)},
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
        {"treated", r.sum.treated},
        {"treated_together", r.sum.treated_together},
        {"strata_last",
         {{"sheet", r.strata_last.sheet},
          {"curve", r.strata_last.curve},
          {"point", r.strata_last.point}}},
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
        {"threads", r.parallel ? r.parallel->threads : 1},
        {"threads_used", r.parallel ? r.parallel->threads : 1},
        {"strategy", strategy_of(r)},
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
              << r.volume_last / r.volume_first;
    if (r.sd_rel_last) {
        std::cout << ", symmetric difference " << *r.sd_rel_last
                  << " of the volume, vertices off by " << *r.vertex_error_rms / h << " h (rms), "
                  << *r.vertex_error_max / h << " h (most)";
    }
    if (r.euler_first != r.euler_exact_first) {
        std::cout << "\n  the first mesh does not resolve the surface in the file: Euler number "
                  << *r.euler_first << ", not " << *r.euler_exact_first
                  << "; a smaller h does (several edges across its thinnest part)";
    }
    std::cout << "\n  smallest dihedral angle " << r.quality_last.min_dihedral << " degrees (ever "
              << r.quality_ever.min_dihedral << ")\n  inverted " << r.inverted << ", unreached "
              << r.sum.unreached << " of " << r.sum.moves << "\n  " << r.step_us_median
              << " us a step (median), " << r.cpu_s << " s CPU, " << peak_memory_mb() << " MB\n";
    if (!r.problem.empty()) {
        std::cout << "  the mesh is not valid: " << r.problem << '\n';
    }
}

} // namespace dsc::scenes::space
