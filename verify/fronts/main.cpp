// SPDX-License-Identifier: MIT
// dsc_fronts [--discs N] [--seed S]... [--edge-length H]... [--step S] [--contact C] [--threads N]
// How exactly fronts meet: a line of JSON for each seed and edge length.
// Exit: 0 done; 2 bad usage.
#include "fronts/johnson_mehl.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>

namespace {

using namespace dsc::fronts;

std::string to_json(const Case& one, const Result& r) {
    const double h = one.h;
    return nlohmann::ordered_json{{"discs", one.number},
                                  {"seed", one.seed},
                                  {"h", h},
                                  {"step", one.step},
                                  {"contact", one.contact},
                                  {"threads", one.threads},
                                  {"time", r.time},
                                  {"is_full", r.is_full},
                                  {"is_valid", r.is_valid},
                                  {"wrong_area", r.last.wrong_area},
                                  {"wrong_area_h2", r.last.wrong_area / (h * h)},
                                  {"phase_error", r.last.phase_error},
                                  {"seam_max_h", r.last.seam_max / h},
                                  {"seam_rms_h", r.last.seam_rms / h},
                                  {"triple_max_h", r.last.triple_max / h},
                                  {"triples", r.last.triples},
                                  {"events", r.events},
                                  {"unreached", r.unreached},
                                  {"min_angle_deg_last", r.min_angle_last},
                                  {"min_angle_deg_ever", r.min_angle_ever},
                                  {"seconds", r.seconds},
                                  {"mesh_hash", r.mesh_hash}}
        .dump();
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"How exactly fronts meet: discs that grow until the unit square is full."};
    Case one;
    std::vector<std::uint64_t> seeds{0};
    std::vector<double> lengths{0.02};
    app.add_option("--discs", one.number, "number of discs")->check(CLI::Range(2, 200));
    app.add_option("--seed", seeds,
                   "seeds of the discs' places; 0: two or three discs at fixed places");
    app.add_option("--edge-length", lengths)->check(CLI::Range(0.001, 0.05));
    app.add_option("--step", one.step, "in edge lengths")->check(CLI::Range(0.01, 10.0));
    app.add_option("--contact", one.contact, "contact distance in edge lengths; 0: the default")
        ->check(CLI::Range(0.0, 10.0));
    app.add_option("--threads", one.threads)->check(CLI::Range(1, 64));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    for (const double h : lengths) {
        for (const std::uint64_t seed : seeds) {
            one.h = h;
            one.seed = seed;
            std::cout << to_json(one, run(one)) << std::endl;
        }
    }
}
