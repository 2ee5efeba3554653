// SPDX-License-Identifier: MIT
// What the gate checks: each check measures one figure of each of its scenes and compares it with a
// limit.
#pragma once

#include "limits.h"
#include "runs.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::gate {

struct Check {
    std::string name;
    std::string description;
    std::string unit;      ///< "1" for a ratio
    bool at_least = false; ///< the limit is a lower one
    std::vector<std::string> scenes;
    std::function<double(Runs& runs, const std::string& scene)> measure;
};

/// All checks, in the order of the table.
[[nodiscard]] const std::vector<Check>& all_checks();

/// Those with these names, or all if none is given. Throws InputError for an unknown name.
[[nodiscard]] std::vector<const Check*> select_checks(const std::vector<std::string>& names);

/// Throws InputError if a limit of one of the checks is missing, or if the file has one that no
/// check reads: then one of the two is misspelt.
void check_limits(const std::vector<const Check*>& checks, const Limits& limits);

struct Row {
    const Check* check = nullptr;
    std::string scene;
    std::optional<double> measured; ///< empty if the run failed
    double limit = 0;
    bool pass = false;
    std::string failure; ///< what the run threw
    double seconds = 0;
};

/// Measures one scene and compares the result with its limit. Never throws because of a run.
[[nodiscard]] Row judge(const Check& check, const std::string& scene, const Limits& limits,
                        Runs& runs);

} // namespace dsc::gate
