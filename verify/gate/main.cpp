// SPDX-License-Identifier: MIT
// dsc_verify list
// dsc_verify run [SUITE|SCENE_FILE|SCENE|CHECK]... [--only CHECK,...] [--limits SUITE]
//                [--jobs N] [--drift SHARE] [--out DIR]
// dsc_verify propose SUITE|SCENE_FILE|SCENE [CASE]... [--orders N] [--jobs N]
//                [--update | --out FILE [--overwrite]]
// Exit: 0 all limits hold; 1 one is broken, or the results could not be written; 2 bad usage.
#include "judge.h"
#include "place.h"
#include "propose.h"
#include "report.h"
#include "update.h"

#include "dsc/base/error.h"
#include "scenes/command_line/command_line.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/text_file.h"
#include "scenes/name_list.h"
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
    std::vector<std::string> words; ///< suites, scene files, scenes, checks
    std::vector<std::string> only;
    std::optional<std::string> limits;
    std::optional<double> drift;
    std::string out = "dsc_verify_out";
    int jobs = 1;
};

/// What a command line asks for.
struct Chosen {
    Cases cases;
    std::vector<std::string> suites; ///< and scene files
    std::vector<std::string> only;
};

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

// They are installed beside this program, and a build has a link to them there.
std::vector<std::string> our_suites() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto folder = program.parent_path().parent_path() / "share/dsc/suites";
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".toml") {
            paths.push_back(entry.path().string());
        }
    }
    if (paths.empty()) {
        throw dsc::InputError({.what = "no suites are installed",
                               .where = "run",
                               .value = "'" + folder.string() + "'",
                               .allowed = "suites there, or one on the command line"});
    }
    std::ranges::sort(paths);
    return paths;
}

Cases read_suites(const std::vector<std::string>& paths) {
    Cases cases;
    for (const std::string& path : paths) {
        std::ranges::move(read_suite(path), std::back_inserter(cases));
    }
    check_names(cases);
    return cases;
}

// A scene file, as it is, is held to its [limits] and to those that the other suite has for a scene
// of this name.
void add_scene_file(const std::string& path, const Cases* others, Cases& cases) {
    Case own = case_of_file(path);
    Cases of_others;
    for (const auto& c : others != nullptr ? *others : Cases{}) {
        if (c->file.scene.name != own.file.scene.name) {
            continue;
        }
        Case same = *c;
        same.file = own.file;
        same.path = path;
        same.parameters = own.parameters;
        for (const Held& held : same.held) {
            const std::string reason = why_not(*held.check, same);
            if (!reason.empty()) {
                throw dsc::InputError({.what = "a limit without its measure",
                                       .where = held.limit.where,
                                       .value = reason,
                                       .allowed = "limits of figures that the run has"});
            }
        }
        of_others.push_back(std::make_shared<const Case>(std::move(same)));
    }
    if (others != nullptr && of_others.empty()) {
        throw dsc::InputError({.what = "no limit of this scene",
                               .where = "--limits",
                               .value = own.name,
                               .allowed = "a suite with a case of " + own.name +
                                          ", such as `dsc_verify propose` writes"});
    }
    if (own.held.empty() && of_others.empty()) {
        throw dsc::InputError({.what = "a scene without limits",
                               .where = path,
                               .value = "no [limits]",
                               .allowed = "[limits] in the file, or --limits SUITE"});
    }
    cases.push_back(std::make_shared<const Case>(std::move(own)));
    std::ranges::move(of_others, std::back_inserter(cases));
}

// Suites and scene files are read; what else is named chooses among their cases and checks.
Chosen choose(const Arguments& arguments) {
    Chosen chosen{.cases = {}, .suites = {}, .only = arguments.only};
    std::vector<std::string> names;
    for (const std::string& word : arguments.words) {
        (dsc::scenes::is_scene_file(word) ? chosen.suites : names).push_back(word);
    }
    std::optional<Cases> limits;
    if (arguments.limits) {
        limits = read_suites({*arguments.limits});
    }
    if (chosen.suites.empty()) {
        chosen.suites = arguments.limits ? std::vector{*arguments.limits} : our_suites();
        chosen.cases = limits ? *limits : read_suites(chosen.suites);
    } else {
        for (const std::string& path : chosen.suites) {
            if (is_suite(path)) {
                std::ranges::move(read_suite(path), std::back_inserter(chosen.cases));
            } else {
                add_scene_file(path, limits ? &*limits : nullptr, chosen.cases);
            }
        }
        check_names(chosen.cases);
    }
    std::vector<std::string> scenes;
    for (const std::string& name : names) {
        const auto is_of_scene = [&](const auto& c) {
            return c->name == name || c->file.scene.name == name;
        };
        (std::ranges::any_of(chosen.cases, is_of_scene) ? scenes : chosen.only).push_back(name);
    }
    if (!scenes.empty()) {
        std::erase_if(chosen.cases, [&](const auto& c) {
            return std::ranges::none_of(scenes, [&](const std::string& name) {
                return c->name == name || c->file.scene.name == name;
            });
        });
    }
    return chosen;
}

int list_checks() {
    const Cases cases = read_suites(our_suites());
    for (const auto& check : all_checks()) {
        std::cout << std::left << std::setw(30) << check->name << check->description
                  << "; group: " << check->group << "; scenes:";
        for (const auto& c : cases) {
            if (std::ranges::find(c->held, check, &Held::check) != c->held.end()) {
                std::cout << ' ' << c->name;
            }
        }
        std::cout << '\n';
    }
    return 0;
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
    const Chosen chosen = choose(arguments);
    const std::vector<Task> tasks = tasks_of(chosen.cases, chosen.only);
    prepare_folder(arguments.out);

    print_heading(std::cout);
    Runs runs(configurations_of(tasks), arguments.jobs);
    std::vector<Row> rows = judge_all(tasks, runs, {.drift = arguments.drift},
                                      [](const Row& row) { print_row(std::cout, row); });
    const auto failed =
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.pass; });
    find_places(rows, runs, std::filesystem::path(arguments.out) / "failures");
    for (const Row& row : rows) {
        if (!row.pass) {
            print_failure(std::cout, row);
        }
    }
    std::cout << rows.size() << " limits, " << failed << " broken\n";
    try {
        const std::filesystem::path folder(arguments.out);
        dsc::scenes::write_file((folder / "verify.json").string(),
                                to_json(rows, chosen.suites, chosen.cases, runs));
        dsc::scenes::write_file((folder / "verify.xml").string(), to_junit(rows));
    } catch (const dsc::FileError& error) {
        std::cerr << "dsc_verify: " << error.what() << '\n';
        return 1; // not 2: everything was run
    }
    return failed == 0 ? 0 : 1;
}

struct Proposal {
    std::string what;
    std::vector<std::string> cases; ///< of the suite; none: all
    std::string out;
    int orders = 51; ///< that of the scene and fifty others
    int jobs = 1;
    bool update = false;
    bool overwrite = false;
};

// The text into which limits go: that of the suite, or a new one about the scene.
std::string text_of(const Proposal& proposal, bool is_of_suite) {
    if (is_of_suite) {
        return dsc::scenes::read_text_file(proposal.what);
    }
    (void)case_of_scene(proposal.what);
    if (!dsc::scenes::is_scene_file(proposal.what) || proposal.out.empty()) {
        return new_suite(proposal.what);
    }
    const auto folder = std::filesystem::path(proposal.out).parent_path();
    const auto path = std::filesystem::relative(
        proposal.what, folder.empty() ? std::filesystem::path(".") : folder);
    return new_suite(path.has_parent_path() || path.extension() == ".toml" ? path.string()
                                                                           : "./" + path.string());
}

void check_proposal(const Proposal& proposal, bool is_of_suite) {
    const auto refuse = [&](const char* what, const char* where, const char* allowed) {
        throw dsc::InputError({.what = what,
                               .where = where,
                               .value = dsc::scenes::quoted_excerpt(
                                   proposal.out.empty() ? proposal.what : proposal.out),
                               .allowed = allowed});
    };
    if (proposal.update && !is_of_suite) {
        refuse("not a suite", "--update", "a suite, or --out FILE for a new one");
    }
    if (is_of_suite && !proposal.out.empty()) {
        refuse("a suite is not written to another file", "--out", "--update");
    }
    if (!proposal.out.empty()) {
        if (std::filesystem::exists(proposal.out) && !proposal.overwrite) {
            refuse("there is such a file", "--out", "another name, or --overwrite");
        }
        dsc::scenes::check_writable(proposal.out, "--out");
    }
    if (proposal.update) {
        dsc::scenes::check_writable(proposal.what, "--update");
    }
}

int write_proposal(const Proposal& proposal) {
    const bool is_of_suite = dsc::scenes::is_scene_file(proposal.what) && is_suite(proposal.what);
    check_proposal(proposal, is_of_suite);
    const std::string text = text_of(proposal, is_of_suite);
    const std::string path = proposal.update ? proposal.what : proposal.out;
    Cases cases = read_suite_text(text, is_of_suite ? proposal.what : path, false);
    const auto name_of = [](const auto& c) { return c->name; };
    for (const std::string& name : proposal.cases) {
        if (std::ranges::find(cases, name, name_of) == cases.end()) {
            throw dsc::InputError({.what = "unknown case",
                                   .where = proposal.what,
                                   .value = dsc::scenes::quoted_excerpt(name),
                                   .allowed = dsc::scenes::name_list(cases, name_of)});
        }
    }
    std::erase_if(cases, [&](const auto& c) {
        return !proposal.cases.empty() &&
               std::ranges::find(proposal.cases, c->name) == proposal.cases.end();
    });
    const std::vector<Band> bands = propose(cases, proposal.orders, proposal.jobs);
    print_bands(std::cout, bands);
    if (path.empty()) {
        std::cout << "nothing is written without --update or --out FILE\n";
        return 0;
    }
    dsc::scenes::write_file(path, with_limits(text, path, bands));
    std::cout << "written: " << path << "; look at each limit before you commit it\n";
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

void add_jobs(CLI::App& command, int& jobs) {
    command
        .add_option("--jobs", jobs, "runs made at a time; results do not depend on it (default 1)")
        ->check(CLI::Range(1, 1024));
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Runs scenes and compares what they measure with limits."};
    app.require_subcommand(1);
    app.add_subcommand("list",
                       "all checks, their groups, and our scenes that have a limit for them");
    auto* run_command =
        app.add_subcommand("run", "hold our suites, or those and the scenes that are named, to "
                                  "their limits");
    Arguments arguments;
    run_command->add_option(
        "what", arguments.words,
        "suites and scene files (with a slash or ending in .toml); or scenes, checks and groups of "
        "checks, to choose among the limits of ours");
    run_command
        ->add_option("--only", arguments.only, "names or groups of checks, such as area,histograms")
        ->delimiter(',')
        ->allow_extra_args(false);
    run_command->add_option("--limits", arguments.limits,
                            "a suite in place of ours; of scene files, beside their [limits]");
    run_command
        ->add_option("--drift", arguments.drift,
                     "also fail what is worse than the limit's own measurement by more than this "
                     "share, such as 0.1")
        ->check(CLI::NonNegativeNumber);
    run_command->add_option("--out", arguments.out,
                            "folder for verify.json and verify.xml (default dsc_verify_out)");
    add_jobs(*run_command, arguments.jobs);
    auto* propose_command = app.add_subcommand(
        "propose", "measure limits in shuffled orders of the interface, for a person to look at");
    Proposal proposal;
    propose_command->add_option("what", proposal.what, "a suite, a scene file or a scene")
        ->required();
    propose_command->add_option("cases", proposal.cases, "of the suite (default: all)");
    propose_command
        ->add_option(
            "--orders", proposal.orders,
            "in which the interface is taken (default 51: that of the scene and fifty others)")
        ->check(CLI::Range(2, 10000));
    propose_command->add_flag(
        "--update", proposal.update,
        "write the limits into the suite, whose other lines stay as they are");
    propose_command->add_option("--out", proposal.out, "of a scene: the new suite");
    propose_command->add_flag("--overwrite", proposal.overwrite, "if there is such a file");
    add_jobs(*propose_command, proposal.jobs);
    return dsc::scenes::call_command(
        app, "dsc_verify", argc, argv,
        {{"list", [] { return unless_unreadable(list_checks); }},
         {"run", [&] { return unless_unreadable([&] { return run(arguments); }); }},
         {"propose", [&] { return unless_unreadable([&] { return write_proposal(proposal); }); }}});
}
