// SPDX-License-Identifier: MIT
// Calls the program with arbitrary arguments: it ends with success, or with one sentence that says
// what is wrong. Its only scene refuses to be prepared, so nothing runs and nothing is written.
// Each line of the input is one argument.
#include "fuzz/bytes.h"
#include "fuzz/target.h"

#include "dsc/base/error.h"
#include "scenes/command_line/scene_program.h"

#include <csignal>
#include <iostream>
#include <sstream>
#include <vector>

namespace dsc::fuzz {

namespace {

// Captures what is written to a stream during its lifetime.
class Captured {
public:
    explicit Captured(std::ostream& stream)
        : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
    ~Captured() { stream_.rdbuf(before_); }
    Captured(const Captured&) = delete;
    Captured& operator=(const Captured&) = delete;
    Captured(Captured&&) = delete;
    Captured& operator=(Captured&&) = delete;

    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    std::ostream& stream_;
    std::streambuf* before_;
};

scenes::Scene refusing_scene() {
    scenes::Scene scene;
    scene.name = "swirl";
    scene.prepare = [](const scenes::Parameters&) -> scenes::Setup {
        throw InputError({.what = "is not run", .where = "swirl", .value = "it", .allowed = "no"});
    };
    return scene;
}

} // namespace

std::uint64_t run_command_line(std::span<const std::uint8_t> bytes) {
    std::vector<std::string> arguments{"program"};
    std::istringstream lines(Bytes(bytes).text());
    for (std::string line; std::getline(lines, line);) {
        // Arguments with a slash are left out: they could name a scene file that runs for long.
        if (arguments.size() < 100 && line.find('/') == std::string::npos) {
            arguments.push_back(line.substr(0, line.find('\0')));
        }
    }
    std::vector<const char*> pointers;
    for (const std::string& argument : arguments) {
        pointers.push_back(argument.c_str());
    }
    int code = 0;
    std::string error;
    {
        const Captured out(std::cout);
        const Captured problem(std::cerr);
        code = scenes::scene_program("program", {refusing_scene()},
                                     static_cast<int>(pointers.size()), pointers.data());
        error = problem.text();
    }
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    if (code != 0) {
        expect(code == 1 || code == 2, "exit code " + std::to_string(code));
        expect(error.starts_with("program: ") && error.ends_with('\n'), "no sentence: " + error);
    }
    return 1;
}

} // namespace dsc::fuzz
