// SPDX-License-Identifier: MIT
// What the gate can check: each check measures one figure of a case of a suite.
#pragma once

#include "runs.h"

#include "dsc/base/error.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dsc::gate {

/// Which runs a figure is of.
enum class Of : std::uint8_t {
    sequential,     ///< the sequential run
    worst_parallel, ///< the worst of the parallel runs
    all_parallel,   ///< the sum over the parallel runs
    difference,     ///< the largest difference of a parallel run from the sequential one
    reference,      ///< the mean difference from the literal method, over the starts of the case
    threads,        ///< how many results different numbers of threads give
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

/// The group of checks of scenes in three dimensions.
inline constexpr const char* in_space = "space";

struct Check {
    using Result = scenes::RunResult;

    std::string name;
    std::string description{};
    std::string group{}; ///< what --only may name beside the check
    Of of = Of::sequential;
    std::function<double(const Result&)> figure{};
    std::function<double(const Result& one, const Result& base)> difference{};
    std::vector<std::string> figures{}; ///< of result files, without which it cannot be made
    Culprit culprit = Culprit::none;
    std::string unit = "1"; ///< "1" for a ratio
    bool at_least = false;  ///< the limit is a lower one

    /// By its name, its group, or as one of "parallel", "reference" and "accuracy".
    [[nodiscard]] bool is_called(const std::string& name_or_group) const;
};

/// All that a suite may name, in the order of the table.
[[nodiscard]] const std::vector<std::shared_ptr<const Check>>& all_checks();

/// Throws InputError, naming all checks, if there is none of this name.
[[nodiscard]] std::shared_ptr<const Check> find_check(const std::string& name);

/// The check of a figure of result files, for [limits] of scene files.
[[nodiscard]] std::shared_ptr<const Check> check_of_figure(const std::string& figure,
                                                           const std::string& name, bool at_least);
/// The same in three dimensions.
[[nodiscard]] std::shared_ptr<const Check> check_in_space(const std::string& figure,
                                                          const std::string& name, bool at_least);

/// Why the check cannot be made of this case; empty if it can.
[[nodiscard]] std::string why_not(const Check& check, const Case& of);

/// The runs that the check looks at; the first is the one that others are compared with.
[[nodiscard]] std::vector<Configuration> configurations_of(const Check& check, const Case& of);

/// A figure, and the run that it is of: of several, the worst.
struct Measured {
    double value = 0;
    Configuration run{};
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

/// The result of a run that did all of its steps. Throws GaveUp, and what the run threw.
[[nodiscard]] const scenes::RunResult& finished(const Outcome& outcome);

/// What the check makes of its runs, which are those of `configurations_of`. Throws what `finished`
/// throws.
[[nodiscard]] Measured measure(const Check& check, std::span<const Outcome* const> outcomes);

} // namespace dsc::gate
