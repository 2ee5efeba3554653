// SPDX-License-Identifier: MIT
// The limits of figures in a scene file, which `dsc_verify run FILE.toml` checks.
#pragma once

#include "measures/measures.h"
#include "scenes/file/table_reader.h"
#include "scenes/scene.h"

#include <limits>
#include <string>
#include <vector>

namespace dsc::scenes {

/// The allowed range of a figure of a result, bounds included.
struct FigureLimit {
    std::string figure; ///< its name in result files
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::string where{}; ///< file, line and key
};

/// Reads [limits], at least one. Throws InputError for an unknown figure, and for a bound that is
/// not a finite number.
[[nodiscard]] std::vector<FigureLimit> read_limits(const TableReader& reader);

/// The same for these names.
[[nodiscard]] std::vector<FigureLimit> read_limits(const TableReader& reader,
                                                   const std::vector<std::string>& names);

/// Whether it is a figure of a fluid (`RunResult::fluid`), such as `force_x_cylinder_last`.
[[nodiscard]] bool is_figure_of_fluid(const std::string& figure);

/// The reason why a run of this setup does not measure the figure; empty if it does. `is_quick`: do
/// not check whether the exact shape is known half-way, which may take long.
[[nodiscard]] std::string why_missing(const std::string& figure, const Setup& setup,
                                      bool is_quick = false);

/// Throws InputError for a limit of a figure that the run does not measure.
void check_measured(const std::vector<FigureLimit>& limits, const Setup& setup);

} // namespace dsc::scenes
