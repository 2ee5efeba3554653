// SPDX-License-Identifier: MIT
// dsc_hard list
// dsc_hard run [CASE]... [--long] [--json FILE]
// Exit: 0 all cases hold; 1 one does not, or a file could not be written; 2 bad usage.
#include "table.h"

#include "dsc/base/error.h"
#include "scenes/command_line/command_line.h"
#include "scenes/output/write_file.h"
#include "scenes/run/clock.h"

#include <algorithm>
#include <iostream>

namespace {

using namespace dsc::hard;

struct Arguments {
    std::vector<std::string> cases;
    bool with_long = false;
    std::string json;
};

// Those that are named; none named: all, the long ones only where asked for.
std::vector<const HardCase*> select(const Arguments& arguments) {
    std::vector<const HardCase*> selected;
    for (const std::string& name : arguments.cases) {
        const auto at = std::ranges::find(all_cases(), name, &HardCase::name);
        if (at == all_cases().end()) {
            throw dsc::InputError({.what = "unknown case",
                                   .where = "run",
                                   .value = "'" + name + "'",
                                   .allowed = "the names that dsc_hard list prints"});
        }
        selected.push_back(&*at);
    }
    if (arguments.cases.empty()) {
        for (const HardCase& one : all_cases()) {
            if (arguments.with_long || !one.is_long) {
                selected.push_back(&one);
            }
        }
    }
    return selected;
}

Row run_case(const HardCase& one) {
    Row row{&one, {}, 0};
    const dsc::scenes::Stopwatch watch;
    try {
        row.result = one.run();
    } catch (const std::exception& error) {
        row.result.failures.push_back(std::string("an exception: ") + error.what());
    }
    row.seconds = watch.wall();
    return row;
}

int run(const Arguments& arguments) {
    const auto selected = select(arguments);
    if (!arguments.json.empty()) {
        dsc::scenes::check_writable(arguments.json, "--json");
    }
    std::vector<Row> rows;
    print_heading(std::cout);
    for (const HardCase* one : selected) {
        rows.push_back(run_case(*one));
        print_row(std::cout, rows.back());
    }
    const auto failed =
        std::ranges::count_if(rows, [](const Row& row) { return !row.result.holds(); });
    std::cout << rows.size() << " cases, " << failed << " do not hold\n";
    try {
        if (!arguments.json.empty()) {
            dsc::scenes::write_file(arguments.json, to_json(rows));
        }
    } catch (const dsc::FileError& error) {
        std::cerr << "dsc_hard: " << error.what() << '\n';
        return 1; // not 2: everything was run
    }
    return failed == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Runs the hard cases and prints what happens in each."};
    app.require_subcommand(1);
    app.add_subcommand("list", "all cases");
    auto* run_command =
        app.add_subcommand("run", "run all cases but the long ones, or those that are named");
    Arguments arguments;
    run_command->add_option("cases", arguments.cases, "names from the list");
    run_command->add_flag("--long", arguments.with_long, "the long ones too (some minutes)");
    run_command->add_option("--json", arguments.json, "file for all that was measured");
    const auto list_cases = [] {
        for (const HardCase& one : all_cases()) {
            std::cout << one.name << (one.is_long ? "  (long)" : "") << '\n';
        }
    };
    return dsc::scenes::list_or_run(app, "dsc_hard", argc, argv, list_cases,
                                    [&] { return run(arguments); });
}
