// SPDX-License-Identifier: MIT
// A limit of a suite: what a check may measure at most, or at least, and where the figure comes
// from. Limits are written by hand, or by `dsc_verify propose` and then looked at.
#pragma once

#include "scenes/file/table_reader.h"

#include <optional>
#include <string>

namespace dsc::gate {

struct Check;

/// How a limit follows from what was measured.
struct Rule {
    std::string name;
    double least; ///< that the limit may be over the measured figure, or the other way round for
    double most;  ///< one that must be reached; two digits of rounding included
    double factor = 1; ///< by which `propose` makes it; 1: it leaves the limit as it is
};

/// Throws InputError, naming all rules, if there is none of this name.
[[nodiscard]] const Rule& find_rule(const std::string& name);

struct Limit {
    double value = 0;
    std::optional<double> around{};   ///< what is published: the distance to it is limited
    std::optional<double> measured{}; ///< by the run, or the worst of `orders` shuffled ones
    std::string rule = "required";
    int orders = 0; ///< of the interface, in which `measured` was found; 0: the scene's own alone
    std::string note{};
    std::string at{};    ///< commit, day, machine and compiler of the measurement
    std::string where{}; ///< file, line and key
    bool is_own = true;  ///< of the case itself, and not of all cases of a suite

    /// Where the value comes from, in words.
    [[nodiscard]] std::string reason() const;
    /// By how much a figure is worse than `measured`, relative; 0 where that cannot be said, as
    /// among rounding errors.
    [[nodiscard]] double worse_by(double figure, bool at_least) const;
};

/// For people: so many significant digits.
[[nodiscard]] std::string few_digits(double value, int digits = 4);

/// Rounding errors are not compared with each other.
inline constexpr double rounding_error = 1e-12;

/// The limit that stands under the check's name: a number, or a table of `at_most` or `at_least`,
/// `around`, `measured`, `rule`, `orders`, `note` and `at`. What the table leaves out is taken from
/// that of the same name in `defaults`. Throws InputError, also for a limit that does not follow
/// its rule.
[[nodiscard]] Limit read_limit(const scenes::TableReader& limits,
                               const std::optional<scenes::TableReader>& defaults,
                               const Check& check);

} // namespace dsc::gate
