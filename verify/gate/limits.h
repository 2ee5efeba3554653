// SPDX-License-Identifier: MIT
// A limit of a suite: the largest or smallest allowed figure of a check, and its origin. Limits are
// written by hand, or by `dsc_verify propose` and then reviewed.
#pragma once

#include "scenes/file/table_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace dsc::gate {

struct Check;

/// How a limit follows from what was measured.
struct Rule {
    std::string name;
    double min; ///< smallest allowed ratio of limit to measured figure (lower limit: the reverse)
    double max; ///< largest allowed ratio, which includes rounding to two digits
    double factor = 1; ///< used by `propose`; 1: `propose` does not change the limit
};

/// Throws InputError, which lists all rules, if there is none of this name.
[[nodiscard]] const Rule& find_rule(const std::string& name);

struct Limit {
    double value = 0;
    std::optional<double> around{};         ///< the difference from this figure is limited
    std::vector<std::uint64_t> histogram{}; ///< the distance from this one is limited
    std::optional<double> measured{}; ///< figure of the run, or the worst of `orders` shuffled runs
    std::string rule = "required";
    int orders = 0; ///< number of orders of the interface measured; 0: only the scene's own
    std::string note{};
    std::string at{};    ///< commit, day, machine and compiler of the measurement
    std::string where{}; ///< file, line and key
    bool is_own = true;  ///< the limit belongs to the case itself, not to all cases of the suite

    /// The origin of the value, in words.
    [[nodiscard]] std::string reason() const;
    /// The relative amount by which a figure is worse than `measured`; 0 if that is meaningless, as
    /// for rounding errors.
    [[nodiscard]] double worse_by(double figure, bool at_least) const;
};

/// A number with this many significant digits.
[[nodiscard]] std::string few_digits(double value, int digits = 4);

/// Figures below this are rounding errors and are not compared.
inline constexpr double rounding_error = 1e-12;

/// Reads the limit under the check's name: a number, or a table of `at_most` or `at_least`,
/// `around`, `histogram`, `measured`, `rule`, `orders`, `note` and `at`. Missing entries are taken
/// from the table of the same name in `defaults`. Throws InputError, also for a limit that does not
/// follow its rule.
[[nodiscard]] Limit read_limit(const scenes::TableReader& limits,
                               const std::optional<scenes::TableReader>& defaults,
                               const Check& check);

} // namespace dsc::gate
