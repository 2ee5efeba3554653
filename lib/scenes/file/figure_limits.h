// SPDX-License-Identifier: MIT
// What the figures of a scene file have to keep to. `dsc_verify run FILE.toml` judges them.
#pragma once

#include "measures/measures.h"
#include "scenes/file/table_reader.h"
#include "scenes/scene.h"

#include <limits>
#include <string>
#include <vector>

namespace dsc::scenes {

/// What a figure of a result has to keep to; both bounds are allowed.
struct FigureLimit {
    std::string figure; ///< its name in result files
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    std::string where{}; ///< file, line and key
};

/// [limits]: at least one. Throws InputError for a name that no figure has, and for a bound that is
/// not a finite number.
[[nodiscard]] std::vector<FigureLimit> read_limits(const TableReader& reader);

/// The same for these names.
[[nodiscard]] std::vector<FigureLimit> read_limits(const TableReader& reader,
                                                   const std::vector<std::string>& names);

/// Why a run of this setup has no number for the figure; empty if it has one. `is_quick`: without a
/// look at whether the exact shape is known half-way, which may take a while.
[[nodiscard]] std::string why_missing(const std::string& figure, const Setup& setup,
                                      bool is_quick = false);

/// Throws InputError for a limit of a figure that the run has no number for.
void check_measured(const std::vector<FigureLimit>& limits, const Setup& setup);

} // namespace dsc::scenes
