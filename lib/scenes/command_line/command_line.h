// SPDX-License-Identifier: MIT
// Common parts of the programs' command lines: `list`, `run`, and the exit codes.
#pragma once

#include "dsc/base/error.h"
#include "scenes/command_line/standard_output.h"
#include "scenes/file/excerpt.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace dsc::scenes {

/// The functions of the commands, by name.
using Commands = std::vector<std::pair<std::string, std::function<int()>>>;

/// The result of `main`. `app` has these commands with their options and parses the arguments; then
/// the chosen command is called. Exit code: that of the command; 0 after --help; 2 for bad usage
/// and InputError, with a sentence on stderr that begins with the program's name; 1 for any other
/// exception, and if standard output cannot be written.
inline int call_command(CLI::App& app, const std::string& program, int argc,
                        const char* const* argv, const Commands& commands) {
    const auto complain = [&](const std::string& sentence, int code) {
        std::cerr << program << ": " << sentence << '\n';
        return code;
    };
    const std::string help = " (see " + program + " --help)";
    // CLI11 would only say that a command is missing.
    const std::string command = argc > 1 ? argv[1] : "";
    const auto is_called = [&](const auto& one) { return one.first == command; };
    if (!command.starts_with('-') && std::ranges::none_of(commands, is_called)) {
        return complain("unknown command: got '" + command + "'; allowed: " +
                            name_list(commands, &Commands::value_type::first) + help,
                        2);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? with_output_written(program, app.exit(error)) // --help
                                          : complain(error.what() + help, 2);
    }
    try {
        for (const auto& [name, call] : commands) {
            if (app.got_subcommand(name)) {
                return with_output_written(program, call());
            }
        }
        return 2; // not reached: CLI11 requires a command
    } catch (const InputError& error) {
        return complain(error.what(), 2);
    } catch (const std::exception& error) {
        return complain(error.what(), 1);
    }
}

} // namespace dsc::scenes
