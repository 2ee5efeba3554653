// SPDX-License-Identifier: MIT
// dsc_hard list
// dsc_hard run [CASE]... [--long] [--json FILE]
// Exit: 0 all cases hold; 1 one does not, or a file could not be written; 2 bad usage.
#include "scene.h"

#include "dsc/base/error.h"
#include "scenes/command_line/command_line.h"
#include "scenes/file/text_file.h"
#include "scenes/run/clock.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>

namespace {

using namespace dsc::hard;

/// A case with what happened, and the seconds that it took.
struct Row {
    const HardCase* one = nullptr;
    HardResult result;
    double seconds = 0;
};

using Json = nlohmann::ordered_json;

// JSON has no NaN.
Json finite(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

void print_row(std::ostream& out, const Row& row) {
    const HardResult& r = row.result;
    out << std::left << std::setw(36) << row.one->name << std::right << std::setw(7)
        << text(row.seconds) << " s  " << (r.holds() ? r.happened : "FAIL");
    for (const auto& failure : r.failures) {
        out << "; " << failure;
    }
    out << std::endl;
}

std::string to_json(const std::vector<Row>& rows) {
    Json cases = Json::array();
    for (const Row& row : rows) {
        const HardResult& r = row.result;
        cases.push_back({{"name", row.one->name},
                         {"asked", r.asked},
                         {"holds", r.holds()},
                         {"failures", r.failures},
                         {"what_happened", r.happened},
                         {"steps", r.steps},
                         {"sub_steps", r.sub_steps},
                         {"max_sub_steps", r.max_sub_steps},
                         {"inverted", r.inverted},
                         {"unreached", r.unreached},
                         {"held", r.held},
                         {"missed", r.missed},
                         {"uncounted", r.uncounted},
                         {"overcounted", r.overcounted},
                         {"gave_up", r.gave_up},
                         {"error_message", r.error_message},
                         {"shape_error", finite(r.error)},
                         {"seconds", row.seconds}});
    }
    return cases.dump(1) + "\n";
}

struct Arguments {
    std::vector<std::string> cases;
    bool with_long = false;
    std::string json;
};

// The cases named; if none is named, all, with the long ones only after --long.
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
        dsc::scenes::check_outputs({{"--json", arguments.json}});
    }
    std::vector<Row> rows;
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
        return 0;
    };
    return dsc::scenes::call_command(
        app, "dsc_hard", argc, argv,
        {{"list", list_cases}, {"run", [&] { return run(arguments); }}});
}
