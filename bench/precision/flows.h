// SPDX-License-Identifier: MIT
// The flows in which error and time are measured: plain data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dsc::bench {

struct Flow {
    std::string name;            ///< for --flow and file names
    std::string title;           ///< for plots
    std::string scene;           ///< of the catalogue
    double duration = 1;         ///< from the first shape to the last
    bool there_and_back = false; ///< whether the scene's steps are counted each way
    double period = 0;           ///< of a flow that turns back; 0: not set
    /// Time step over edge length. With a fixed ratio the errors of time and of the interface fall
    /// together, at fourth and second order.
    double step_over_length = 1;
    std::vector<double> lengths;   ///< edge lengths, descending
    std::size_t quick_lengths = 2; ///< the number of these for --quick; may be 0
    /// Only methods with `to_the_last` run the last length, because all methods would take too
    /// long.
    bool last_by_few = false;
    /// The exact shape is the first polygon, moved rigidly: it depends on the edge length.
    bool polygon_is_exact = false;
    /// The shape has no corners, so a polygon of markers may be read as smooth.
    bool smooth = true;
};

[[nodiscard]] const std::vector<Flow>& precision_flows();

} // namespace dsc::bench
