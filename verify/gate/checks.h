// SPDX-License-Identifier: MIT
// The checks of the gate: each measures one figure of a case of a suite.
#pragma once

#include "runs.h"

#include "dsc/base/error.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dsc::gate {

/// The runs from which a figure is computed.
enum class Of : std::uint8_t {
    sequential,     ///< the sequential run
    worst_parallel, ///< the worst of the parallel runs
    all_parallel,   ///< the sum over the parallel runs
    difference,     ///< the largest difference of a parallel run from the sequential one
    reference,      ///< the mean difference from the literal method, over the starts of the case
    threads,        ///< the number of different results for several numbers of threads
};

/// The element shown if a limit is broken.
enum class Culprit : std::uint8_t {
    none,
    worst_triangle,  ///< of the lowest quality
    sharpest_corner, ///< the smallest angle
    deviation,       ///< the point of the interface or of the exact shape farthest from the other
    turn,            ///< the vertex of the interface that turns too much
    first_failure,   ///< the triangle that is inverted, at the first step that has one
};

/// What a limit stores for a check to compare the run with.
enum class Stores : std::uint8_t {
    nothing,
    figure,    ///< `around`: the median figure of the orders
    histogram, ///< `histogram`: the sum of those of the orders
};

/// The group of checks for scenes in three dimensions.
inline constexpr const char* in_space = "space";

struct Check {
    using Result = scenes::RunResult;

    std::string name;
    std::string description{};
    std::string group{}; ///< which --only may name, like the check
    Of of = Of::sequential;
    std::function<double(const Result&)> figure{};
    std::function<double(const Result& one, const Result& base)> difference{};
    scenes::Histogram Result::*histogram = nullptr; ///< in place of a figure; has `bins`
    std::size_t bins = 0;
    Stores stores = Stores::nothing;
    std::vector<std::string> figures{}; ///< figures of result files that the check needs
    Culprit culprit = Culprit::none;
    std::string unit = "1"; ///< "1" for a ratio
    bool at_least = false;  ///< the limit is a lower one

    /// Whether this is the check's name, its group, or one of "parallel", "reference" and
    /// "accuracy" to which it belongs.
    [[nodiscard]] bool is_called(const std::string& name_or_group) const;
};

/// All checks that a suite may name, in the order of the table.
[[nodiscard]] const std::vector<std::shared_ptr<const Check>>& all_checks();

/// Throws InputError, which lists all checks, if there is none of this name.
[[nodiscard]] std::shared_ptr<const Check> find_check(const std::string& name);

/// The check of a figure of result files, for [limits] of scene files.
[[nodiscard]] std::shared_ptr<const Check> check_of_figure(const std::string& figure,
                                                           const std::string& name, bool at_least);
/// The check of a figure in three dimensions.
[[nodiscard]] std::shared_ptr<const Check> check_in_space(const std::string& figure,
                                                          const std::string& name, bool at_least);

/// Why the check cannot be made of this case; empty if it can.
[[nodiscard]] std::string why_not(const Check& check, const Case& of);

/// The runs that the check needs; the others are compared with the first one.
[[nodiscard]] std::vector<Configuration> configurations_of(const Check& check, const Case& of);

/// A figure, and the run from which it comes: the worst of several.
struct Measured {
    double value = 0;
    Configuration run{};
};

/// A run that gave up has no figures.
class GaveUp : public InvariantError {
public:
    GaveUp(const std::string& reason, Configuration run)
        : InvariantError("the run gave up: " + reason), run_(std::move(run)) {}

    [[nodiscard]] const Configuration& run() const { return run_; }

private:
    Configuration run_;
};

/// The result of a run that completed all steps. Throws GaveUp, or the exception of the run.
[[nodiscard]] const scenes::RunResult& finished(const Outcome& outcome);

/// Computes the figure of a check from its runs, which are those of `configurations_of`; if the
/// limit has a figure or histogram to compare with, the difference from that. Throws as `finished`.
[[nodiscard]] Measured measure(const Check& check, const Limit& limit,
                               std::span<const Outcome* const> outcomes);

} // namespace dsc::gate
