// SPDX-License-Identifier: MIT
#include "flows.h"

namespace dsc::bench {

const std::vector<Flow>& precision_flows() {
    const std::vector<double> powers{1.0 / 32, 1.0 / 64, 1.0 / 128, 1.0 / 256};
    const std::vector<double> tenths{0.04, 0.02, 0.01, 0.005};
    // Four edge lengths for every method, and a fifth for a few of them.
    const std::vector<double> powers_and_last{1.0 / 32, 1.0 / 64, 1.0 / 96, 1.0 / 128, 1.0 / 256};
    static const std::vector<Flow> flows{
        // The largest speed is 1: a step is one edge length, as for the markers of
        // reference/published/marker_floor.json.
        {.name = "single-vortex-2",
         .title = "single vortex, T = 2",
         .scene = "single-vortex",
         .duration = 2,
         .period = 2,
         .lengths = powers},
        {.name = "single-vortex-8",
         .title = "single vortex, T = 8",
         .scene = "single-vortex",
         .duration = 8,
         .period = 8,
         .lengths = powers_and_last,
         .last_by_few = true},
        // The swirl and its reverse, for two durations: 260 and 420 steps each way at h = 0.01.
        {.name = "swirl-260",
         .title = "swirl, 2 x 260",
         .scene = "swirl",
         .duration = 5.2,
         .there_and_back = true,
         .lengths = {0.04, 0.02, 0.014, 0.01, 0.005},
         .last_by_few = true},
        {.name = "swirl-420",
         .title = "swirl, 2 x 420",
         .scene = "swirl",
         .duration = 8.4,
         .there_and_back = true,
         .lengths = {0.04, 0.02, 0.014, 0.01},
         .quick_lengths = 0},
        // The largest speed is about 3; 628 steps at h = 0.01, as in the literature.
        {.name = "zalesak",
         .title = "Zalesak's disc, one revolution",
         .scene = "zalesak",
         .duration = 1,
         .step_over_length = 1 / 6.28,
         .lengths = tenths,
         .polygon_is_exact = true,
         .smooth = false},
        // The speed is 1.
        {.name = "vortex-square",
         .title = "square twisted and untwisted",
         .scene = "vortex-square",
         .duration = 1,
         .there_and_back = true,
         .step_over_length = 0.5,
         .lengths = tenths,
         .smooth = false},
    };
    return flows;
}

} // namespace dsc::bench
