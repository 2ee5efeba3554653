// SPDX-License-Identifier: MIT
// What is fuzzed. A target takes any bytes, and either ends or throws a Finding; everything else
// that comes out of it is a finding too: another exception, a signal, a report of a sanitizer, a
// hang.
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

/// Something that the library promises and did not keep.
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

/// 1 if `read` ends, 0 if it is refused a file, whose path the error names.
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

/// One input; returns how many operations it did: edits, steps, or texts that were read.
using Run = std::uint64_t (*)(std::span<const std::uint8_t> bytes);

std::uint64_t run_operations(std::span<const std::uint8_t> bytes);
std::uint64_t run_steps(std::span<const std::uint8_t> bytes);
std::uint64_t run_scene_file(std::span<const std::uint8_t> bytes);
std::uint64_t run_outlines(std::span<const std::uint8_t> bytes);
std::uint64_t run_formulas(std::span<const std::uint8_t> bytes);
std::uint64_t run_command_line(std::span<const std::uint8_t> bytes);
std::uint64_t run_archives(std::span<const std::uint8_t> bytes);

struct Target {
    std::string name; ///< of its folder in the corpus as well
    Run run;
};

/// All of them.
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
