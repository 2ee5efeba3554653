// SPDX-License-Identifier: MIT
// dsc_scene list
// dsc_scene run SCENE [--set key=value]... [--strategy S] [--submeshes M] [--threads N]
//                     [--frames DIR] [--json FILE]
// Exit: 0 done; 1 the run broke an invariant or could not write its results; 2 bad usage.
#include "dsc/base/error.h"
#include "scenes/command_line.h"
#include "scenes/run.h"
#include "scenes/write_file.h"

#include <unistd.h>

#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <optional>

namespace {

using namespace dsc::scenes;

std::atomic<bool> interrupted{false};

void on_interrupt(int) { interrupted.store(true); }

struct Arguments {
    std::string scene;
    std::vector<std::string> settings;
    std::string strategy = "sequential";
    std::string angle = "0";
    RunOptions run;
    std::optional<std::string> json;
};

void list_scenes() {
    for (const Scene& scene : catalogue()) {
        std::cout << std::left << std::setw(22) << scene.name << scene.description << " ["
                  << scene.section << "]; keys:";
        for (const auto& key : scene.keys) {
            std::cout << ' ' << key;
        }
        std::cout << '\n';
    }
}

void print_summary(const RunResult& r) {
    std::cout << r.scene << " (" << to_string(r.strategy) << ", " << r.threads << " thread"
              << (r.threads == 1 ? "" : "s") << "): " << r.steps << " steps, " << r.triangles_last
              << " triangles, " << r.interface_vertices_last << " interface vertices\n"
              << std::setprecision(8) << "  area ratio " << r.area_ratio
              << ", symmetric difference " << std::setprecision(3) << r.sd_rel_last
              << " of the area";
    if (r.sd_rel_half) {
        std::cout << " (half-way " << *r.sd_rel_half << ")";
    }
    std::cout << "\n  worst quality " << r.min_quality_last << " (ever " << r.min_quality_ever
              << "), smallest angle " << r.min_angle_deg_last << " degrees\n  inverted "
              << r.inverted << ", unreached " << r.unreached << "\n  " << r.step_us_median
              << " us a step (median), " << r.cpu_s << " s CPU, " << std::setprecision(4)
              << r.peak_memory_mb << " MB\n";
}

void parse_angle(const std::string& angle, Submeshing& submeshing) {
    if (angle == "shape") {
        submeshing.follow_shape = true;
        return;
    }
    const char* end = angle.data() + angle.size();
    const auto [stop, error] = std::from_chars(angle.data(), end, submeshing.degrees);
    if (error != std::errc{} || stop != end || !std::isfinite(submeshing.degrees)) {
        throw dsc::InputError("not a direction", "--angle", "'" + angle + "'",
                              "degrees from the x axis, or shape");
    }
}

int run(const Arguments& arguments) {
    const Scene& scene = find_scene(arguments.scene);
    Parameters parameters = scene.defaults;
    for (const std::string& setting : arguments.settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos) {
            throw dsc::InputError("not a setting", "--set", "'" + setting + "'", "key=value");
        }
        set_parameter(parameters, scene.keys, setting.substr(0, equals),
                      setting.substr(equals + 1));
    }
    RunOptions options = arguments.run;
    options.strategy = parse_strategy(arguments.strategy);
    parse_angle(arguments.angle, options.submeshing);
    options.progress = isatty(STDERR_FILENO) != 0;
    options.interrupted = &interrupted;
    if (arguments.json) {
        check_writable(*arguments.json, "--json");
    }
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);

    const RunResult result = run_scene(scene, parameters, options);
    print_summary(result);
    if (arguments.json) {
        write_file(*arguments.json, to_json(result));
    }
    if (!result.gave_up.empty()) {
        std::cerr << "dsc_scene: gave up: " << result.gave_up << '\n';
    }
    if (result.held > 0) {
        std::cerr << "dsc_scene: " << result.held
                  << " times a vertex was held, for its velocity was not finite\n";
    }
    if (result.interrupted) {
        std::cerr << "dsc_scene: interrupted after step " << result.steps << '\n';
    }
    return result.holds() && !result.interrupted ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Runs the scenes of a deformable simplicial complex and measures them."};
    app.require_subcommand(1);
    app.add_subcommand("list", "all scenes and the keys they take");
    auto* run_command = app.add_subcommand("run", "run one scene");
    Arguments arguments;
    run_command->add_option("scene", arguments.scene, "a name from the list")->required();
    run_command->add_option("--set", arguments.settings, "key=value; may be repeated")
        ->allow_extra_args(false);
    run_command->add_option("--strategy", arguments.strategy,
                            "sequential, fixed, counting, active, blocks, cells, copy or "
                            "reference");
    run_command
        ->add_option("--submeshes", arguments.run.submeshing.submeshes,
                     "default: 8 slabs, 16 blocks, or as many cells as pay")
        ->check(CLI::Range(1, 65536));
    run_command->add_option(
        "--angle", arguments.angle,
        "slabs are cut across this direction, in degrees from the x axis (default 0); "
        "shape: across the direction of the interface");
    run_command->add_option("--threads", arguments.run.submeshing.threads, "threads (default 1)")
        ->check(CLI::Range(1, 1024));
    run_command->add_option("--frames", arguments.run.frames, "folder for .vtu and .pvd files");
    run_command->add_option("--json", arguments.json, "file for the result");
    return list_or_run(app, "dsc_scene", argc, argv, list_scenes, [&] { return run(arguments); });
}
