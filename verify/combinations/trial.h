// SPDX-License-Identifier: MIT
// Runs a row and says what does not hold.
#pragma once

#include "combinations/row.h"

#include <string>
#include <vector>

namespace dsc::combinations {

/// In edge lengths.
struct Distance {
    double off = 0;
    double allowed = 0;
};

/// What was found in all runs of a row.
struct Findings {
    std::vector<std::string> problems; ///< none: all holds
    /// From the exact shapes, of the phase that is off most: symmetric difference over the length
    /// of the interface...
    Distance mean;
    Distance farthest; ///< ...and that of the farthest vertex of the interface
};

/// Runs a row with one, two and three threads, the last of them twice (the sequential method:
/// twice), and unbroken where it has an interruption. The row must make sense.
/// Edges are of the usual length over `fineness`.
[[nodiscard]] Findings try_row(const Row& row, double fineness = 1);

/// What the library says to a row that it must refuse; empty if it does not refuse.
[[nodiscard]] std::string refusal_of(const Row& row);

} // namespace dsc::combinations
