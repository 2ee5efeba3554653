// SPDX-License-Identifier: MIT
// The targets of fuzzing. A target accepts any bytes, and either returns or throws a Finding; any
// other outcome is a finding too: another exception, a signal, a report of a sanitizer, a hang.
//
// verify/fuzz.sh has libFuzzer search for such bytes; the test FuzzCorpus runs those of the corpus.
#pragma once

#include "dsc/base/error.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace dsc::fuzz {

/// A broken guarantee of the library.
class Finding : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws a Finding unless the condition holds.
inline void expect(bool condition, const std::string& promise) {
    if (!condition) {
        throw Finding(promise);
    }
}

/// 1 if `read` returns, 0 if it throws a FileError, which must name the path.
template <class Read>
std::uint64_t end_or_refuse(Read read) {
    try {
        read();
        return 1;
    } catch (const FileError& error) {
        expect(!error.path().empty(), std::string("an error without a path: ") + error.what());
        return 0;
    }
}

/// Processes one input; returns the number of operations: edits, steps, or texts read.
using Run = std::uint64_t (*)(std::span<const std::uint8_t> bytes);

std::uint64_t run_operations(std::span<const std::uint8_t> bytes);
std::uint64_t run_steps(std::span<const std::uint8_t> bytes);
std::uint64_t run_scene_file(std::span<const std::uint8_t> bytes);
std::uint64_t run_outlines(std::span<const std::uint8_t> bytes);
std::uint64_t run_formulas(std::span<const std::uint8_t> bytes);
std::uint64_t run_command_line(std::span<const std::uint8_t> bytes);
std::uint64_t run_archives(std::span<const std::uint8_t> bytes);

struct Target {
    std::string name; ///< also the name of its folder in the corpus
    Run run;
};

/// All targets.
[[nodiscard]] inline const std::vector<Target>& targets() {
    static const std::vector<Target> all{
        {"operations", run_operations}, {"steps", run_steps},
        {"scene_file", run_scene_file}, {"outlines", run_outlines},
        {"formulas", run_formulas},     {"command_line", run_command_line},
        {"archives", run_archives},
    };
    return all;
}

} // namespace dsc::fuzz
