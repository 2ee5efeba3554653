// SPDX-License-Identifier: MIT
// What the gate checks: each check measures one figure of each of its scenes and compares it with a
// limit. Those of the catalogue's scenes can be made of any other scene, too.
#pragma once

#include "limits.h"
#include "runs.h"

#include "dsc/base/error.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::gate {

/// A figure, and the run that it is of: of several, the worst.
struct Measured {
    double value = 0;
    Configuration run{};
};

/// What to look at where a limit is broken.
enum class Culprit : std::uint8_t {
    none,
    worst_triangle,  ///< of the lowest quality
    sharpest_corner, ///< the smallest angle
    deviation,       ///< the point of the interface or of the exact shape farthest from the other
    turn,            ///< the vertex of the interface that turns too much
    first_failure,   ///< the triangle that is inverted, at the first step that has one
};

/// A run that broke off says nothing about anything else.
class GaveUp : public InvariantError {
public:
    GaveUp(const std::string& reason, Configuration run)
        : InvariantError("the run gave up: " + reason), run_(std::move(run)) {}

    [[nodiscard]] const Configuration& run() const { return run_; }

private:
    Configuration run_;
};

/// The result of a run that did all of its steps. Throws GaveUp, and what the run throws.
[[nodiscard]] const scenes::RunResult& finished(Runs& runs, const Configuration& configuration);

struct Check {
    std::string name;
    std::string description;
    std::string unit;      ///< "1" for a ratio
    bool at_least = false; ///< the limit is a lower one
    std::vector<std::string> scenes;
    std::function<Measured(Runs& runs, const std::string& scene)> measure;
    std::vector<std::string> figures{}; ///< of result files, without which it cannot be made
    Culprit culprit = Culprit::none;
};

/// How a parallel run is compared with the sequential one.
struct Comparison {
    using Difference =
        std::function<double(const scenes::RunResult& one, const scenes::RunResult& other)>;

    std::string name; ///< of the check
    std::string description;
    Difference difference;
    std::vector<std::string> scenes;
    std::vector<std::string> figures{}; ///< as those of Check
};

[[nodiscard]] const std::vector<Comparison>& comparisons();

/// Those that can be made of any scene, in the order of the table.
[[nodiscard]] const std::vector<Check>& scene_checks();

/// All checks of the catalogue: those, and those of accuracy.
[[nodiscard]] const std::vector<Check>& all_checks();

/// Those with these names, or all if none is given. Throws InputError for an unknown name.
[[nodiscard]] std::vector<const Check*> select_checks(const std::vector<const Check*>& checks,
                                                      const std::vector<std::string>& names);

/// A scene to make a check of.
struct Task {
    const Check* check = nullptr;
    std::string scene;
};

/// Throws InputError if the limit of a task is missing.
void check_limits(const std::vector<Task>& tasks, const Limits& limits);

/// Throws InputError if there is a limit that none of these reads, nor a check of the catalogue:
/// then one of the two is misspelt.
void check_all_read(const std::vector<Task>& tasks, const Limits& limits);

/// Where a limit is broken; see place.h.
struct Place {
    std::string what{};                ///< in words; empty if nothing was found
    std::optional<Point<double>> at{}; ///< in units of the domain
    double time = 0;
    std::string picture{}; ///< a file; empty: none
    std::string edits{};   ///< the log of edits that leads there; empty: none
    std::string command{}; ///< makes the run again
};

struct Row {
    const Check* check = nullptr;
    std::string scene;
    std::optional<double> measured;     ///< empty if the run failed
    std::optional<Configuration> run{}; ///< that the figure is of
    double limit = 0;
    bool pass = false;
    std::string failure; ///< what the run threw
    Place place{};       ///< of a limit that is broken
    double seconds = 0;
};

/// Measures one scene and compares the result with its limit. Never throws because of a run.
[[nodiscard]] Row judge(const Check& check, const std::string& scene, const Limits& limits,
                        Runs& runs);

} // namespace dsc::gate
