// SPDX-License-Identifier: MIT
// dsc_precision list
// dsc_precision run [--quick] [--flow F]... [--method M]... --out DIR
// Exit: 0 done; 1 a run broke an invariant or could not be written; 2 bad usage.
#include "dsc/base/error.h"
#include "run.h"
#include "scenes/command_line/command_line.h"
#include "scenes/file/text_file.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace {

using namespace dsc::bench;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Arguments {
    std::vector<std::string> flows;
    std::vector<std::string> methods;
    bool quick = false;
    std::string out;
};

int list_all() {
    std::puts("flows:");
    for (const Flow& flow : precision_flows()) {
        std::printf("  %-44s %s; h =", flow.name.c_str(), flow.title.c_str());
        for (const double h : flow.lengths) {
            std::printf(" %g", h);
        }
        std::puts("");
    }
    std::puts("methods:");
    for (const Method& method : precision_methods()) {
        std::printf("  %-44s %s", method.name.c_str(), to_string(method.group).c_str());
        for (const Setting& setting : method.settings) {
            if (setting.word.empty()) {
                std::printf(" %s=%g*h^%g", setting.key.c_str(), setting.factor, setting.power);
            } else {
                std::printf(" %s=%s", setting.key.c_str(), setting.word.c_str());
            }
        }
        std::printf("%s\n", method.step == Method::Step::with_square ? " dt~h^2" : "");
    }
    return 0;
}

// The named entries of a table, or all of them, in the order of the table.
template <class Item>
std::vector<const Item*> chosen(const std::vector<Item>& table,
                                const std::vector<std::string>& names, const std::string& option) {
    std::string all;
    for (const Item& item : table) {
        all += (all.empty() ? "" : "; ") + item.name;
    }
    for (const std::string& name : names) {
        if (std::none_of(table.begin(), table.end(),
                         [&](const Item& item) { return item.name == name; })) {
            throw dsc::InputError({.what = "unknown name",
                                   .where = option,
                                   .value = "'" + name + "'",
                                   .allowed = all});
        }
    }
    std::vector<const Item*> result;
    for (const Item& item : table) {
        if (names.empty() || std::find(names.begin(), names.end(), item.name) != names.end()) {
            result.push_back(&item);
        }
    }
    return result;
}

void print_result(const Case& item, const Json& json) {
    const auto number = [&](const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_number() ? found->get<double>() : NAN;
    };
    std::printf("%-16s %-44s h %-11.6g SD %.2e  at T/2 %.2e  CPU %.4g s\n", item.flow->name.c_str(),
                item.method->name.c_str(), item.h, number("sd_rel_last"), number("sd_rel_half"),
                number("cpu_s"));
    std::fflush(stdout);
}

int run(const Arguments& arguments) {
    const auto cases =
        cases_of(chosen(precision_flows(), arguments.flows, "--flow"),
                 chosen(precision_methods(), arguments.methods, "--method"), arguments.quick);
    for (const Case& item : cases) {
        (void)parameters_of(item); // finds errors of the tables before the first run
    }
    std::error_code ignored; // an unwritable folder is refused below
    fs::create_directories(arguments.out, ignored);
    for (const Case& item : cases) {
        dsc::scenes::check_outputs({{"--out", fs::path(arguments.out) / file_name(item)}});
    }
    const bool watched = isatty(STDERR_FILENO) != 0;
    ExactShapes shapes;
    int broken = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& item = cases[i];
        const fs::path file = fs::path(arguments.out) / file_name(item);
        if (watched) {
            std::fprintf(stderr, "\r\033[K%zu of %zu: %s, %s, h = %g", i + 1, cases.size(),
                         item.flow->title.c_str(), item.method->name.c_str(), item.h);
        }
        const CaseResult result = run_case(item, shapes);
        if (watched) {
            std::fputs("\r\033[K", stderr);
        }
        dsc::scenes::write_file(file, result.json.dump(2) + "\n");
        print_result(item, result.json);
        // Unreached vertices of methods other than the default are a result, not a failure.
        const bool fails =
            !result.holds || (result.unreached > 0 && item.method->group == Group::base);
        broken += fails ? 1 : 0;
        if (fails || result.unreached > 0) {
            std::fprintf(stderr, "dsc_precision: %s: %s; %llu times a vertex did not arrive\n",
                         file.filename().c_str(),
                         result.holds ? "the mesh stayed valid"
                                      : "a triangle was inverted or the run gave up",
                         static_cast<unsigned long long>(result.unreached));
        }
    }
    return broken > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measures the error and the CPU time of methods in flows with an exact solution."};
    app.require_subcommand(1);
    app.add_subcommand("list", "all flows and methods");
    auto* run_command = app.add_subcommand("run", "run them, or some of them");
    Arguments arguments;
    run_command->add_option("--flow", arguments.flows, "only this one; may be repeated")
        ->allow_extra_args(false);
    run_command->add_option("--method", arguments.methods, "only this one; may be repeated")
        ->allow_extra_args(false);
    run_command->add_flag("--quick", arguments.quick, "without the fine edge lengths");
    run_command->add_option("--out", arguments.out, "folder for the results")->required();
    return dsc::scenes::call_command(app, "dsc_precision", argc, argv,
                                     {{"list", list_all}, {"run", [&] { return run(arguments); }}});
}
