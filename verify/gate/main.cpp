// SPDX-License-Identifier: MIT
// dsc_verify list
// dsc_verify run [CHECK]... [--limits FILE] [--out DIR]
// Exit: 0 all limits hold; 1 one is broken, or the results could not be written; 2 bad usage.
#include "report.h"

#include "dsc/base/error.h"
#include "scenes/command_line/command_line.h"
#include "scenes/output/write_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace {

using namespace dsc::gate;

struct Arguments {
    std::vector<std::string> checks;
    std::string limits = DSC_LIMITS_FILE;
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

int run(const Arguments& arguments) {
    const auto checks = select_checks(arguments.checks);
    const Limits limits = Limits::read(arguments.limits);
    check_limits(checks, limits);
    prepare_folder(arguments.out);

    Runs runs;
    std::vector<Row> rows;
    print_heading(std::cout);
    for (const Check* check : checks) {
        for (const std::string& scene : check->scenes) {
            rows.push_back(judge(*check, scene, limits, runs));
            print_row(std::cout, rows.back());
        }
    }
    const auto failed =
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.pass; });
    std::cout << rows.size() << " limits, " << failed << " broken\n";
    try {
        const std::filesystem::path folder(arguments.out);
        dsc::scenes::write_file((folder / "verify.json").string(), to_json(rows, limits, runs));
        dsc::scenes::write_file((folder / "verify.xml").string(), to_junit(rows));
    } catch (const dsc::FileError& error) {
        std::cerr << "dsc_verify: " << error.what() << '\n';
        return 1; // not 2: everything was run
    }
    return failed == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Runs scenes and compares what they measure with limits."};
    app.require_subcommand(1);
    app.add_subcommand("list", "all checks and their scenes");
    auto* run_command = app.add_subcommand("run", "run all checks, or those that are named");
    Arguments arguments;
    run_command->add_option("checks", arguments.checks, "names from the list");
    run_command->add_option("--limits", arguments.limits, "the limits file");
    run_command->add_option("--out", arguments.out,
                            "folder for verify.json and verify.xml (default dsc_verify_out)");
    return dsc::scenes::list_or_run(app, "dsc_verify", argc, argv, list_checks, [&] {
        try {
            return run(arguments);
        } catch (const dsc::FileError& error) { // of the limits
            std::cerr << "dsc_verify: " << error.what() << '\n';
            return 2;
        }
    });
}
