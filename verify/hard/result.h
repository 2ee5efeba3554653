// SPDX-License-Identifier: MIT
// The result of a hard case: plain data, written by cases and read by the test and the table.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::hard {

struct HardResult {
    std::string asked;    ///< the input of the case, as a sentence
    std::string happened; ///< the behaviour of the library, as a sentence
    std::uint64_t steps = 0;
    std::uint64_t sub_steps = 0;
    std::uint32_t max_sub_steps = 0; ///< of one step
    std::uint64_t inverted =
        0; ///< triangles that are not positive by the exact predicate, over all steps
    std::uint64_t unreached = 0; ///< vertices that did not arrive, as the library counts them
    std::uint64_t held = 0;      ///< of these, for a velocity or a target that is not finite
    std::uint64_t missed = 0;    ///< vertices not at their target, by an independent check
    std::uint64_t uncounted =
        0; ///< missed vertices that the library does not count in the same sub-step
    std::uint64_t overcounted = 0;     ///< counted by the library although at their target
    std::string gave_up;               ///< empty, or why and when a step gave up
    std::string error_message;         ///< empty, or the typed error that stopped the case
    std::optional<double> error;       ///< `shape_error` at the end, the worst of several
    std::vector<std::string> failures; ///< broken expectations; empty: the case holds

    [[nodiscard]] bool holds() const { return failures.empty(); }
};

/// Adds a failure if `good` is false.
inline void expect(HardResult& result, bool good, const std::string& sentence) {
    if (!good) {
        result.failures.push_back(sentence);
    }
}

/// One row of the table.
struct HardCase {
    std::string name;
    std::function<HardResult()> run;
    bool is_long = false; ///< too long for the ordinary tests
};

/// All cases, in the order of the table.
[[nodiscard]] const std::vector<HardCase>& all_cases();

// The groups of cases, which `all_cases` joins.
void append_coordinates(std::vector<HardCase>& cases); ///< offsets, sizes, the ends of a scalar
void append_long_steps(std::vector<HardCase>& cases);  ///< steps of many edge lengths; filaments
void append_contacts(
    std::vector<HardCase>& cases); ///< interface on interface, domain boundary, junction
void append_degenerate(std::vector<HardCase>& cases); ///< needles, caps, near-degenerate grids
void append_numbers(std::vector<HardCase>& cases);    ///< denormals, NaN, infinity
void append_long_runs(std::vector<HardCase>& cases);  ///< 100 revolutions, a million steps

} // namespace dsc::hard
