// SPDX-License-Identifier: MIT
#include "scenes/command_line/scene_program.h"

#include "dsc/base/error.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/command_line/arguments.h"
#include "scenes/command_line/command_line.h"
#include "scenes/command_line/space_program.h"
#include "scenes/file/describe.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/scene_file.h"
#include "scenes/file/text_file.h"
#include "scenes/output/machine.h"
#include "scenes/run/json.h"
#include "scenes/run/run.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

namespace dsc::scenes {

namespace {

template <class AnyScene>
void list_scenes(const std::vector<AnyScene>& scenes) {
    for (const AnyScene& scene : scenes) {
        std::cout << std::left << std::setw(22) << scene.name << scene.description << " ["
                  << scene.section << "]; keys:";
        for (const auto& key : scene.keys) {
            std::cout << ' ' << key;
        }
        std::cout << '\n';
    }
}

// Prints the number of events of each kind, if any.
void print_events(const std::vector<Event>& events) {
    std::string_view before = "\n  events: ";
    for (const auto& [kind, name] : event_names) {
        if (const auto count = std::ranges::count(events, kind, &Event::kind); count > 0) {
            std::cout << before << count << ' ' << name;
            before = ", ";
        }
    }
}

void print_forces(const Figures& fluid) {
    constexpr std::string_view x = "force_x_";
    constexpr std::string_view last = "_last";
    for (const Figure& figure : fluid) {
        const std::string& name = figure.name;
        if (name.starts_with(x)) {
            const std::string side = name.substr(x.size(), name.size() - x.size() - last.size());
            std::cout << std::setprecision(6) << "\n  force on " << side << ": "
                      << number(fluid, name) << ", " << number(fluid, "force_y_" + side + "_last")
                      << std::setprecision(3);
        }
    }
}

void print_summary(const RunResult& r) {
    std::cout << r.scene << " (" << to_string(r.strategy) << ", " << r.threads << " thread"
              << (r.threads == 1 ? "" : "s") << "): " << r.steps << " steps, " << r.triangles_last
              << " triangles, " << r.interface_vertices_last << " interface vertices\n"
              << std::setprecision(8);
    if (std::isfinite(r.area_ratio)) {
        std::cout << "  area ratio " << r.area_ratio;
    } else {
        std::cout << "  no phase to measure";
    }
    std::cout << std::setprecision(3);
    // NaN if the exact shape is unknown, as for networks.
    if (const double difference = number(r.last, "sd_rel"); std::isfinite(difference)) {
        std::cout << ", symmetric difference " << difference << " of the area";
    }
    if (r.half && std::isfinite(number(*r.half, "sd_rel"))) {
        std::cout << " (half-way " << number(*r.half, "sd_rel") << ")";
    }
    print_events(r.events);
    if (!r.fluid.empty()) {
        std::cout << "\n  largest velocity " << number(r.fluid, "largest_velocity_last");
        if (const double drift = number(r.fluid, "area_drift_last"); std::isfinite(drift)) {
            std::cout << ", area off by " << drift;
        }
        std::cout << ", solver " << number(r.fluid, "solve_s") << " s, assembly "
                  << number(r.fluid, "assembly_s") << " s, mesh " << number(r.fluid, "dsc_s")
                  << " s";
        print_forces(r.fluid);
    }
    if (!r.diagram.empty()) {
        std::cout << "\n  against the exact diagram: wrong area "
                  << number(r.diagram, "wrong_area_last") << ", seams off by up to "
                  << number(r.diagram, "seam_error_last") << ", junctions by "
                  << number(r.diagram, "junction_error_last");
    }
    for (const std::string& sentence : sentences(r.input)) {
        std::cout << "\n  " << sentence;
    }
    std::cout << "\n  worst quality " << number(r.last, "min_quality") << " (ever "
              << r.min_quality_ever << "), smallest angle " << number(r.last, "min_angle_deg")
              << " degrees\n  inverted " << r.inverted << ", unreached " << r.unreached << "\n  "
              << r.step_us_median << " us a step (median), " << r.cpu_s << " s CPU, "
              << std::setprecision(4) << r.peak_memory_mb << " MB\n";
}

// The allowed values of the keys and a description of each strategy, one line each.
std::string details() {
    std::ostringstream text;
    text << "Keys of --set (each scene takes those that `list` shows):\n" << std::left;
    for (const Key& key : parameter_keys()) {
        text << "  " << std::setw(12) << key.name << key.allowed << '\n';
    }
    text << "Strategies:\n";
    for (const StrategyEntry& strategy : strategies()) {
        text << "  " << std::setw(12) << strategy.name << strategy.description << '\n';
    }
    return text.str();
}

// With --threads alone, the strategy is `cells`. The number of cells follows from the length of the
// interface, not from the number of threads, so that the result does not depend on it.
Strategy strategy_of(const Arguments& arguments) {
    if (arguments.strategy) {
        return parse_strategy(*arguments.strategy);
    }
    return arguments.threads ? Strategy::cells : Strategy::sequential;
}

// A file that cannot be read is bad usage here: the name may be a misspelt scene.
template <class Read>
auto read_or_refuse(const std::string& name, const std::vector<Scene>& scenes, Read read) {
    try {
        return read();
    } catch (const FileError& error) {
        if (error.path() != name) {
            throw InputError({.what = "a file that the scene names",
                              .where = name,
                              .value = error.what(),
                              .allowed = "files that can be read, named from the scene's folder"});
        }
        throw InputError({.what = error.what(),
                          .where = "run",
                          .value = "'" + name + "'",
                          .allowed = "a scene file that can be read, or one of " +
                                     name_list(scenes, &Scene::name)});
    }
}

// The text of a scene file; empty for a scene of the list.
std::string text_of_scene(const std::string& name, const std::vector<Scene>& scenes) {
    if (!is_scene_file(name)) {
        if (space::find_scene(name) == nullptr) {
            (void)find_scene(name, scenes);
        }
        return {};
    }
    return read_or_refuse(name, scenes, [&] { return read_text_file(name); });
}

// The scene of a command line or a checkpoint, from the stored text.
SceneFile scene_of(const RunOrigin& origin, const std::vector<Scene>& scenes) {
    if (!is_scene_file(origin.scene)) {
        return {.scene = find_scene(origin.scene, scenes)};
    }
    return read_or_refuse(origin.scene, scenes,
                          [&] { return read_scene_text(origin.text, origin.scene, scenes); });
}

// The same in three dimensions; empty for a scene in the plane.
std::optional<space::SceneFile> scene_in_space(const RunOrigin& origin,
                                               const std::vector<Scene>& scenes) {
    if (!is_scene_file(origin.scene)) {
        const space::Scene* const scene = space::find_scene(origin.scene);
        return scene != nullptr ? std::optional(space::SceneFile{.scene = *scene}) : std::nullopt;
    }
    if (!space::is_in_space(origin.text, origin.scene)) {
        return std::nullopt;
    }
    return read_or_refuse(origin.scene, scenes,
                          [&] { return space::read_scene_text(origin.text, origin.scene); });
}

// The scene and settings of the command line.
RunOrigin origin_of(const Arguments& arguments, const std::vector<Scene>& scenes) {
    return {.scene = *arguments.scene,
            .text = text_of_scene(*arguments.scene, scenes),
            .settings = arguments.settings,
            .strategy = strategy_of(arguments),
            .submeshing = arguments.run.submeshing,
            .commit = {}};
}

void check_usage(const Arguments& arguments) {
    const auto refuse = [](const char* what, const char* where, const char* value,
                           const char* allowed) {
        throw InputError({.what = what, .where = where, .value = value, .allowed = allowed});
    };
    if (arguments.scene.has_value() == arguments.resume.has_value()) {
        refuse("run needs either a scene or a checkpoint", "run",
               arguments.resume ? "both" : "neither", "run SCENE, or run --resume FILE");
    }
    if (arguments.every && !arguments.series && !arguments.checkpoint &&
        arguments.run.frames.folder.empty()) {
        refuse("--every has no effect here", "--every", "no file that is written every N steps",
               "with --series, --frames or --checkpoint");
    }
}

int run(const std::string& program, const std::vector<Scene>& scenes, const Arguments& arguments) {
    check_usage(arguments);
    const std::optional<Checkpoint> checkpoint =
        arguments.resume ? std::optional(read_checkpoint(*arguments.resume)) : std::nullopt;
    RunOrigin origin = checkpoint ? checkpoint->origin : origin_of(arguments, scenes);
    if (checkpoint && origin.commit != commit()) {
        std::cerr << program << ": " << checkpoint->path << " was written by commit "
                  << origin.commit << ", this is " << commit()
                  << ": the result may differ in its last bits\n";
    }
    origin.commit = commit();
    origin.submeshing.threads = arguments.threads.value_or(origin.submeshing.threads);
    if (const auto file = scene_in_space(origin, scenes)) {
        return run_in_space(program, *file, arguments, origin, checkpoint);
    }
    const SceneFile file = scene_of(origin, scenes);
    check_files(arguments, origin, file.outlines);
    const Scene& scene = file.scene;
    const Parameters parameters = with_settings(scene, origin.settings);
    RunOptions options = arguments.run;
    options.strategy = origin.strategy;
    options.submeshing = origin.submeshing;
    options.progress = isatty(STDERR_FILENO) != 0;
    options.interrupted = &interrupted;
    options.series_every = arguments.series ? arguments.every.value_or(1) : 0;
    options.edits = arguments.edits.value_or("");
    options.frames.layers = arguments.pictures ? parse_layers(*arguments.pictures) : Layers{};
    options.frames.every = arguments.every.value_or(0);
    options.checkpoint = checkpoint_plan(arguments, origin);
    options.resume = checkpoint ? &*checkpoint : nullptr;
    heed_signals();

    const RunResult result = run_scene(scene, parameters, options);
    print_summary(result);
    if (arguments.json) {
        write_file(*arguments.json, to_json(result));
    }
    if (arguments.events) {
        write_file(*arguments.events, events_to_json_lines(result.events));
    }
    if (arguments.series) {
        write_file(*arguments.series, series_to_csv(result.series));
    }
    if (!result.gave_up.empty()) {
        std::cerr << program << ": gave up: " << result.gave_up << '\n';
    }
    if (result.held > 0) {
        std::cerr << program << ": " << result.held
                  << " times a vertex stayed because its velocity was not finite\n";
    }
    if (result.interrupted) {
        tell_interruption(program, arguments, result.steps);
    }
    return result.holds() && !result.interrupted ? 0 : 1;
}

} // namespace

int scene_program(const std::string& program, const std::vector<Scene>& scenes, int argc,
                  const char* const* argv) {
    CLI::App app{"Runs the scenes of a deformable simplicial complex and measures them."};
    app.require_subcommand(1);
    app.add_subcommand("list", "all scenes and their keys");
    auto* run_command = app.add_subcommand("run", "run one scene");
    run_command->footer(details());
    Arguments arguments;
    run_command->add_option(
        "scene", arguments.scene,
        "a name from the list, or a scene file: with a slash or ending in .toml");
    auto* settings =
        run_command->add_option("--set", arguments.settings, "key=value; may be repeated")
            ->allow_extra_args(false);
    auto* strategy = run_command->add_option("--strategy", arguments.strategy,
                                             name_list(strategies(), &StrategyEntry::name) +
                                                 " (default sequential, or cells with --threads)");
    auto* submeshes =
        run_command
            ->add_option("--submeshes", arguments.run.submeshing.submeshes,
                         "default: 8 slabs, 16 blocks, or cells by the length of the interface")
            ->check(CLI::Range(1, 65536));
    run_command
        ->add_option(
            "--threads", arguments.threads,
            "largest number of threads (default 1); fewer are used when more would not be faster")
        ->check(CLI::Range(1, 1024));
    auto* frames =
        run_command
            ->add_option("--frames", arguments.run.frames.folder,
                         "folder for .vtu and .pvd files: about nine frames, unless --every "
                         "or --at chooses them")
            ->check([](const std::string& folder) {
                return folder.empty() ? "got ''; allowed: a folder" : "";
            });
    run_command
        ->add_option("--at", arguments.run.frames.times,
                     "times of frames, with commas between them: each is written after the first "
                     "step that reaches it")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->needs(frames);
    run_command
        ->add_option("--pictures", arguments.pictures,
                     "draw each frame (.svg): layers with commas between them, phases or "
                     "quality, and edges, interface")
        ->needs(frames);
    auto* edits = run_command->add_option("--edits", arguments.edits,
                                          "file for the log of edits from the start of the run, "
                                          "which replays to the same mesh");
    run_command->add_option("--json", arguments.json, "file for the result");
    run_command->add_option("--events", arguments.events,
                            "file for the changes of topology, one JSON object per line");
    run_command->add_option(
        "--series", arguments.series,
        "file for the run over time: areas, errors, quality, operations, as CSV");
    run_command
        ->add_option("--every", arguments.every,
                     "steps between the rows of --series (default 1), between frames, and between "
                     "checkpoints (default: only when the run ends)")
        ->check(CLI::Range(1, 1000000000));
    run_command->add_option("--checkpoint", arguments.checkpoint,
                            "file from which --resume goes on; written when the run ends or is "
                            "interrupted");
    run_command
        ->add_option("--stop-after", arguments.run.stop_after,
                     "stop the run after this step, as an interruption does")
        ->check(CLI::Range(1, 1000000000));
    run_command
        ->add_option("--resume", arguments.resume,
                     "a checkpoint, in place of a scene: continues bitwise identically. It has the "
                     "scene, its keys and the strategy; files that a scene file names are read "
                     "again. Other outputs must be given again")
        ->excludes(settings, strategy, submeshes, edits);
    auto* describe_command =
        app.add_subcommand("describe", "print one scene as a file that can be changed and run");
    describe_command->add_option("scene", arguments.scene, "a name from the list")->required();
    describe_command->add_option("--set", arguments.settings, "key=value; may be repeated")
        ->allow_extra_args(false);
    const auto list_all = [&] {
        list_scenes(scenes);
        list_scenes(space::catalogue());
        return 0;
    };
    const auto describe_one = [&] {
        const Scene& scene = find_scene(arguments.scene.value(), scenes);
        std::cout << describe(scene, with_settings(scene, arguments.settings));
        return 0;
    };
    return call_command(app, program, argc, argv,
                        {{"list", list_all},
                         {"run", [&] { return run(program, scenes, arguments); }},
                         {"describe", describe_one}});
}

} // namespace dsc::scenes
