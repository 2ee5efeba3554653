// SPDX-License-Identifier: MIT
// The flows that error and time are measured in: plain data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dsc::bench {

struct Flow {
    std::string name;            ///< for --flow and file names
    std::string title;           ///< for people
    std::string scene;           ///< of the catalogue
    double duration = 1;         ///< from the first shape to the last
    bool there_and_back = false; ///< the scene's steps are those each way
    double period = 0;           ///< of a reversing field; 0: not set
    /// Time step over edge length: at most so far does the fastest point travel in units of its
    /// speed. With it the errors of time and of the interface shrink together, at fourth and second
    /// order.
    double step_over_length = 1;
    std::vector<double> lengths;   ///< edge lengths, falling
    std::size_t quick_lengths = 2; ///< of these, for --quick; may be none
    /// The last length is only run by methods with `to_the_last`, as all of them would take too
    /// long.
    bool last_by_few = false;
    /// The exact shape is the first polygon, moved: it is different for each edge length.
    bool polygon_is_exact = false;
    /// Without corners, so that a polygon of markers may be read as smooth.
    bool smooth = true;
};

[[nodiscard]] const std::vector<Flow>& precision_flows();

} // namespace dsc::bench
