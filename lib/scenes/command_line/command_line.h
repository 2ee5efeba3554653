// SPDX-License-Identifier: MIT
// What the programs' command lines have in common: `list`, `run`, and exit codes with the same
// meaning everywhere.
#pragma once

#include "dsc/base/error.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <functional>
#include <iostream>
#include <string>

namespace dsc::scenes {

/// The result of `main`. `app` has the commands `list` and `run` with their options, and parses
/// them before one of the two is called. Exit: what `run` returns; 0 after `list` and --help; 2 for
/// bad usage and InputError, with a sentence on stderr that begins with the program's name; 1 for
/// any other exception.
inline int list_or_run(CLI::App& app, const std::string& program, int argc, const char* const* argv,
                       const std::function<void()>& list, const std::function<int()>& run) {
    const auto complain = [&](const std::string& sentence, int code) {
        std::cerr << program << ": " << sentence << '\n';
        return code;
    };
    const std::string help = " (see " + program + " --help)";
    // CLI11 would only say that a command is missing.
    const std::string command = argc > 1 ? argv[1] : "";
    if (!command.starts_with('-') && command != "list" && command != "run") {
        return complain("unknown command: got '" + command + "'; allowed: list, run" + help, 2);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? app.exit(error) // --help
                                          : complain(error.what() + help, 2);
    }
    try {
        if (app.got_subcommand("list")) {
            list();
            return 0;
        }
        return run();
    } catch (const InputError& error) {
        return complain(error.what(), 2);
    } catch (const std::exception& error) {
        return complain(error.what(), 1);
    }
}

} // namespace dsc::scenes
