// SPDX-License-Identifier: MIT
// What happened in a hard case. The struct is dumb: cases fill it in, the test and the table read
// it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::hard {

struct HardResult {
    std::string asked;    ///< what the case asks of the library, in a sentence
    std::string happened; ///< what it did, in a sentence
    std::uint64_t steps = 0;
    std::uint64_t sub_steps = 0;
    std::uint32_t max_sub_steps = 0; ///< of one step
    std::uint64_t inverted = 0;  ///< triangles not positive by the exact predicate, over all steps
    std::uint64_t unreached = 0; ///< vertices that did not arrive, as the library counts them
    std::uint64_t held = 0;      ///< of these, for a velocity or a target that is not finite
    std::uint64_t missed = 0;    ///< vertices that an independent look finds not at their target
    std::uint64_t uncounted = 0; ///< of these, beyond what the library counts in the same sub-step
    std::uint64_t overcounted = 0;     ///< counted by the library, and at their target all the same
    std::string gave_up;               ///< empty, or why and when a step gave up
    std::string error_message;         ///< empty, or the typed error that stopped the case
    std::optional<double> error;       ///< `shape_error` at the end, the worst of several
    std::vector<std::string> failures; ///< what was expected and is not so; empty: the case holds

    [[nodiscard]] bool holds() const { return failures.empty(); }
};

/// Notes a failure where `good` is false.
inline void expect(HardResult& result, bool good, const std::string& sentence) {
    if (!good) {
        result.failures.push_back(sentence);
    }
}

/// One row of the table.
struct HardCase {
    std::string name;
    std::function<HardResult()> run;
    bool is_long = false; ///< beyond what the ordinary run of the tests has time for
};

/// All cases, in the order of the table.
[[nodiscard]] const std::vector<HardCase>& all_cases();

// By what is hard about them; `all_cases` puts them together.
void append_coordinates(std::vector<HardCase>& cases); ///< offsets, sizes, the ends of a scalar
void append_long_steps(std::vector<HardCase>& cases);  ///< many edges a step; filaments
void append_contacts(
    std::vector<HardCase>& cases); ///< interface on interface, domain boundary, junction
void append_degenerate(std::vector<HardCase>& cases); ///< needles, caps, near-degenerate grids
void append_numbers(std::vector<HardCase>& cases);    ///< denormals, NaN, infinity
void append_long_runs(std::vector<HardCase>& cases);  ///< 100 revolutions, a million steps

} // namespace dsc::hard
