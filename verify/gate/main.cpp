// SPDX-License-Identifier: MIT
// dsc_verify list
// dsc_verify run [SUITE|SCENE_FILE|SCENE|CHECK]... [--only CHECK,...] [--limits SUITE]
//                [--jobs N] [--drift SHARE] [--out DIR]
// dsc_verify propose SUITE|SCENE_FILE|SCENE [--orders N] [--jobs N] [--update | --out FILE]
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

#include <algorithm>
#include <filesystem>
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

/// The cases and checks that a command line chooses.
struct Chosen {
    Cases cases;
    std::vector<std::string> suites; ///< and scene files
    std::vector<std::string> only;
};

// The suites are installed beside this program, and a build tree has a link to them there.
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

// The case of a scene file, with the limits that a suite gives to a scene of this name.
Cases cases_of(const std::string& path, const std::string& suite) {
    const Case own = case_of_scene(path);
    Cases cases;
    for (const auto& c : read_suite(suite)) {
        if (c->file.scene.name != own.file.scene.name) {
            continue;
        }
        Case same = *c;
        same.file = own.file;
        same.path = path;
        same.parameters = own.parameters;
        for (const Held& held : same.held) {
            if (const std::string reason = why_not(*held.check, same); !reason.empty()) {
                throw dsc::InputError({.what = "the run does not measure the figure of this limit",
                                       .where = held.limit.where,
                                       .value = reason,
                                       .allowed = "figures that the run measures"});
            }
        }
        cases.push_back(std::make_shared<const Case>(std::move(same)));
    }
    if (cases.empty()) {
        throw dsc::InputError({.what = "the suite has no limits for this scene",
                               .where = "--limits",
                               .value = own.name,
                               .allowed = "a suite with a case of " + own.name +
                                          ", such as `dsc_verify propose` writes"});
    }
    return cases;
}

Cases read_cases(const std::vector<std::string>& paths,
                 const std::optional<std::string>& limits = {}) {
    Cases cases;
    for (const std::string& path : paths) {
        const bool is_of_suite = is_suite(path);
        if (is_of_suite) {
            std::ranges::move(read_suite(path), std::back_inserter(cases));
        } else if (limits) {
            std::ranges::move(cases_of(path, *limits), std::back_inserter(cases));
        }
        if (!is_of_suite && (!limits || !case_of_scene(path).file.limits.empty())) {
            cases.push_back(std::make_shared<const Case>(case_of_file(path)));
        }
    }
    check_names(cases);
    return cases;
}

// Reads the suites and scene files named; all other names choose among their cases and checks.
Chosen choose(const Arguments& arguments) {
    Chosen chosen{.cases = {}, .suites = {}, .only = arguments.only};
    std::vector<std::string> names;
    for (const std::string& word : arguments.words) {
        (dsc::scenes::is_scene_file(word) ? chosen.suites : names).push_back(word);
    }
    if (chosen.suites.empty()) {
        chosen.suites = arguments.limits ? std::vector{*arguments.limits} : our_suites();
    }
    chosen.cases = read_cases(chosen.suites, arguments.limits);
    const auto is_called = [](const auto& c, const std::string& name) {
        return c->name == name || c->file.scene.name == name;
    };
    std::vector<std::string> scenes;
    for (const std::string& name : names) {
        const bool is_scene =
            std::ranges::any_of(chosen.cases, [&](const auto& c) { return is_called(c, name); });
        (is_scene ? scenes : chosen.only).push_back(name);
    }
    std::erase_if(chosen.cases, [&](const auto& c) {
        return !scenes.empty() && std::ranges::none_of(scenes, [&](const std::string& name) {
            return is_called(c, name);
        });
    });
    return chosen;
}

int list_checks() {
    const Cases cases = read_cases(our_suites());
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

// Finds the places of broken limits, for the first few failures.
void find_places(std::vector<Row>& rows, const Runs& runs, const std::filesystem::path& folder) {
    constexpr int max_places = 20;
    int places = 0;
    for (Row& row : rows) {
        if (row.pass || ++places > max_places) {
            continue;
        }
        try {
            row.place = find_place(row, runs, folder);
        } catch (const std::exception& error) { // the row counts as failed anyway
            row.place.what = std::string("not found: ") + error.what();
        }
    }
}

int run(const Arguments& arguments) {
    const Chosen chosen = choose(arguments);
    const std::vector<Task> tasks = tasks_of(chosen.cases, chosen.only);
    const std::filesystem::path folder(arguments.out);
    std::error_code ignored; // `check_outputs` refuses a folder that cannot be written
    std::filesystem::create_directories(folder, ignored);
    std::vector<dsc::scenes::NamedFile> inputs;
    for (const std::string& suite : chosen.suites) {
        inputs.push_back({"a suite", suite});
    }
    const std::string json = (folder / "verify.json").string();
    const std::string junit = (folder / "verify.xml").string();
    dsc::scenes::check_outputs({{"--out", json}, {"--out", junit}}, inputs);

    print_heading(std::cout);
    Runs runs(configurations_of(tasks), arguments.jobs);
    std::vector<Row> rows =
        judge_all(tasks, runs, arguments.drift, [](const Row& row) { print_row(std::cout, row); });
    const auto failed =
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.pass; });
    find_places(rows, runs, folder / "failures");
    for (const Row& row : rows) {
        if (!row.pass) {
            print_failure(std::cout, row);
        }
    }
    std::cout << rows.size() << " limits, " << failed << " broken\n";
    try {
        dsc::scenes::write_file(json, to_json(rows, chosen.suites, chosen.cases, runs));
        dsc::scenes::write_file(junit, to_junit(rows));
    } catch (const dsc::FileError& error) {
        std::cerr << "dsc_verify: " << error.what() << '\n';
        return 1; // not 2: everything was run
    }
    return failed == 0 ? 0 : 1;
}

struct Proposal {
    std::string what;
    std::string out;
    int orders = 51; ///< the scene's own order and fifty shuffled ones
    int jobs = 1;
    bool update = false;
};

// The text into which limits are written: that of the suite, or of a new suite with the scene.
std::string text_of(const Proposal& proposal, bool is_of_suite) {
    if (is_of_suite) {
        return dsc::scenes::read_text_file(proposal.what);
    }
    (void)case_of_scene(proposal.what);
    std::string scene = proposal.what;
    if (dsc::scenes::is_scene_file(scene)) { // its path is relative to the suite
        const auto folder = std::filesystem::path(proposal.out).parent_path() / ".";
        scene = "./" + std::filesystem::relative(scene, folder).string();
    }
    return "# Proposed by `dsc_verify propose`: review each limit before you commit it.\n"
           "[[case]]\nscene = \"" +
           scene + "\"\n[case.limits]\n";
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
        refuse("--out is not allowed for a suite", "--out", "--update");
    }
    if (!proposal.out.empty()) {
        if (std::filesystem::exists(proposal.out)) {
            refuse("the file already exists", "--out", "another name");
        }
        dsc::scenes::check_outputs({{"--out", proposal.out}});
    }
    if (proposal.update) {
        dsc::scenes::check_outputs({{"--update", proposal.what}});
    }
}

int write_proposal(const Proposal& proposal) {
    const bool is_of_suite = dsc::scenes::is_scene_file(proposal.what) && is_suite(proposal.what);
    check_proposal(proposal, is_of_suite);
    const std::string text = text_of(proposal, is_of_suite);
    const std::string path = proposal.update ? proposal.what : proposal.out;
    const Cases cases = read_suite_text(text, is_of_suite ? proposal.what : path, false);
    const std::vector<Wanted> wanted = limits_to_measure(cases, proposal.orders);
    if (!path.empty()) {
        check_writable(wanted, path);
    }
    const std::vector<Band> bands = propose(wanted, proposal.jobs);
    print_bands(std::cout, bands);
    if (path.empty()) {
        std::cout << "nothing was written: give --update or --out FILE\n";
        return 0;
    }
    dsc::scenes::write_file(path, with_limits(text, path, bands));
    std::cout << "written: " << path << "; review each limit before you commit it\n";
    return 0;
}

void add_jobs(CLI::App& command, int& jobs) {
    command
        .add_option("--jobs", jobs,
                    "number of parallel runs (default 1); does not change the results")
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
    run_command->add_option(
        "--limits", arguments.limits,
        "a suite to use instead of the project's; for scene files, in addition to their [limits]");
    run_command
        ->add_option(
            "--drift", arguments.drift,
            "also fail figures that are worse than the limit's measurement by more than this "
            "fraction, such as 0.1")
        ->check(CLI::NonNegativeNumber);
    run_command->add_option("--out", arguments.out,
                            "folder for verify.json and verify.xml (default dsc_verify_out)");
    add_jobs(*run_command, arguments.jobs);
    auto* propose_command = app.add_subcommand(
        "propose", "measure limits in shuffled orders of the interface, for a person to look at");
    Proposal proposal;
    propose_command->add_option("what", proposal.what, "a suite, a scene file or a scene")
        ->required();
    propose_command
        ->add_option(
            "--orders", proposal.orders,
            "in which the interface is taken (default 51: that of the scene and fifty others)")
        ->check(CLI::Range(2, 10000));
    propose_command->add_flag(
        "--update", proposal.update,
        "write the limits into the suite, whose other lines stay as they are");
    propose_command->add_option("--out", proposal.out, "for a scene: the new suite");
    add_jobs(*propose_command, proposal.jobs);
    return dsc::scenes::call_command(app, "dsc_verify", argc, argv,
                                     {{"list", list_checks},
                                      {"run", [&] { return run(arguments); }},
                                      {"propose", [&] { return write_proposal(proposal); }}});
}
