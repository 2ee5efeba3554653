// SPDX-License-Identifier: MIT
// dsc_verify list
// dsc_verify run [CHECK]... [SCENE_FILE]... [--limits FILE] [--out DIR]
// dsc_verify propose SCENE|SCENE_FILE [--orders N] [--out FILE [--overwrite]]
// Exit: 0 all limits hold; 1 one is broken, or the results could not be written; 2 bad usage.
#include "own_scenes.h"
#include "place.h"
#include "propose.h"
#include "report.h"

#include "dsc/base/error.h"
#include "scenes/command_line/command_line.h"
#include "scenes/output/write_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <optional>

namespace {

using namespace dsc::gate;

struct Arguments {
    std::vector<std::string> words; ///< names of checks, and scene files
    std::optional<std::string> limits;
    std::string out = "dsc_verify_out";
};

void list_checks() {
    for (const Check& check : all_checks()) {
        std::cout << std::left << std::setw(30) << check.name << check.description << "; scenes:";
        for (const auto& scene : check.scenes) {
            std::cout << ' ' << scene;
        }
        std::cout << '\n';
    }
}

// Checked before anything runs. Permissions alone are not enough: the disk may be read-only or
// full.
void prepare_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path probe = std::filesystem::path(folder) / "verify.json.part";
    bool good = !folder.empty() && !error;
    if (good) {
        std::ofstream stream(probe);
        stream << "probe";
        stream.close();
        good = static_cast<bool>(stream);
        std::filesystem::remove(probe, error);
    }
    if (!good) {
        throw dsc::InputError({.what = "cannot write to this folder",
                               .where = "--out",
                               .value = "'" + folder + "'",
                               .allowed = "a folder with permission to write, and room"});
    }
}

// Where they were installed beside this program, or else in the source tree.
std::string limits_of_catalogue() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto installed = program.parent_path().parent_path() / "share/dsc/limits.json";
    return std::filesystem::exists(installed, error) ? installed.string() : DSC_LIMITS_FILE;
}

std::vector<const Check*> pointers(const std::vector<Check>& checks) {
    std::vector<const Check*> all;
    for (const Check& check : checks) {
        all.push_back(&check);
    }
    return all;
}

// The checks of the catalogue's scenes.
std::vector<Task> tasks_of_catalogue(const std::vector<std::string>& names, const Limits& limits) {
    std::vector<Task> tasks;
    for (const Check* check : select_checks(pointers(all_checks()), names)) {
        for (const std::string& scene : check->scenes) {
            tasks.push_back({check, scene});
        }
    }
    check_limits(tasks, limits);
    check_all_read({}, limits);
    return tasks;
}

// Those of scene files. `own` keeps the checks of their [limits].
std::vector<Task> tasks_of_own(const std::vector<std::string>& names,
                               const std::vector<dsc::scenes::SceneFile>& files,
                               bool has_limits_file, Limits& limits, std::vector<Check>& own) {
    own = checks_of_files(files, limits);
    std::vector<const Check*> checks = pointers(own);
    std::ranges::copy(pointers(scene_checks()), std::back_inserter(checks));
    check_has_limits(files, limits, has_limits_file);
    check_all_read(tasks_of_files(checks, files, limits), limits);
    std::vector<Task> tasks = tasks_of_files(select_checks(checks, names), files, limits);
    if (tasks.empty()) {
        throw dsc::InputError({.what = "no limit of these checks",
                               .where = "run",
                               .value = names.front(),
                               .allowed = "checks for which the scene has a limit"});
    }
    return tasks;
}

// Where a limit is broken, for as many as anybody will look at.
void find_places(std::vector<Row>& rows, const Runs& runs, const std::filesystem::path& folder) {
    constexpr int most_places = 20;
    int places = 0;
    for (Row& row : rows) {
        if (row.pass || ++places > most_places) {
            continue;
        }
        try {
            row.place = find_place(row, runs, folder);
        } catch (const std::exception& error) { // the row has failed in any case
            row.place.what = std::string("not found: ") + error.what();
        }
    }
}

int run(const Arguments& arguments) {
    std::vector<std::string> names;
    std::vector<std::string> paths;
    for (const std::string& word : arguments.words) {
        (dsc::scenes::is_scene_file(word) ? paths : names).push_back(word);
    }
    Runs runs(read_scenes(paths));
    const bool is_own = !paths.empty();
    Limits limits =
        is_own && !arguments.limits
            ? Limits("[limits]")
            : Limits::read(arguments.limits ? *arguments.limits : limits_of_catalogue());
    std::vector<Check> own;
    const std::vector<Task> tasks =
        is_own ? tasks_of_own(names, runs.files(), arguments.limits.has_value(), limits, own)
               : tasks_of_catalogue(names, limits);
    prepare_folder(arguments.out);

    std::vector<Row> rows;
    print_heading(std::cout);
    for (const Task& task : tasks) {
        rows.push_back(judge(*task.check, task.scene, limits, runs));
        print_row(std::cout, rows.back());
    }
    const auto failed =
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.pass; });
    find_places(rows, runs, std::filesystem::path(arguments.out) / "failures");
    for (const Row& row : rows) {
        if (!row.pass) {
            print_failure(std::cout, row, limits);
        }
    }
    std::cout << rows.size() << " limits, " << failed << " broken\n";
    try {
        const std::filesystem::path folder(arguments.out);
        dsc::scenes::write_file((folder / "verify.json").string(), to_json(rows, limits, runs));
        dsc::scenes::write_file((folder / "verify.xml").string(), to_junit(rows, limits));
    } catch (const dsc::FileError& error) {
        std::cerr << "dsc_verify: " << error.what() << '\n';
        return 1; // not 2: everything was run
    }
    return failed == 0 ? 0 : 1;
}

struct Proposal {
    std::string scene;
    std::string out = "limits.json";
    int orders = 51; ///< that of the scene and fifty others
    bool overwrite = false;
};

int write_proposal(const Proposal& proposal) {
    const bool is_file = dsc::scenes::is_scene_file(proposal.scene);
    const dsc::scenes::SceneFile file =
        is_file ? dsc::scenes::read_scene_file(proposal.scene) : Runs().find(proposal.scene);
    if (std::filesystem::exists(proposal.out) && !proposal.overwrite) {
        throw dsc::InputError({.what = "there is such a file",
                               .where = "--out",
                               .value = "'" + proposal.out + "'",
                               .allowed = "another name, or --overwrite"});
    }
    dsc::scenes::check_writable(proposal.out, "--out");
    const std::vector<Band> bands = propose(file, proposal.orders);
    print_bands(std::cout, bands);
    dsc::scenes::write_file(proposal.out, to_limits(file.scene.name, bands));
    std::cout << "written: " << proposal.out << "; look at each limit before you commit it\n";
    return 0;
}

// A file that cannot be read is bad usage.
int unless_unreadable(const std::function<int()>& call) {
    try {
        return call();
    } catch (const dsc::FileError& error) {
        std::cerr << "dsc_verify: " << error.what() << '\n';
        return 2;
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Runs scenes and compares what they measure with limits."};
    app.require_subcommand(1);
    app.add_subcommand("list", "all checks and their scenes");
    auto* run_command = app.add_subcommand("run", "run all checks, or those that are named; of the "
                                                  "catalogue's scenes, or of scene files");
    Arguments arguments;
    run_command->add_option("checks", arguments.words,
                            "names from the list, and scene files (with a slash or ending in "
                            ".toml), which have [limits] or are named in the limits file");
    run_command->add_option(
        "--limits", arguments.limits,
        "the limits file (default: that of the catalogue; of scene files, their "
        "[limits] alone)");
    run_command->add_option("--out", arguments.out,
                            "folder for verify.json and verify.xml (default dsc_verify_out)");
    auto* propose_command = app.add_subcommand(
        "propose", "measure a scene in shuffled orders, and write limits to look at");
    Proposal proposal;
    propose_command->add_option("scene", proposal.scene, "a name of the catalogue, or a scene file")
        ->required();
    propose_command
        ->add_option(
            "--orders", proposal.orders,
            "in which the interface is taken (default 51: that of the scene and fifty others)")
        ->check(CLI::Range(2, 10000));
    propose_command->add_option("--out", proposal.out, "the limits file (default limits.json)");
    propose_command->add_flag("--overwrite", proposal.overwrite, "if there is such a file");
    const auto list = [] {
        list_checks();
        return 0;
    };
    return dsc::scenes::call_command(
        app, "dsc_verify", argc, argv,
        {{"list", list},
         {"run", [&] { return unless_unreadable([&] { return run(arguments); }); }},
         {"propose", [&] { return unless_unreadable([&] { return write_proposal(proposal); }); }}});
}
