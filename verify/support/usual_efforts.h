// SPDX-License-Identifier: MIT
// How many stars a step looks at, for each move of a vertex, in the coarse runs of each scene: as
// measured, with what other compilers and ways to divide may add.
#pragma once

#include <array>
#include <string_view>

namespace dsc::scenes {

struct UsualEffort {
    std::string_view scene;
    double stars; ///< examined for each move, sequentially
};

/// Over the usual effort, in submeshes as well, and under it.
inline constexpr double most_of_usual = 1.1;

inline constexpr std::array usual_efforts{
    UsualEffort{"translation", 3.51},
    UsualEffort{"translation-phase", 1.55},
    UsualEffort{"scaling", 4.46},
    UsualEffort{"scaling-round", 4.47},
    UsualEffort{"rotation-rectangle", 3.11},
    UsualEffort{"rotation-crescent", 3.22},
    UsualEffort{"vortex-square", 2.28},
    UsualEffort{"interpolation", 2.48},
    UsualEffort{"zalesak", 3.27},
    UsualEffort{"swirl", 2.41},
    UsualEffort{"swirl-zalesak", 3.15},
    UsualEffort{"single-vortex", 2.86},
    UsualEffort{"speedup-scaling", 4.46},
    UsualEffort{"speedup-four-circles", 3.53},
    UsualEffort{"quality-combinations", 3.29},
    UsualEffort{"quality-varying", 5.63},
    UsualEffort{"quality-distance", 10.49},
    UsualEffort{"curvature-circle", 3.62},
    UsualEffort{"curvature-dumbbell", 2.99},
    UsualEffort{"grow-shrink", 3.13},
    UsualEffort{"erode-dumbbell", 3.54},
    UsualEffort{"three-phases", 2.25},
    UsualEffort{"t1", 3.08},
    UsualEffort{"grains", 2.11},
    UsualEffort{"foam", 2.25},
    UsualEffort{"drop-and-pool", 2.50},
};

} // namespace dsc::scenes
