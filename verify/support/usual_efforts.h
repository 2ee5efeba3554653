// SPDX-License-Identifier: MIT
// How many stars a step looks at, for each move of a vertex, and how many passes a vertex goes
// through in a step, in the coarse runs of each scene: as measured, with what other compilers and
// ways to divide may add.
#pragma once

#include <array>
#include <string_view>

namespace dsc::scenes {

struct UsualEffort {
    std::string_view scene;
    double stars;  ///< examined for each move, sequentially
    double passes; ///< of movement and mesh update, for each interface vertex and step
};

/// Over the usual effort, in submeshes as well, and under it.
inline constexpr double most_of_usual = 1.1;
/// Over the usual passes, in submeshes: the slowest of them counts.
inline constexpr double most_passes_in_submeshes = 1.25;

inline constexpr std::array usual_efforts{
    UsualEffort{"translation", 3.51, 1.00},
    UsualEffort{"translation-phase", 1.55, 1.00},
    UsualEffort{"scaling", 4.46, 1.00},
    UsualEffort{"scaling-round", 4.47, 1.00},
    UsualEffort{"rotation-rectangle", 3.11, 1.00},
    UsualEffort{"rotation-crescent", 3.22, 1.00},
    UsualEffort{"vortex-square", 2.28, 1.00},
    UsualEffort{"interpolation", 2.48, 1.00},
    UsualEffort{"zalesak", 3.27, 1.00},
    UsualEffort{"swirl", 2.41, 1.29},
    UsualEffort{"swirl-zalesak", 3.15, 2.01},
    UsualEffort{"single-vortex", 2.86, 1.34},
    UsualEffort{"speedup-scaling", 4.46, 1.00},
    UsualEffort{"speedup-four-circles", 3.53, 1.00},
    UsualEffort{"quality-combinations", 3.29, 1.20},
    UsualEffort{"quality-varying", 5.63, 1.00},
    UsualEffort{"quality-distance", 10.49, 1.34},
    UsualEffort{"curvature-circle", 3.62, 1.00},
    UsualEffort{"curvature-dumbbell", 2.99, 1.22},
    UsualEffort{"grow-shrink", 3.13, 2.97},
    UsualEffort{"erode-dumbbell", 3.18, 2.44},
    UsualEffort{"three-phases", 2.25, 1.00},
    UsualEffort{"t1", 3.08, 1.00},
    UsualEffort{"grains", 2.11, 1.00},
    UsualEffort{"foam", 2.25, 1.00},
    UsualEffort{"drop-and-pool", 2.50, 1.00},
};

} // namespace dsc::scenes
